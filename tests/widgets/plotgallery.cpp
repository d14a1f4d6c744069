// SPDX-License-Identifier: GPL-3.0-or-later
// plotgallery DIR: every state of the page Plots, in both themes, at 1280×800, at 3840×2160, and at 200 % font.
#include "plotbench.h"
#include "widgets/common/applytheme.h"

#include <QDir>

using namespace mb;
using namespace mb::test;

namespace {

struct Look {
    QString name;
    bool dark = true;
    double points = 10.0;
    QSize size;
};

/// The states follow each other on one page, as a user would come to them.
class Gallery {
public:
    Gallery(const Look &look, const QString &folder)
        : m_look(look)
        , m_folder(folder)
    {
        const Theme theme = look.dark ? darkTheme(look.points) : lightTheme(look.points);
        applyTheme(*qApp, theme);
        m_bench.page.reset();
        m_bench.theme.setTheme(theme);
        m_bench.open();
        m_bench.page->resize(look.size);
    }

    void run()
    {
        emptyPage();
        live();
        loss();
        cursors();
        manyPanes();
        triggered();
        otherViews();
    }

private:
    void picture(const char *state)
    {
        m_bench.workbench.publish();
        QTest::qWait(150);
        m_bench.page->grab().save(m_folder + s("/%1-%2.png").arg(m_look.name, s(state)));
    }

    void emptyPage()
    {
        const auto shown = m_bench.workbench.shot.devices;
        m_bench.workbench.shot.devices.clear();
        m_bench.selection.select({});
        picture("empty");
        m_bench.workbench.shot.devices = shown;
        m_bench.workbench.publish();
        m_bench.selection.select({1});
    }

    void live()
    {
        m_bench.recording.setCommanded(true);
        for (const char *name : {"velocity", "setpoint", "current"})
            m_bench.page->addSignal({{1}, channel(name)});
        m_bench.pass(2, 0);
        m_bench.pass(3, 32'000);
        m_bench.pass(2, 60'000);
        picture("live");
    }

    void loss()
    {
        for (const char *name : {"velocity", "current"})
            m_bench.recording.telemetry()->lost(channel(name), 84);
        m_bench.recording.skip(0.9);
        m_bench.other.skip(0.9);
        m_bench.pass(3, 40'000);
        picture("loss");
        m_bench.stack().view().setLive(false);
        picture("paused");
        m_bench.stack().view().setLive(true);
    }

    void cursors()
    {
        const auto [from, to] = m_bench.stack().view().range();
        m_bench.stack().setCursorsShown(true);
        m_bench.stack().setCursorKeys(from + (to - from) * 0.3, from + (to - from) * 0.5);
        m_bench.board().addNote(to - 2.0, s("load pulse by hand"));
        picture("cursors");
        m_bench.stack().setCursorsShown(false);
    }

    void manyPanes()
    {
        m_bench.page->addSignal({{2}, channel("velocity")});
        m_bench.page->addSignal({{2}, channel("bus_voltage")});
        (void)m_bench.board().addDerived(s("acceleration"), s("counts/s²"), s("average(derivative(d5_velocity), 0.1)"));
        const int last = m_bench.board().traces().back().id;
        m_bench.board().moveToPane(last, m_bench.board().paneOf(0));
        m_bench.board().setSecondAxis(m_bench.board().traces().back().id, true);
        m_bench.pass(2, 20'000);
        picture("derived");
    }

    void triggered()
    {
        m_bench.board().keepReferences();
        m_bench.page->trigger().bar().setLevel(30'000.0);
        m_bench.page->trigger().armOn(m_bench.board().traces().front().id); // its velocity
        picture("armed");
        m_bench.pass(3, 55'000);
        m_bench.pass(6, 55'000);
        picture("trigger");
        m_bench.page->trigger().disarm();
    }

    void otherViews()
    {
        m_bench.page->showView(PlotsPage::View::Spectrum);
        picture("spectrum");
        m_bench.page->showView(PlotsPage::View::Against);
        picture("xy");
    }

    Look m_look;
    QString m_folder;
    PlotBench m_bench;
};

} // namespace

int main(int argc, char **argv)
{
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    const QString folder = argc > 1 ? QString::fromLocal8Bit(argv[1]) : s("plotgallery");
    QDir().mkpath(folder);
    const QSize usual(1208, 690); // what a window of 1280×800 leaves for a page
    const QSize large(3400, 2040);
    for (const Look &look :
        {Look{s("dark"), true, 10, usual}, Look{s("light"), false, 10, usual}, Look{s("dark-4k"), true, 10, large},
            Look{s("light-4k-200"), false, 20, large}, Look{s("dark-200"), true, 20, usual}}) {
        QFont font = QApplication::font();
        font.setPointSizeF(look.points);
        QApplication::setFont(font);
        Gallery(look, folder).run();
    }
    return 0;
}
