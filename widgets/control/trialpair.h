// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/kepttrial.h"

#include <optional>
#include <vector>

namespace mb {

/// The two trials that are looked at together: B is the newest, or the one that was chosen; A is the one before, or one that
/// somebody has pinned.
class TrialPair {
public:
    [[nodiscard]] const KeptTrial *a() const { return m_a ? &*m_a : nullptr; }
    [[nodiscard]] const KeptTrial *b() const { return m_b ? &*m_b : nullptr; }
    /// Both are there, with the same stimulus.
    [[nodiscard]] bool isComparable() const;
    /// A, where it may stand beside B.
    [[nodiscard]] const KeptTrial *comparedA() const { return m_b && !isComparable() ? nullptr : a(); }

    void setA(KeptTrial kept) { m_a = std::move(kept); }
    void setB(KeptTrial kept) { m_b = std::move(kept); }
    /// A stays what it is, whatever is measured.
    void pin() { m_pinned = true; }
    /// B becomes A, and stays it.
    void pinCurrent();
    void flip() { std::swap(m_a, m_b); }
    /// What is measured so far is B. Unless somebody has pinned another, what was B becomes A.
    void measured(const tuning::Trial &trial);
    /// Star, note and time may be others by now. True where one was kept and is no more: it is let go.
    [[nodiscard]] bool update(const std::vector<KeptTrial> &kept);

private:
    std::optional<KeptTrial> m_a;
    std::optional<KeptTrial> m_b;
    bool m_pinned = false; ///< somebody chose A
};

} // namespace mb
