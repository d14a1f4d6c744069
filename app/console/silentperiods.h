// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "telemetry/channel.h"

#include <functional>
#include <vector>

namespace mb::console {

/// Samples that a unit has not sent because it fell silent: of every channel that came evenly before, one a period from its
/// last sample on. `counted` is what its family counts as lost by itself, which is not counted twice.
class SilentPeriods {
public:
    using Counted = std::function<std::uint64_t(ChannelIndex)>;

    SilentPeriods(std::size_t channels, Counted counted);

    void sample(ChannelIndex channel, Instant time);
    /// Whether the unit is heard. Silence begins with the last sample of each channel, and ends with its next one.
    void setHeard(bool heard);
    /// Until now.
    [[nodiscard]] std::uint64_t missed(Instant now) const;

private:
    static constexpr int window = 8; ///< periods that the next one is judged by

    struct Row {
        Instant last{};
        Duration period{}; ///< zero until two samples came evenly
        int intervals = 0;
        std::uint64_t countedThen = 0; ///< at its last sample
        bool silent = false;
    };
    [[nodiscard]] std::uint64_t missedBy(const Row &row, ChannelIndex channel, std::int64_t periods) const;
    static void learn(Row &row, Duration interval);

    Counted m_counted;
    std::vector<Row> m_rows;
    std::uint64_t m_missed = 0; ///< of silences that are over
};

} // namespace mb::console
