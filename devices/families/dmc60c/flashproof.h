// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/protocol.h"

#include "async/clock.h"

#include <optional>

namespace mb::dmc60c {

/// Decides when written parameters are proved to be in flash. There is no "save": the device writes its flash at once
/// if nothing changed in the last 15 s, and otherwise 15 s after the last change; each flash write advances the
/// sequence number by one. A number that advanced is therefore no proof by itself: the first of two changes advances it
/// alone.
class FlashProof {
public:
    /// Latest after the last change: flash must have been written by then.
    static constexpr Duration limit = std::chrono::seconds(20);

    /// What was changed before `since`, by another program or by this one when it ran last, is not known.
    explicit FlashProof(Instant since)
        : m_unknownUntil(since)
    {
    }

    [[nodiscard]] bool isPending() const { return m_pending; }
    [[nodiscard]] bool isGivenUp() const { return m_isGivenUp; }
    /// The sequence number is wanted before the next change.
    [[nodiscard]] bool wantsBaseline() const { return !m_pending || m_isGivenUp; }
    void setBaseline(std::optional<std::uint32_t> sequence) { m_baseline = sequence; }
    /// A parameter is being changed.
    void changed(Instant now);
    /// A proof is asked for: pending also for what may have been changed before anybody listened, until it must have been written.
    void ask(Instant now);
    /// Nothing but such a change is pending, and 15 s have passed since.
    [[nodiscard]] bool hasRested(Instant now) const;
    [[nodiscard]] Instant deadline() const { return m_lastChange + limit; }
    /// The number was read at `now`: whether it proves that everything is in flash.
    [[nodiscard]] bool isProvedBy(std::uint32_t sequence, Instant now);
    /// At least one flash write was seen since the first change.
    [[nodiscard]] bool hasAdvanced(std::uint32_t sequence) const { return m_baseline && sequence != *m_baseline; }
    /// Proved: nothing is pending.
    void settle();
    /// Not proved in time: pending still, and whoever asks again is told the same until the number advances after all. The next
    /// change is looked at by itself, for its flash write takes what waits with it.
    void giveUp() { m_isGivenUp = true; }
    /// The device began anew: nothing is pending, and it does not know when anything changed last.
    void restarted();

private:
    bool m_pending = false;
    bool m_isGivenUp = false;
    bool m_deferred = false;                 ///< the last flash write of m_expected is still to come after 15 s of rest
    std::uint32_t m_expected = 0;            ///< flash writes that the changes cause, if nobody changed anything before
    std::optional<std::uint32_t> m_baseline; ///< before the first change
    std::optional<std::uint32_t> m_between;  ///< after any immediate write, before the deferred one
    std::optional<Instant> m_unknownUntil;   ///< nothing: whatever was changed before is in flash
    bool m_isOthers = false;                 ///< what is pending is not of this program
    Instant m_lastChange{};
    bool m_everChanged = false;
};

} // namespace mb::dmc60c
