// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"

#include <string>
#include <vector>

namespace mb::console {

/// Prints the samples of one device as they come, from its construction on, and counts them: CSV with a header, or
/// JSON.
class SampleStream {
public:
    /// No channels: all of them.
    SampleStream(Console &console, Device &device, std::vector<ChannelIndex> channels);

    [[nodiscard]] std::uint64_t count() const { return m_count; }
    /// Samples known missing, and frames that the link knows missing.
    [[nodiscard]] std::uint64_t lost() const;

private:
    void print(const Sample &sample);
    [[nodiscard]] std::uint64_t lostSoFar() const;

    Console &m_console;
    Device &m_device;
    TimeOrigin m_time;
    Instant m_start; ///< what was measured before is not part of it
    std::vector<bool> m_chosen;
    std::uint64_t m_count = 0;
    std::uint64_t m_lostBefore = 0;
    Subscription m_samples;
};

/// OutOfRange for a channel that the family has not.
[[nodiscard]] Result<std::vector<ChannelIndex>> parseChannels(
    const Family &family, const std::vector<std::string> &names);

} // namespace mb::console
