// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/proposallist.h"

#include "model/loopparameters.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/design/designplots.h"
#include "widgets/design/ownproposal.h"

#include <algorithm>
#include <utility>

namespace mb {

ProposalList::ProposalList(DesignBook &book, DesignPlots &plots, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_book(book)
    , m_plots(plots)
    , m_theme(theme)
    , m_own(new OwnProposal(theme, this))
    , m_head(new QWidget(this))
    , m_column(layoutIn<QVBoxLayout>(this, theme.theme().u(4)))
{
    auto *head = layoutIn<QHBoxLayout>(m_head);
    head->addWidget(new SectionLabel(tr("Proposals"), m_head));
    m_comparedWords = textLabel({}, TextRole::Caption, Tone::Dim, m_head);
    m_comparedWords->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    head->addWidget(m_comparedWords, 1);
    m_column->addWidget(m_head);
    m_column->addWidget(m_own);
    m_own->hide();
    connect(m_own, &OwnProposal::wished, this, &ProposalList::ownWished);
    connect(m_own, &Card::activated, this, &ProposalList::ownWished);
}

const tuning::Proposal *ProposalList::chosen() const
{
    const DesignChoice now = m_book.choice();
    if (now.own && !m_designed.empty()) // else it is hidden: the model was not believed
        return m_ownDesigned ? &*m_ownDesigned : nullptr;
    const auto found = std::ranges::find_if(
        m_designed, [&now](const tuning::Proposal &proposal) { return proposal.aim == now.aim; });
    return found == m_designed.end() ? nullptr : &*found;
}

void ProposalList::chooseAim(tuning::Aim aim)
{
    DesignChoice &now = m_book.choose();
    now.aim = aim;
    now.own = false;
    showChosen();
    Q_EMIT aimChosen();
}

void ProposalList::chooseOwn(double response, double ms)
{
    DesignChoice &now = m_book.choose();
    now.own = true;
    now.response = response;
    now.ms = ms;
    designOwn();
    showChosen();
}

void ProposalList::ownWished()
{
    chooseOwn(m_own->response(), m_own->ms());
}

void ProposalList::showReport()
{
    for (ProposalCard *card : std::exchange(m_cards, {}))
        delete card;
    m_designed.clear();
    m_ownDesigned.reset();
    m_comparison.forget();
    if (const DeviceView *const view = m_book.device(); view && m_book.report()) {
        designAll(*view);
        for (const tuning::Proposal &proposal : m_designed)
            addCard(*view, proposal);
    }
    m_head->setVisible(!m_designed.empty());
    m_own->setVisible(!m_designed.empty());
    showChosen();
}

void ProposalList::setDensity(CardDensity density)
{
    m_density = density;
    m_column->setSpacing(m_theme.theme().u(density == CardDensity::Dense ? 3 : 4));
    m_own->setTight(density == CardDensity::Dense);
    for (ProposalCard *card : m_cards)
        card->setDensity(density);
}

void ProposalList::addCard(const DeviceView &view, const tuning::Proposal &proposal)
{
    ProposalCard::Scale scale{m_book.loop(), m_book.countsPerRevolution(view), 1.0};
    for (const tuning::ScaledGains::Row &row : proposal.gains.rows) {
        if (roleOf(*view.family, row.key) == Role::Divisor)
            scale.divisor = row.number;
    }
    auto *card = new ProposalCard(m_theme, *view.family, proposal, scale, this);
    connect(card, &Card::activated, this, [this, aim = proposal.aim] { chooseAim(aim); });
    card->setDensity(m_density);
    m_column->insertWidget(m_column->count() - 1, card); // the own one is the last
    m_cards.push_back(card);
}

bool ProposalList::isOutdated() const
{
    const DeviceView *const view = m_book.device();
    if (!view || !m_book.report() || m_designedFor == m_inForce)
        return false;
    const auto isOther = [this, basis = m_book.basisOf(*view, m_inForce)](const tuning::Proposal &proposal) {
        return !tuning::isAlikeWithin(m_designedFor, basis, proposal.gains.made);
    };
    return std::ranges::any_of(m_designed, isOther) || (m_ownDesigned && isOther(*m_ownDesigned));
}

/// What the engine proposed; the same gains in another slot, or within other limits.
void ProposalList::designAll(const DeviceView &view)
{
    const tuning::TuneReport &known = *m_book.report();
    m_designed = known.proposals;
    m_designedFor = known.envelope;
    m_isOfOthers = isOutdated();
    m_designedFor = m_inForce;
    if ((m_isOfOthers || known.slot != m_book.choice().slot) && known.plant.gain > 0.0) {
        m_designed.clear();
        const tuning::ProposalBasis basis = m_book.basisOf(view, m_inForce);
        for (const tuning::Proposal &proposal : known.proposals) {
            if (auto moved = tuning::movedTo(basis, proposal))
                m_designed.push_back(std::move(*moved));
        }
    }
    designOwn();
}

/// Of the sliders; they begin where the normal proposal is.
void ProposalList::designOwn()
{
    const DeviceView *const view = m_book.device();
    const tuning::TuneReport *const known = m_book.report();
    m_ownDesigned.reset();
    if (!view || !known || !(known->plant.gain > 0.0))
        return;
    const double usual = tuning::responseOf(m_book.loop(), tuning::Aim::Normal, known->plant);
    const DesignChoice now = m_book.choice();
    const double response = now.response > 0.0 ? now.response : usual;
    const double ms = now.ms > 0.0 ? now.ms : tuning::msBoundsOf({}).model;
    const auto proposal = tuning::proposalFor(m_book.basisOf(*view, m_inForce), {tuning::Aim::Normal, response, ms});
    m_own->setWish(response, ms, usual, tuning::msBoundsOf({}).model);
    m_own->show(proposal);
    if (proposal)
        m_ownDesigned = *proposal;
}

void ProposalList::showChosen()
{
    const tuning::Proposal *const proposal = chosen();
    const DesignChoice now = m_book.choice();
    for (ProposalCard *card : m_cards)
        card->setChosen(proposal && !now.own && card->aim() == proposal->aim);
    m_own->setChosen(proposal && now.own);
    const DeviceView *const view = m_book.device();
    if (!proposal || !view)
        return m_plots.clear();
    const tuning::ProposalBasis basis = m_book.basisOf(*view, m_inForce);
    const std::optional<ComparedGains> &compared = m_comparison.with(*view, basis, *m_book.report(), *proposal);
    m_comparedWords->setText(isFoundAnew() ? tr("to be found anew") : compared ? comparedText(*compared) : QString());
    m_plots.setMeasured(m_book.response());
    m_plots.show(*m_book.report(), {*proposal, chosenName(), compared}, basis);
}

QWidget *ProposalList::chosenCard() const
{
    if (m_book.choice().own)
        return m_own;
    const auto found = std::ranges::find_if(
        m_cards, [aim = m_book.choice().aim](const ProposalCard *card) { return card->aim() == aim; });
    return found == m_cards.end() ? nullptr : *found;
}

QString ProposalList::chosenName() const
{
    const tuning::Proposal *const proposal = chosen();
    return !proposal ? QString() : m_book.choice().own ? tr("own") : aimText(proposal->aim);
}

} // namespace mb
