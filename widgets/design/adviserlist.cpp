// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/adviserlist.h"

#include "files/qttext.h"
#include "model/loopparameters.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/stateglyph.h"
#include "widgets/control/advicepanel.h"
#include "widgets/control/wrappedlabel.h"
#include "widgets/design/proposalcard.h"
#include "widgets/design/stepcurves.h"

#include <QPushButton>

namespace mb {
namespace {

using tuning::Cause;
using State = tuning::SetAdvice::State;

QString adviceState(const tuning::SetAdvice &advice, bool staged)
{
    if (staged)
        return AdviserList::tr("staged");
    switch (advice.state) {
    case State::Fine: return AdviserList::tr("ok");
    case State::Fixed: return AdviserList::tr("fixed in the set");
    case State::Notable: return advice.changes.empty() ? AdviserList::tr("mind it") : AdviserList::tr("to fix");
    case State::Unread: return AdviserList::tr("not read");
    }
    return {};
}

GlyphState adviceGlyph(State state)
{
    return state == State::Notable ? GlyphState::Warning
        : state == State::Unread   ? GlyphState::Waiting
                                   : GlyphState::Done;
}

Tone adviceTone(State state)
{
    return state == State::Notable ? Tone::Caution : state == State::Unread ? Tone::Dim : Tone::Ok;
}

QString unbroken(QString name)
{
    constexpr QChar hyphen{0x2011};
    return name.replace(QLatin1Char(' '), QChar(QChar::Nbsp)).replace(QLatin1Char('-'), hyphen);
}

QString sharePercent(double fraction)
{
    return formatNumber(fraction * 100.0, fraction < 0.1 ? 1 : 0);
}

QString feedForwardText(Mode loop, const tuning::SetAdvice &advice)
{
    if (advice.key.empty() || loop != Mode::Velocity)
        return AdviserList::tr("This loop has no F that could fight with I.");
    const QString area = formatDuration(advice.number);
    if (advice.state == State::Fixed)
        return AdviserList::tr("F and I in force give back %1 of the step as overshoot. The set has no F.").arg(area);
    return advice.state == State::Notable ? AdviserList::tr("F and I give back %1 of the step as overshoot.").arg(area)
                                          : AdviserList::tr("F and I give nothing back as overshoot.");
}

QString deadbandText(Mode loop, const tuning::ContinuousGains &gains, const tuning::SetAdvice &advice)
{
    const QString band = QStringLiteral("%1 %2").arg(formatSignificant(advice.number, 3), stepUnit(loop));
    QString words = gains.i != 0.0 ? AdviserList::tr("uS/kp = %1: below this error only I moves the shaft.").arg(band)
                                   : AdviserList::tr("uS/kp = %1: below this error nothing moves the shaft.").arg(band);
    if (advice.state == State::Notable)
        words += QLatin1Char(' ') + AdviserList::tr("That is over 2 % of the step.");
    else if (loop == Mode::Position && advice.number > advice.limit)
        words += QLatin1Char(' ') + AdviserList::tr("The drive's least output helps.");
    return words;
}

QString resolutionText(const tuning::SetAdvice &advice)
{
    if (advice.key.empty())
        return AdviserList::tr("No gain of the set is an integer of its own.");
    return AdviserList::tr("%1 is %2 steps of its integer, at least %3 are wanted: one step is %4 %.")
        .arg(qt(gainLetter(advice.role)), formatNumber(advice.number), formatNumber(advice.limit),
            formatSignificant(100.0 / advice.number, 2));
}

QString rampText(const tuning::SetAdvice &advice)
{
    if (advice.key.empty())
        return AdviserList::tr("This drive has no ramp of its own.");
    if (advice.state == State::Unread)
        return AdviserList::tr("The drive's ramp was not read yet.");
    if (advice.number == 0.0)
        return AdviserList::tr("The drive's ramp is off.");
    const QString words = advice.state == State::Notable
        ? AdviserList::tr("Full duty takes %1, over τc/2 = %2: it acts as lag.")
        : AdviserList::tr("Full duty takes %1, under τc/2 = %2.");
    return words.arg(formatDuration(advice.number), formatDuration(advice.limit));
}

} // namespace

QString placeText(Cause cause)
{
    switch (cause) {
    case Cause::FeedForward: return AdviserList::tr("F–I conflict");
    case Cause::Deadband: return AdviserList::tr("Deadband");
    case Cause::DerivativeNoise: return AdviserList::tr("D noise");
    case Cause::Resolution: return AdviserList::tr("Resolution");
    case Cause::Ramp: return AdviserList::tr("Ramp");
    default: return {};
    }
}

QString adviceText(
    const tuning::ProposalBasis &basis, const tuning::Proposal &proposal, const tuning::SetAdvice &advice)
{
    switch (advice.cause) {
    case Cause::FeedForward: return feedForwardText(basis.loop, advice);
    case Cause::Deadband: return deadbandText(basis.loop, proposal.gains.made, advice);
    case Cause::DerivativeNoise:
        return advice.number == 0.0
            ? AdviserList::tr("D is 0: one count moves no duty.")
            : AdviserList::tr("One count moves the duty by %1 % through D; %2 % is the most that is quiet.")
                  .arg(sharePercent(advice.number), sharePercent(advice.limit));
    case Cause::Resolution: return resolutionText(advice);
    case Cause::Ramp: return rampText(advice);
    default: return {};
    }
}

AdviserList::AdviserList(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const Theme &look = theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, look.u(6));
    auto *head = new QHBoxLayout;
    head->addWidget(new SectionLabel(tr("Advisers"), this));
    head->addStretch(1);
    m_of = textLabel({}, TextRole::Caption, Tone::Dim, this);
    head->addWidget(m_of);
    column->addLayout(head);
    m_box = new QWidget(this);
    m_rows = layoutIn<QVBoxLayout>(m_box, look.u(6));
    column->addWidget(m_box);
    hide();
}

