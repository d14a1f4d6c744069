// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/proposalcard.h"

#include "files/qttext.h"
#include "model/loopparameters.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/gainunits.h"
#include "widgets/design/choicemark.h"

#include <QGridLayout>

#include <cmath>

namespace mb {
namespace {

QString characterText(tuning::Aim aim)
{
    switch (aim) {
    case tuning::Aim::Calm: return ProposalCard::tr("quiet, forgiving");
    case tuning::Aim::Normal: return ProposalCard::tr("hardly overshoots");
    case tuning::Aim::Brisk: return ProposalCard::tr("fastest rise");
    }
    return {};
}

struct Figure {
    QString name;
    QString value;
    QString unit;
};

std::vector<Figure> figuresOf(const tuning::Proposal &proposal)
{
    const tuning::Metrics &metrics = proposal.predicted.metrics;
    const auto number = [](const std::optional<double> &value, double scale, int decimals) {
        return value ? formatNumber(*value * scale, decimals) : QStringLiteral("–");
    };
    return {{ProposalCard::tr("over"), number(metrics.overshoot, 100.0, 1), QStringLiteral("%")},
        {ProposalCard::tr("settle"), number(metrics.settle, 1e3, 0), ProposalCard::tr("ms")},
        {ProposalCard::tr("Ms"), formatNumber(proposal.margins.ms, 2), {}},
        {ProposalCard::tr("GM"),
            std::isfinite(proposal.margins.gain) ? formatNumber(20.0 * std::log10(proposal.margins.gain), 1)
                                                 : QStringLiteral("–"),
            ProposalCard::tr("dB")},
        {ProposalCard::tr("PM"), formatNumber(proposal.margins.phase), QStringLiteral("°")},
        {ProposalCard::tr("peak"), number(metrics.peakCurrent, 1.0, 1), ProposalCard::tr("A")}};
}

QString inUnit(const Figure &figure)
{
    return figure.unit.isEmpty() || figure.value == QStringLiteral("–") ? figure.value
        : figure.unit == QStringLiteral("°")                            ? figure.value + figure.unit
                                                                        : figure.value + QChar(0x00A0) + figure.unit;
}

/// What a gain is to the motor; nothing for what is no gain.
QString physicalText(const Family &family, const Parameter &row, const tuning::ContinuousGains &made, double number,
    const ProposalCard::Scale &scale)
{
    if (scale.countsPerRevolution <= 0.0 && scale.loop != Mode::Current)
        return {};
    if (const auto si = siGain(family, row, scale.loop, number, scale.countsPerRevolution, scale.divisor))
        return si->text();
    const double of = row.role == Role::Proportional ? made.p
        : row.role == Role::Integral                 ? made.i
        : row.role == Role::Derivative               ? made.d
        : row.role == Role::FeedForward              ? made.f
                                                     : 0.0;
    return of == 0.0 ? QString() : siGain(row.role, scale.loop, of, scale.countsPerRevolution).text();
}

} // namespace

QString aimText(tuning::Aim aim)
{
    switch (aim) {
    case tuning::Aim::Calm: return ProposalCard::tr("calm");
    case tuning::Aim::Normal: return ProposalCard::tr("normal");
    case tuning::Aim::Brisk: return ProposalCard::tr("brisk");
    }
    return {};
}

QString figuresText(const tuning::Proposal &proposal)
{
    QStringList words;
    for (const Figure &figure : figuresOf(proposal))
        words << figure.name + QChar(0x00A0) + inUnit(figure);
    return words.join(QStringLiteral(" · "));
}

ProposalCard::ProposalCard(const ThemeSource &theme, const Family &family, const tuning::Proposal &proposal,
    const Scale &scale, QWidget *parent)
    : Card(theme, aimText(proposal.aim), parent)
    , m_aim(proposal.aim)
    , m_mark(new ChoiceMark(theme, this))
{
    setDense(true);
    setTitle(aimText(m_aim), characterText(m_aim));
    addHeadMark(m_mark);
    setActivatable(true);
    addHeadWidget(
        textLabel(tr("τc %1").arg(formatDuration(proposal.design.response)), TextRole::Emphasis, Tone::Text, this));
    addGains(family, proposal, scale, theme.theme());
    addFigures(family, proposal, theme.theme());
}

/// What is not 0, one below the other: gains by their letters, then what bounds them, by its name.
void ProposalCard::addGains(
    const Family &family, const tuning::Proposal &proposal, const Scale &scale, const Theme &look)
{
    m_gains = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(m_gains, 0);
    auto *gains = new QGridLayout;
    auto *bounds = new QGridLayout;
    for (QGridLayout *grid : {gains, bounds}) {
        grid->setHorizontalSpacing(look.u(6));
        grid->setVerticalSpacing(0);
        column->addLayout(grid);
    }
    gains->setColumnStretch(3, 1);
    bounds->setColumnStretch(0, 1);
    QStringList brief;
    for (const tuning::ScaledGains::Row &gain : proposal.gains.rows) {
        const auto index = findParameter(family.parameters, gain.key);
        if (gain.raw == 0 || !index)
            continue;
        const Parameter &parameter = family.parameters[index->value];
        addRow(isGain(parameter) ? *gains : *bounds, parameter, gain);
        if (!isGain(parameter))
            continue;
        brief << shortName(parameter) + QChar(0x00A0) + shortNumber(parameter, gain.number);
        QLabel *const physical = textLabel(physicalText(family, parameter, proposal.gains.made, gain.number, scale),
            TextRole::Caption, Tone::Dim, this);
        physical->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        gains->addWidget(physical, gains->rowCount() - 1, 3);
    }
    body().addWidget(m_gains);
    m_brief = textLabel(brief.join(QStringLiteral(" · ")), TextRole::Emphasis, Tone::Text, this);
    m_brief->hide();
    body().addWidget(m_brief);
}

/// Its raw number where that is another.
void ProposalCard::addRow(QGridLayout &grid, const Parameter &parameter, const tuning::ScaledGains::Row &gain)
{
    const int row = grid.rowCount();
    const bool whole = parameter.one == 1.0;
    grid.addWidget(
        textLabel(shortName(parameter), isGain(parameter) ? TextRole::Emphasis : TextRole::Body, Tone::Text, this), row,
        0);
    auto *const value = new QLabel(shortNumber(parameter, gain.number), this);
    setTextRole(*value, TextRole::Emphasis);
    grid.addWidget(value, row, 1, Qt::AlignRight);
    if (!whole || isGain(parameter))
        grid.addWidget(
            textLabel(tr("raw %1").arg(formatCount(gain.raw)), TextRole::Raw, Tone::Dim, this), row, 2, Qt::AlignRight);
}

void ProposalCard::addFigures(const Family &family, const tuning::Proposal &proposal, const Theme &look)
{
    auto *figures = new QGridLayout;
    figures->setHorizontalSpacing(look.u(4));
    figures->setVerticalSpacing(0);
    int column = 0;
    QStringList spoken;
    for (const Figure &figure : figuresOf(proposal)) {
        figures->addWidget(textLabel(figure.name, TextRole::Caption, Tone::Dim, this), 0, column);
        figures->addWidget(textLabel(inUnit(figure), TextRole::Emphasis, Tone::Text, this), 1, column++);
        spoken << figure.name + QLatin1Char(' ') + inUnit(figure);
    }
    QStringList zeros;
    for (const tuning::ScaledGains::Row &gain : proposal.gains.rows) {
        if (const auto index = findParameter(family.parameters, gain.key); index && gain.raw == 0)
            zeros << shortName(family.parameters[index->value]);
    }
    if (!zeros.isEmpty())
        spoken << tr("%1 = 0").arg(zeros.join(QStringLiteral(", ")));
    body().addLayout(figures);
    setAccessibleName(tr("Proposal: %1").arg(aimText(m_aim)));
    setAccessibleDescription(spoken.join(QStringLiteral(", ")));
}

void ProposalCard::setDensity(CardDensity density)
{
    m_density = density;
    setTight(density == CardDensity::Dense);
    showGains();
}

void ProposalCard::setChosen(bool chosen)
{
    m_mark->setChosen(chosen);
    setEdge(chosen ? std::optional(Tone::Accent) : std::nullopt);
    showGains();
}

void ProposalCard::showGains()
{
    m_gains->setVisible(m_density == CardDensity::Comfortable);
    m_brief->setVisible(m_density == CardDensity::Compact || (m_density == CardDensity::Dense && m_mark->isChosen()));
    setToolTip(m_density == CardDensity::Dense ? m_brief->text() : QString());
}

} // namespace mb
