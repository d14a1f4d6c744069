// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "families/dmc60c/codec.h"
#include "transport/caninbox.h"

namespace mb::dmc60c {

/// Reads and writes parameters of one device, README.md#parameters: one request in flight, answers matched by device and
/// parameter. A lost frame costs four measured round trips, not the 250 ms of a device that nobody has heard yet; each
/// further try waits twice as long, because the processor of the device stands for up to 54 ms while its flash is
/// written. Must outlive its tasks, as must the link and the clock.
class ParameterExchange {
public:
    static constexpr int tries = 8;

    ParameterExchange(CanLink &link, Clock &clock)
        : m_link(link)
        , m_clock(clock)
    {
    }

    struct Target {
        int device = 0;
        std::uint16_t session = 0;
    };
    /// Any answer is a success here, refusals included: check() judges them. Timeout after the last try.
    [[nodiscard]] Task<ParamResponse> get(Target target, std::uint8_t parameter);
    /// A write that is repeated when its answer is lost: not for counters.
    [[nodiscard]] Task<ParamResponse> set(Target target, std::uint8_t parameter, std::uint32_t field);
    /// A write that is sent once.
    [[nodiscard]] Task<ParamResponse> setOnce(Target target, std::uint8_t parameter, std::uint32_t field);

    /// Time the next first try waits for its answer.
    [[nodiscard]] Duration patience() const { return patienceAt(0); }

private:
    [[nodiscard]] Task<ParamResponse> run(CanFrame request, int device, std::uint8_t parameter, int most);
    [[nodiscard]] Duration patienceAt(int attempt) const;
    void measured(Duration roundTrip);

    CanLink &m_link;
    Clock &m_clock;
    std::optional<Duration> m_roundTrip;
};

/// Success, or what the device objected to.
[[nodiscard]] Result<void> check(const ParamResponse &response, std::string_view key);

} // namespace mb::dmc60c