void AdviserList::show(const tuning::ProposalBasis &basis, const tuning::Proposal &proposal, const QString &name,
    const std::vector<tuning::SetAdvice> &advice, const std::function<bool(const tuning::SetAdvice &)> &isStaged)
{
    m_of->setText(basis.family.capabilities.gainSlots > 1 ? tr("for %1, slot %2").arg(name).arg(basis.slot)
                                                          : tr("for %1").arg(name));
    std::vector<Place> places;
    for (const tuning::SetAdvice &one : advice)
        places.push_back({one, adviceText(basis, proposal, one),
            remedyTexts(basis.family, one.changes).join(QStringLiteral(", ")), !one.changes.empty() && isStaged(one)});
    setVisible(true);
    if (places == m_places)
        return;
    m_places = std::move(places);
    rebuild();
}

void AdviserList::clear()
{
    hide();
    if (m_places.empty())
        return;
    m_places.clear();
    rebuild();
}

void AdviserList::rebuild()
{
    while (QLayoutItem *item = m_rows->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_fine.clear();
    m_quiet.clear();
    m_lines.clear();
    addSum();
    for (const Place &place : m_places) {
        if (m_rows->count() > 1) {
            QFrame *const line = separatorLine(Qt::Horizontal, m_box);
            m_rows->addWidget(line);
            m_lines.push_back(line);
        }
        addPlace(place);
    }
    setDensity(m_density);
    Q_EMIT rebuilt();
}

void AdviserList::setDensity(Density density)
{
    m_density = density;
    const bool sums = density == Density::Dense && m_fine.size() > 1;
    m_rows->setSpacing(m_theme.theme().u(density == Density::Comfortable ? 6 : 3));
    if (m_sum)
        m_sum->setHidden(!sums);
    for (QWidget *box : m_fine)
        box->setHidden(sums);
    for (QLabel *words : m_quiet)
        words->setHidden(density != Density::Comfortable);
    for (QFrame *line : m_lines)
        line->setHidden(density != Density::Comfortable);
}

/// All that is in order: its names, and one word for them.
void AdviserList::addSum()
{
    m_sum = new QWidget(m_box);
    QStringList names;
    QStringList told;
    for (const Place &place : m_places) {
        if (place.staged || place.advice.state != State::Fine)
            continue;
        names << unbroken(placeText(place.advice.cause));
        told << placeText(place.advice.cause) + QStringLiteral(": ") + place.words;
    }
    auto *const row = layoutIn<QHBoxLayout>(m_sum, m_theme.theme().u(8));
    row->addWidget(new StateGlyph(m_theme, adviceGlyph(State::Fine), m_sum), 0, Qt::AlignTop);
    row->addWidget(wrappedLabel(names.join(QStringLiteral(" · ")), TextRole::Body, Tone::Text, m_sum), 1);
    row->addWidget(
        textLabel(AdviserList::tr("ok"), TextRole::Caption, adviceTone(State::Fine), m_sum), 0, Qt::AlignTop);
    m_sum->setToolTip(told.join(QLatin1Char('\n')));
    m_rows->addWidget(m_sum);
}

void AdviserList::addPlace(const Place &place)
{
    const State state = place.staged ? State::Fixed : place.advice.state;
    auto *const box = new QWidget(m_box);
    auto *const grid = layoutIn<QGridLayout>(box);
    grid->setHorizontalSpacing(m_theme.theme().u(8));
    grid->setVerticalSpacing(m_theme.theme().u(1));
    grid->addWidget(new StateGlyph(m_theme, adviceGlyph(state), box), 0, 0);
    auto *const title = new QLabel(placeText(place.advice.cause), box);
    setTextRole(*title, TextRole::Emphasis);
    grid->addWidget(title, 0, 1);
    grid->addWidget(
        textLabel(adviceState(place.advice, place.staged), TextRole::Caption, adviceTone(state), box), 0, 2);
    grid->setColumnStretch(2, 1);
    QLabel *const words = wrappedLabel(place.words, TextRole::Caption, Tone::Dim, box);
    grid->addWidget(words, 1, 1, 1, 2);
    if (state == State::Fine || state == State::Fixed) {
        box->setToolTip(place.words);
        m_quiet.push_back(words);
    }
    if (state == State::Fine)
        m_fine.push_back(box);
    if (!place.advice.changes.empty()) {
        grid->addWidget(wrappedLabel(place.remedy, TextRole::Caption, Tone::Text, box), 2, 1, 1, 2);
        grid->addWidget(stageButton(place, box), 3, 1, 1, 2, Qt::AlignLeft);
    }
    m_rows->addWidget(box);
    box->show();
}

QPushButton *AdviserList::stageButton(const Place &place, QWidget *box)
{
    auto *const button = new QPushButton(place.staged ? tr("Take back") : tr("Stage"), box);
    button->setAccessibleDescription(place.remedy);
    button->setToolTip(tr("Stages these values; nothing is written yet."));
    connect(button, &QPushButton::clicked, this, [this, place] { Q_EMIT stageRequested(place.advice, !place.staged); });
    return button;
}

} // namespace mb
