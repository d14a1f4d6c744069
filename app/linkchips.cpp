// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/linkchips.h"

#include "widgets/common/demostripe.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/headerbar.h"
#include "widgets/common/linkload.h"
#include "widgets/common/losses.h"
#include "widgets/common/numberformat.h"
#include "widgets/monitor/recordstrip.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>

namespace mb {
namespace {

LinkStatus chipOf(const LinkView &link, const Snapshot &shot)
{
    LinkStatus chip;
    chip.name = qt(link.name);
    chip.address = qt(link.address);
    const bool open = link.state == LinkState::Open;
    chip.healthy = open && link.counters.lost == 0 && link.diagnosis.isHealthy();
    chip.state = open ? chip.healthy ? GlyphState::Online : GlyphState::Warning : GlyphState::Fault;
    if (!open)
        chip.word = QCoreApplication::translate("mb::MainWindow", "lost");
    else
        chip.load = loadOf(link);
    chip.lost = static_cast<qint64>(samplesOn(shot, link.address).lost);
    const QString counts = link.kind == LinkKind::Can
        ? QCoreApplication::translate("mb::MainWindow", "%1: %2 frames received, %3 sent, %4 dropped, %5 errors")
        : QCoreApplication::translate("mb::MainWindow", "%1: %2 bytes received, %3 sent, %4 dropped, %5 errors");
    chip.tooltip = open ? counts.arg(chip.name)
                              .arg(link.counters.rx)
                              .arg(link.counters.tx)
                              .arg(link.counters.lost)
                              .arg(link.counters.errors)
                        : messageText(link.reason);
    if (!link.diagnosis.isHealthy())
        chip.tooltip = messageText(link.diagnosis.message()) + QLatin1Char('\n') + chip.tooltip;
    return chip;
}

/// Of the recording of frames that runs longest; empty when none does.
QString recordingTime(const Snapshot &shot)
{
    std::optional<Instant> since;
    for (const LinkView &link : shot.links) {
        if (link.recording && isRunning(*link.recording))
            since = std::min(since.value_or(Instant::max()), link.recording->since);
    }
    if (!since)
        return {};
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(shot.time - *since).count();
    return QCoreApplication::translate("mb::MainWindow", "REC %1").arg(formatClock(std::max<qint64>(seconds, 0)));
}

} // namespace

void showLinks(HeaderBar &header, DemoStripe &stripe, const Snapshot &shot)
{
    std::vector<LinkStatus> chips;
    bool simulated = false;
    QStringList recordings;
    for (const LinkView &link : shot.links) {
        chips.push_back(chipOf(link, shot));
        simulated = simulated || link.simulated;
        if (link.replay)
            recordings += qt(link.name);
    }
    header.setLinks(chips);
    header.setRecording(recordingTime(shot));
    stripe.setSources(
        simulated ? QCoreApplication::translate("mb::MainWindow", "simulated bench") : QString(), recordings);
}

} // namespace mb
