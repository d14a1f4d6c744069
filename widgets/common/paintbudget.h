// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"

#include <chrono>

namespace mb {

/// Keeps what is drawn again and again to half of a thread's time on any machine: after a drawing the next one waits as long as that
/// one took, however much of it the computer spent on others. Keys, the mouse and orders have the other half.
class PaintBudget {
public:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool isDue(Clock::time_point now = Clock::now()) const { return now >= m_free; }
    /// Until it is due; zero when it is.
    [[nodiscard]] Clock::duration wait(Clock::time_point now = Clock::now()) const
    {
        return isDue(now) ? Clock::duration::zero() : m_free - now;
    }
    void spend(Clock::time_point begun, Clock::time_point ended) { m_free = ended + (ended - begun); }

private:
    Clock::time_point m_free{};
};

/// Spends from a budget from here to the end of its scope. Inside another one it is a part of that.
class Painting : NonCopyable {
public:
    explicit Painting(PaintBudget &budget)
        : m_budget(budget)
    {
    }
    ~Painting() { m_budget.spend(m_begun, PaintBudget::Clock::now()); }

private:
    PaintBudget &m_budget;
    PaintBudget::Clock::time_point m_begun = PaintBudget::Clock::now();
};

} // namespace mb
