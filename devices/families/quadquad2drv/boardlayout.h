// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/turns.h"
#include "families/quadquad2drv/packetport.h"
#include "families/quadquad2drv/parameters.h"
#include "telemetry/framerate.h"

#include <functional>
#include <utility>

namespace mb::quadquad2drv {

/// What a board is told to tell: the data masks of its axes, the stream and its period. Finding the start-up masks again means
/// that it was reset, with all that it had been told (README.md#reset). Engine thread; outlives its tasks.
class BoardLayout {
public:
    struct Owner {
        std::function<bool()> holdsSettings; ///< the profile says that something was written
        std::function<void()> reset;         ///< the board was: forget() has been called
        std::function<void()> streamChanged; ///< another period
    };

    BoardLayout(SpiLink &link, PacketPort &port, Clock &clock, Owner owner);

    /// Replies must fit the masks exactly, so these are read before anything is understood.
    [[nodiscard]] Task<void> read();
    /// Whole positions, velocity and status of every axis. Unsafe when the board was reset before: afterwards that could not be
    /// seen any more.
    [[nodiscard]] Task<void> tellEverything();
    /// Looks for a reset.
    [[nodiscard]] Task<void> check(int tries = 1);
    /// One rate for the whole board; the period is a multiple of 40.96 µs, at least one pass of the loop (README.md#ready-line). With the
    /// last wish ends what the first one began. Yields whether the stream is another. Unsupported without a ready line.
    [[nodiscard]] Task<bool> setRate(ChannelIndex channel, double hertz);
    /// What setRate() was asked for, once more. Yields whether the stream is another.
    [[nodiscard]] Task<bool> resumeRate();
    /// A reset has ended a rate that is still wished for, or nobody answered when one was set or put back; once.
    [[nodiscard]] bool takeOwedRate() { return std::exchange(m_rateOwed, false); }

    /// A parameter that was written; period and configuration of the stream are what the last wish goes back to.
    void chosen(ParameterIndex index, std::int64_t raw);

    /// Of every axis.
    [[nodiscard]] bool tellsEverything() const;
    /// Units of 40.96 µs; 0: it does not stream.
    [[nodiscard]] std::uint16_t streamPeriod() const { return m_streamPeriod; }
    /// The board is told something that a reset undoes.
    void noteChange() { m_changed = m_holds = true; }
    /// A reset may have come, or whether one came before this program did is not known.
    [[nodiscard]] bool isInDoubt(bool heard) const { return m_changed || (heard && !m_resetKnown); }
    [[nodiscard]] bool isResetKnown() const { return m_resetKnown; }
    [[nodiscard]] bool hasRestarted() const { return m_restarted; }
    /// What a reset took was read again.
    void refreshed() { m_restarted = false; }
    /// The board is as it starts up.
    void forget();
    /// How often it was found to be.
    [[nodiscard]] std::uint64_t resets() const { return m_resets; }

private:
    struct Stream {
        DataMasks masks;
        std::uint8_t config = 0;
        std::uint16_t period = 0;
    };
    void detectReset(const DataMasks &masks);
    [[nodiscard]] Task<void> expectNoReset();
    [[nodiscard]] Task<bool> followWishes();
    [[nodiscard]] Task<void> begin(std::uint16_t period);
    [[nodiscard]] Task<void> putBack();
    [[nodiscard]] Task<void> putMasksBack(DataMasks before);

    SpiLink &m_link;
    PacketPort &m_port;
    Owner m_owner;
    Turns m_rateTurns; ///< one rate at a time
    FrameRate m_wishes;
    bool m_rateOwed = false;
    std::uint16_t m_streamPeriod = 0;
    std::optional<Stream> m_before; ///< what the stream of ours replaced
    bool m_holds = false;           ///< what a reset undoes, and is not of the stream
    bool m_changed = false;         ///< we told the board something that a reset undoes
    bool m_resetKnown = false;      ///< whether the board was reset before we came is known
    bool m_restarted = false;
    std::uint64_t m_resets = 0;
};

} // namespace mb::quadquad2drv
