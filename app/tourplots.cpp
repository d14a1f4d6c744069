// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour.h"

#include "widgets/plots/plotspage.h"
#include "widgets/plots/triggerbar.h"

namespace mb {
namespace {

constexpr std::chrono::milliseconds afterPaint{1200};
constexpr auto other = &DemoUnits::overshooting;
constexpr double triggerLevel = 30000.0; // counts/s

PlotsPage &plotsOf(MainWindow &window)
{
    return *qobject_cast<PlotsPage *>(window.page(PageId::Plots));
}

const PlotBoard::Trace &velocityOf(PlotsPage &page)
{
    return page.board().traces().front();
}

} // namespace

/// Every state of the plots page: several devices with cursors, a derived signal on a second axis, a reference beside a
/// triggered event, spectrum, one signal against another.
void Tour::planPlots()
{
    const auto act = [this](const char *name, std::function<void(PlotsPage &)> what) {
        add(
            QString::fromLatin1(name), [this, what] { what(plotsOf(m_window)); }, [] { return true; });
    };
    act("several devices", [this](PlotsPage &page) {
        page.addSignal({device(other)->id, *device(other)->telemetry->find("velocity")});
        (void)page.board().addDerived(tr("acceleration"), tr("counts/s²"),
            QStringLiteral("average(derivative(d%1_velocity), 0.1)").arg(device(&DemoUnits::tuned)->identity.address));
        const int last = page.board().traces().back().id;
        page.board().moveToPane(last, page.board().paneOf(0));
        page.board().setSecondAxis(page.board().traces().back().id, true);
    });
    pause(afterPaint);
    act("cursors", [this](PlotsPage &page) {
        const auto [from, to] = page.stack().view().range();
        page.stack().setCursorsShown(true);
        page.stack().setCursorKeys(from + (to - from) * 0.55, from + (to - from) * 0.8);
        page.board().addNote(to - 1.5, tr("at speed"));
    });
    pause(std::chrono::milliseconds(300));
    picture(QStringLiteral("plots-cursors"));
    act("trigger", [this](PlotsPage &page) {
        page.stack().setCursorsShown(false);
        m_window.arming().stopAll(tr("tour"));
    });
    pause(std::chrono::milliseconds(2000));
    act("arm the trigger", [](PlotsPage &page) {
        page.stack().view().setWindow(2.0);
        page.board().keepReferences();
        page.trigger().bar().setLevel(triggerLevel);
        page.trigger().armOn(velocityOf(page).id);
    });
    add(
        QStringLiteral("event"), [this] { drive(); },
        [this] { return plotsOf(m_window).trigger().watch().event().has_value(); });
    pause(std::chrono::milliseconds(2000));
    picture(QStringLiteral("plots-trigger"));
    act("spectrum", [](PlotsPage &page) {
        page.trigger().disarm();
        page.stack().view().setWindow(10.0);
        page.showView(PlotsPage::View::Spectrum);
    });
    pause(afterPaint);
    picture(QStringLiteral("plots-spectrum"));
    act("against", [](PlotsPage &page) { page.showView(PlotsPage::View::Against); });
    pause(afterPaint);
    picture(QStringLiteral("plots-xy"));
    act("time", [](PlotsPage &page) { page.showView(PlotsPage::View::Time); });
}

} // namespace mb
