// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "async/wallclock.h"
#include "model/snapshot.h"
#include "recording/mcapformat.h"

#include <functional>

namespace mb {

/// One channel of a file.
struct ExportChannel {
    std::shared_ptr<const Telemetry> telemetry;
    ChannelIndex channel;
    std::string device; ///< selector, empty for a derived signal
    std::string family;
    std::string key; ///< velocity, ch1.position …; for a derived signal its name
    std::string unit;
    std::string formula; ///< of a derived signal
    bool simulated = false;
    std::string serial{}; ///< of the unit; empty where it tells none

    friend bool operator==(const ExportChannel &, const ExportChannel &) = default;
    /// "dmc60c:5 velocity": what stands over a column.
    [[nodiscard]] std::string title() const;
    /// "/sim_can/dmc60c_5/velocity"
    [[nodiscard]] std::string topic() const;
};

/// A note of the user at a time.
struct TimedNote {
    Instant time{};
    std::string text;
    friend bool operator==(const TimedNote &, const TimedNote &) = default;
};

/// What shall be written.
struct ExportPlan {
    std::vector<ExportChannel> channels;
    Instant from{};
    Instant to{};
    WallClock clock;
    std::vector<std::pair<std::string, mcap::Map>> about; ///< of devices: see describe()
    std::vector<TimedNote> notes;
};

struct ExportReport {
    std::uint64_t samples = 0;
    std::uint64_t lost = 0; ///< known missing among them
};

/// Called now and then with 0 … 1; false ends the job.
using ExportProgress = std::function<bool(double)>;

/// All channels of a device.
[[nodiscard]] std::vector<ExportChannel> channelsOf(const DeviceView &device, bool simulated);
/// Identity and parameters of a device, as they are now: "device SELECTOR SERIAL", "parameters SELECTOR SERIAL"; without a serial
/// number the selector alone.
[[nodiscard]] std::vector<std::pair<std::string, mcap::Map>> describe(const DeviceView &device);
/// "loss SELECTOR" with each channel's samples known missing in the stretch: "84 of 1700".
[[nodiscard]] std::map<std::string, mcap::Map> lossOf(const ExportPlan &plan);

} // namespace mb
