// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/loadrecording.h"
#include "support/timers.h"
#include "support/utf8.h"
#include "tunebench.h"
#include "widgets/common/segmented.h"
#include "widgets/plots/curveplot.h"
#include "widgets/plots/exportbar.h"
#include "widgets/plots/plotdialogs.h"
#include "widgets/plots/plotscrubber.h"
#include "widgets/plots/plotspage.h"
#include "widgets/plots/recorder.h"
#include "widgets/plots/tracelist.h"
#include "widgets/plots/tracepanel.h"
#include "widgets/plots/triggerbar.h"

#include <QApplication>
#include <QDropEvent>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace mb::test {

using namespace std::chrono_literals;

inline ChannelIndex channel(const char *key)
{
    return *findChannel(dmc60c().channels, key);
}

/// A page with two drives that record.
struct PlotBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{darkTheme()};
    Recording recording{workbench.time};
    Recording other{workbench.time};
    std::unique_ptr<PlotsPage> page;

    PlotBench()
    {
        workbench.shot.devices.push_back(tunableDrive(recording.telemetry(), 1, 5));
        workbench.shot.devices.push_back(tunableDrive(other.telemetry(), 2, 7));
        workbench.shot.devices[0].selector = "sim:can/dmc60c:5";
        workbench.shot.devices[1].selector = "sim:can/dmc60c:7";
        selection.select({1});
        open();
    }
    void open()
    {
        page = std::make_unique<PlotsPage>(workbench, selection, theme, nullptr);
        page->resize(1208, 760);
        page->show();
    }
    void pass(double seconds, double velocity)
    {
        recording.run(seconds, velocity);
        other.run(seconds, -velocity);
        workbench.time = recording.now();
        workbench.publish();
        passTimers(16ms, 4); // some ticks of the page
    }
    [[nodiscard]] PlotBoard &board() const { return page->board(); }
    [[nodiscard]] PlotStack &stack() const { return page->stack(); }
    [[nodiscard]] const PlotBoard::Trace &trace(const char *name) const
    {
        const auto &traces = board().traces();
        const auto found = std::find_if(
            traces.begin(), traces.end(), [&](const PlotBoard::Trace &t) { return t.style.name == s(name); });
        if (found == traces.end())
            qFatal("no trace %s", name);
        return *found;
    }
    void drop(const Signal &signal, const QPoint &at) const
    {
        QMimeData data;
        data.setData(QLatin1String(signalMimeType), toMime({signal}));
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&stack(), &enter);
        QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&stack(), &event);
    }
};

} // namespace mb::test
