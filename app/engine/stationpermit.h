// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/listeners.h"
#include "async/sleep.h"
#include "service/selftest.h"
#include "service/servicesurroundings.h"
#include "widgets/common/serviceview.h"

namespace mb {

/// Who may let the motors of self-tests turn: whoever has armed the station, until it is disarmed, five minutes pass without a
/// unit or the computer sleeps: then what turns is stopped, too. Each motion is announced for three seconds, in which somebody can
/// still say no. Engine thread.
class StationPermit final : public service::MotionPermit {
public:
    explicit StationPermit(Clock &clock);

    void arm(bool on);
    /// No other motor: a self-test that runs elsewhere goes on.
    void disarmNext();
    /// Whether a unit is there: the five minutes begin when none is any more.
    void setServed(bool on);
    /// Nobody will arm any more: units that wait for it are cut off; until the next queue begins.
    void setLeaving(bool on) { m_isLeaving = on; }

    /// Its part of what the window sees.
    void describe(ServiceView &view) const;
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

    [[nodiscard]] Task<void> beforeMotion(
        const Device &device, const service::SelfTest &test, Progress &progress) override;

    /// Words and sound before a motor turns.
    static constexpr Duration announcement = std::chrono::seconds(3);
    /// Without a unit so long, nothing is armed any more.
    static constexpr Duration armedTime = std::chrono::minutes(5);

private:
    [[nodiscard]] bool isArmed() const { return m_mayTurn == MayTurn::Every; }
    void set(MayTurn mayTurn);
    void restart();
    void look();
    [[nodiscard]] Task<void> untilArmed(const Device &device, Progress &progress);

    Clock &m_clock;
    MayTurn m_mayTurn = MayTurn::Nothing;
    int m_armings = 0;
    Instant m_end{};
    Duration m_slept{}; ///< Clock::slept() when it was armed
    bool m_isServed = false;
    int m_announcing = 0;
    int m_waiting = 0;
    bool m_isLeaving = false;
    Timer m_until;
    Listeners<> m_changed;
};

} // namespace mb
