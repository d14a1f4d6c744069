// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/design/comparedgains.h"
#include "widgets/design/designbook.h"
#include "widgets/design/proposalcard.h"

#include <QVBoxLayout>

class QLabel;

namespace mb {

class DesignPlots;
class OwnProposal;

/// The sets of gains that a motor may have: those that the engine proposed, one card each, and that of the two sliders. One of
/// them is chosen; the plots show what it will do. Nothing is searched for here, that takes longer than a frame. GUI thread.
class ProposalList : public QWidget {
    Q_OBJECT
public:
    /// Has the cards in it; the plots stand elsewhere on the page.
    ProposalList(DesignBook &book, DesignPlots &plots, const ThemeSource &theme, QWidget *parent);

    /// The set of the two sliders, below the cards.
    [[nodiscard]] OwnProposal &own() { return *m_own; }
    /// What a step may use.
    void setInForce(const Envelope &inForce) { m_inForce = inForce; }
    /// What is shown is of limits that are no more in force, which are also of where the motor is.
    [[nodiscard]] bool isOutdated() const;
    /// Another report, motor or slot, or other limits.
    void showReport();
    /// Of each card.
    void setDensity(CardDensity density);
    /// Draws the one that is chosen.
    void showChosen();
    void chooseAim(tuning::Aim aim);
    /// The set of the two sliders instead: response in s, largest sensitivity. Designed on the model that is known.
    void chooseOwn(double response, double ms);
    /// nullptr: there is nothing yet.
    [[nodiscard]] const tuning::Proposal *chosen() const;
    [[nodiscard]] QString chosenName() const;
    /// The cards were found for other limits, or elsewhere: what is written of the one that is chosen is found anew.
    [[nodiscard]] bool isFoundAnew() const { return m_isOfOthers && !m_book.choice().own; }
    [[nodiscard]] QWidget *chosenCard() const;
    [[nodiscard]] const Envelope &inForce() const { return m_inForce; }

Q_SIGNALS:
    /// One of the cards, by hand.
    void aimChosen();

private:
    void designAll(const DeviceView &view);
    void addCard(const DeviceView &view, const tuning::Proposal &proposal);
    void designOwn();
    void ownWished();

    DesignBook &m_book;
    DesignPlots &m_plots;
    const ThemeSource &m_theme;
    Envelope m_inForce;
    Envelope m_designedFor;
    bool m_isOfOthers = false;
    std::vector<tuning::Proposal> m_designed;      ///< of the report and slot that are shown
    std::optional<tuning::Proposal> m_ownDesigned; ///< of the sliders
    std::vector<ProposalCard *> m_cards;
    OwnProposal *m_own = nullptr;
    CardDensity m_density = CardDensity::Comfortable;
    QWidget *m_head = nullptr;
    QLabel *m_comparedWords = nullptr;
    GainComparison m_comparison;
    QVBoxLayout *m_column = nullptr;
};

} // namespace mb
