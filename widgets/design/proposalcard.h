// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "tuning/autotune.h"
#include "widgets/common/card.h"

namespace mb {

/// One set of gains that may be had: the device's own numbers, and what they will do. Clicked, or activated by keys, it is chosen.
class ProposalCard : public Card {
    Q_OBJECT
public:
    ProposalCard(const ThemeSource &theme, const Family &family, const tuning::Proposal &proposal, QWidget *parent);

    void setChosen(bool chosen);
    [[nodiscard]] tuning::Aim aim() const { return m_aim; }

private:
    tuning::Aim m_aim;
};

/// Overshoot, settling and margins in one line.
[[nodiscard]] QString figuresText(const tuning::Proposal &proposal);
/// "calm", "normal", "brisk", in front of people.
[[nodiscard]] QString aimText(tuning::Aim aim);

} // namespace mb
