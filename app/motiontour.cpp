// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/motiontour.h"

#include "widgets/control/tunepage.h"
#include "widgets/plots/plotspage.h"
#include "widgets/plots/triggerbar.h"

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds driveAgain{500};
constexpr std::chrono::milliseconds afterPaint{1200};
constexpr double stepTarget = 60000.0;   ///< counts/s
constexpr double triggerLevel = 30000.0; ///< counts/s

} // namespace

void MotionTour::plan()
{
    planStep();
    show(PageId::Plots, "plots", 1500ms);
    planCursors();
    planTrigger();
    planViews();
    show(PageId::Overview, "overview-live", 2000ms);
    show(PageId::Bus, "bus", 1000ms);
    m_stage.add(
        "stop", [this] { m_stage.stopAll(); }, [this] { return !unit()->liveness.moving; });
    m_stage.picture("stopped");
}

void MotionTour::planStep()
{
    m_stage.act("live", [this] {
        m_stage.window().selection().select(unit()->id);
        m_stage.page<TunePage>(PageId::Tune).showLive(true);
    });
    m_stage.arm("arm", [this] { return unit(); });
    m_stage.pause(1000ms);
    m_stage.wait("velocity step", [this] { return comesToSpeed(); });
    m_stage.picture("tune-live", 1500ms);
}

/// A page while the motor turns.
void MotionTour::show(PageId page, const char *name, std::chrono::milliseconds time)
{
    m_stage.add(
        name, [this, page] { m_stage.window().showPage(page); }, [this] { return comesToSpeed(); });
    m_stage.picture(name, time);
}

void MotionTour::drive()
{
    Arming &arming = m_stage.window().arming();
    if (arming.isMoving() || m_stage.workbench().now() - m_drivenAt < driveAgain)
        return;
    m_drivenAt = m_stage.workbench().now();
    arming.arm(unit()->id);
    SetPoint setPoint;
    setPoint.mode = Mode::Velocity;
    setPoint.target = stepTarget;
    arming.run(setPoint);
}

/// A picture, or a busy computer, may have outlasted the motion lease: then it is driven anew.
bool MotionTour::comesToSpeed()
{
    drive();
    const auto last = unit()->telemetry->last(*unit()->telemetry->find("velocity"));
    return last && last->value > 0.95 * stepTarget;
}

void MotionTour::onPlots(const char *name, std::function<void(PlotsPage &)> act)
{
    m_stage.act(name, [this, act = std::move(act)] { act(m_stage.page<PlotsPage>(PageId::Plots)); });
}

void MotionTour::addSignals(PlotsPage &page)
{
    const DeviceView &other = *m_stage.device(&DemoUnits::overshooting);
    page.addSignal({other.id, *other.telemetry->find("velocity")});
    const Signal velocity{unit()->id, *unit()->telemetry->find("velocity")};
    for (const SignalBook::Variable &variable : page.board().book().variables()) {
        if (variable.signal == velocity)
            (void)page.board().addDerived(
                tr("acceleration"), tr("counts/s²"), QStringLiteral("average(derivative(%1), 0.1)").arg(variable.name));
    }
    const int last = page.board().traces().back().id;
    page.board().moveToPane(last, page.board().paneOf(0));
    page.board().setSecondAxis(page.board().traces().back().id, true);
}

/// Several devices, a derived signal on a second axis.
void MotionTour::planCursors()
{
    onPlots("several devices", [this](PlotsPage &page) { addSignals(page); });
    m_stage.pause(afterPaint);
    onPlots("cursors", [](PlotsPage &page) {
        const auto [from, to] = page.stack().view().range();
        page.stack().setCursorsShown(true);
        page.stack().setCursorKeys(from + (to - from) * 0.55, from + (to - from) * 0.8);
        page.board().addNote(to - 1.5, tr("at speed"));
    });
    m_stage.picture("plots-cursors", 300ms);
}

/// A reference beside a triggered event.
void MotionTour::planTrigger()
{
    onPlots("trigger", [this](PlotsPage &page) {
        page.stack().setCursorsShown(false);
        m_stage.stopAll();
    });
    m_stage.pause(2000ms);
    onPlots("arm the trigger", [](PlotsPage &page) {
        page.stack().view().setWindow(2.0);
        page.board().keepReferences();
        page.trigger().bar().setLevel(triggerLevel);
        page.trigger().armOn(page.board().traces().front().id);
    });
    m_stage.add(
        "event", [this] { drive(); },
        [this] { return m_stage.page<PlotsPage>(PageId::Plots).trigger().watch().event().has_value(); });
    m_stage.picture("plots-trigger", 2000ms);
}

/// Spectrum, and one signal against another.
void MotionTour::planViews()
{
    onPlots("spectrum", [](PlotsPage &page) {
        page.trigger().disarm();
        page.stack().view().setWindow(10.0);
        page.showView(PlotsPage::View::Spectrum);
    });
    m_stage.picture("plots-spectrum", afterPaint);
    onPlots("against", [](PlotsPage &page) { page.showView(PlotsPage::View::Against); });
    m_stage.picture("plots-xy", afterPaint);
    onPlots("time", [](PlotsPage &page) { page.showView(PlotsPage::View::Time); });
}

} // namespace mb
