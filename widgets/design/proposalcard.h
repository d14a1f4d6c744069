// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "tuning/autotune.h"
#include "widgets/common/card.h"

class QGridLayout;

namespace mb {

class ChoiceMark;

/// What a card tells of its gains: each with its raw number and what it is to the motor; all in one line, by their numbers alone; and that
/// line only where the set is chosen.
enum class CardDensity : std::uint8_t { Comfortable, Compact, Dense };

/// One set of gains that may be had: the device's own numbers, and what they will do. Clicked, or activated by keys, it is chosen.
class ProposalCard : public Card {
    Q_OBJECT
public:
    /// What the gains are to the motor.
    struct Scale {
        Mode loop = Mode::Velocity;
        double countsPerRevolution = 0.0;
        double divisor = 1.0; ///< of the set, where the loop has one
    };
    ProposalCard(const ThemeSource &theme, const Family &family, const tuning::Proposal &proposal, const Scale &scale,
        QWidget *parent);

    void setChosen(bool chosen);
    void setDensity(CardDensity density);
    [[nodiscard]] tuning::Aim aim() const { return m_aim; }

private:
    void addGains(const Family &family, const tuning::Proposal &proposal, const Scale &scale, const Theme &look);
    void addRow(QGridLayout &grid, const Parameter &parameter, const tuning::ScaledGains::Row &gain);
    void addFigures(const Family &family, const tuning::Proposal &proposal, const Theme &look);
    void showGains();

    tuning::Aim m_aim;
    ChoiceMark *m_mark;
    CardDensity m_density = CardDensity::Comfortable;
    QWidget *m_gains = nullptr;
    QLabel *m_brief = nullptr;
};

/// Overshoot, settling and margins in one line.
[[nodiscard]] QString figuresText(const tuning::Proposal &proposal);
/// "calm", "normal", "brisk", in front of people.
[[nodiscard]] QString aimText(tuning::Aim aim);

} // namespace mb
