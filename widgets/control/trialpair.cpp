// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/trialpair.h"

#include <algorithm>
#include <utility>

namespace mb {

bool TrialPair::isComparable() const
{
    if (!m_a || !m_b)
        return false;
    const tuning::Stimulus &a = m_a->trial.stimulus;
    const tuning::Stimulus &b = m_b->trial.stimulus;
    return a.profile == b.profile && a.from == b.from && a.to == b.to;
}

void TrialPair::pinCurrent()
{
    m_a = m_b;
    m_pinned = true;
}

void TrialPair::measured(const tuning::Trial &trial)
{
    if (!m_pinned && m_b && trial.number != m_b->number && m_b->trial.metrics.settle)
        m_a = m_b;
    KeptTrial kept;
    kept.number = trial.number.value_or(0);
    kept.trial = trial;
    m_b = std::move(kept);
}

bool TrialPair::update(const std::vector<KeptTrial> &kept)
{
    bool isLetGo = false;
    for (std::optional<KeptTrial> *const shown : {&m_a, &m_b}) {
        const auto found = std::ranges::find_if(
            kept, [shown](const KeptTrial &trial) { return *shown && trial.number == (*shown)->number; });
        if (found != kept.end()) {
            (*shown)->star = found->star;
            (*shown)->note = found->note;
            (*shown)->time = found->time;
        } else if (*shown && (*shown)->time > 0.0) { // it was kept
            shown->reset();
            m_pinned = m_pinned && shown != &m_a;
            isLetGo = true;
        }
    }
    return isLetGo;
}

} // namespace mb
