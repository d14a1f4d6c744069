// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/dmc60c/codec.h"

#include <array>
#include <optional>

namespace mb::dmc60c {

/// The faults that no status frame tells (README.md#hidden-faults): over-current and communication. The device is asked once a second, which
/// clears none. A fault is told while the device says that it is present, and for the three seconds after its counter rose:
/// so long the output is held off (README.md#stopping), while the cause is over with the current that it was.
class FaultWatch {
public:
    static constexpr std::array questions{param::activeFaults, param::overCurrentCount, param::communicationCount};

    /// It is time to ask; the next time is a second later.
    [[nodiscard]] bool isDue(Instant now);
    void take(const ParamResponse &response, Instant now);
    /// The device is silent.
    void forget() { *this = FaultWatch(); }
    /// Of faultbit: overCurrent, communication.
    [[nodiscard]] std::uint32_t present(Instant now) const;

private:
    struct Counter {
        std::optional<std::uint32_t> count;
        std::optional<Instant> roseAt;

        void take(std::uint32_t now, Instant at);
        [[nodiscard]] bool isFresh(Instant now) const;
    };
    Counter m_overCurrent;
    Counter m_communication;
    std::uint32_t m_active = 0;
    Instant m_askedAt{};
};

} // namespace mb::dmc60c
