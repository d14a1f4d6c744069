// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/exportmatter.h"

#include "widgets/plots/plotboard.h"

#include <iterator>

namespace mb {
namespace {

ExportChannel derivedChannel(const SignalBook::Derived &derived)
{
    return {derived.signal->telemetry(), {0}, {}, {}, derived.name.toStdString(), derived.unit.toStdString(),
        derived.formula.toStdString(), false};
}

std::vector<ExportChannel> channelsHere(const Snapshot &snapshot, const DeviceView &device)
{
    const LinkView *link = snapshot.link(device.link);
    return channelsOf(device, link && link->simulated);
}

} // namespace

std::vector<ExportChannel> exportChannels(const Snapshot &snapshot, const PlotBoard &board, bool everything)
{
    std::vector<ExportChannel> channels;
    if (everything) {
        for (const DeviceView &device : snapshot.devices) {
            const auto all = channelsHere(snapshot, device);
            channels.insert(channels.end(), all.begin(), all.end());
        }
        for (const SignalBook::Derived &derived : board.book().derived()) {
            if (derived.signal)
                channels.push_back(derivedChannel(derived));
        }
        return channels;
    }
    for (const PlotBoard::Trace &trace : board.traces()) {
        if (const DeviceView *device = snapshot.device(trace.signal.device))
            channels.push_back(channelsHere(snapshot, *device).at(trace.signal.channel.value));
        else if (const auto *derived = board.book().derivedOf(trace.signal))
            channels.push_back(derivedChannel(*derived));
    }
    return channels;
}

std::vector<std::pair<std::string, mcap::Map>> aboutDevices(const Snapshot &snapshot)
{
    std::vector<std::pair<std::string, mcap::Map>> facts;
    for (const DeviceView &device : snapshot.devices) {
        auto described = describe(device);
        std::move(described.begin(), described.end(), std::back_inserter(facts));
    }
    return facts;
}

} // namespace mb
