// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/proposalcard.h"

#include "files/qttext.h"
#include "model/loopparameters.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"

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
};

std::vector<Figure> figuresOf(const tuning::Proposal &proposal)
{
    const tuning::Metrics &metrics = proposal.predicted.metrics;
    const auto number = [](const std::optional<double> &value, double scale, int decimals) {
        return value ? formatNumber(*value * scale, decimals) : QStringLiteral("–");
    };
    return {{ProposalCard::tr("over %"), number(metrics.overshoot, 100.0, 1)},
        {ProposalCard::tr("settle ms"), number(metrics.settle, 1e3, 0)},
        {ProposalCard::tr("Ms"), formatNumber(proposal.margins.ms, 2)},
        {ProposalCard::tr("GM dB"),
            std::isfinite(proposal.margins.gain) ? formatNumber(20.0 * std::log10(proposal.margins.gain), 1)
                                                 : QStringLiteral("–")},
        {ProposalCard::tr("PM °"), formatNumber(proposal.margins.phase)}};
}

/// "P" of "slot0.p".
QString shortGainName(const Family &family, const std::string &key)
{
    const Role role = roleOf(family, key);
    return isGain(role) ? qt(gainLetter(role)) : QString::fromStdString(key.substr(key.rfind('.') + 1)).toUpper();
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
        words << figure.name + QChar(0x00A0) + figure.value;
    return words.join(QStringLiteral(" · "));
}

ProposalCard::ProposalCard(
    const ThemeSource &theme, const Family &family, const tuning::Proposal &proposal, QWidget *parent)
    : Card(theme, aimText(proposal.aim), parent)
    , m_aim(proposal.aim)
{
    setTitle(aimText(m_aim), characterText(m_aim));
    setActivatable(true);
    addHeadWidget(
        textLabel(tr("τc %1").arg(formatDuration(proposal.design.response)), TextRole::Emphasis, Tone::Text, this));
    auto *gains = new QGridLayout;
    gains->setColumnStretch(3, 1);
    int row = 0;
    QStringList zeros;
    for (const tuning::ScaledGains::Row &gain : proposal.gains.rows) {
        if (gain.raw == 0) {
            zeros << shortGainName(family, gain.key);
            continue;
        }
        const auto index = findParameter(family.parameters, gain.key);
        const std::string_view unit = index ? family.parameters[index->value].unit : std::string_view();
        gains->addWidget(textLabel(shortGainName(family, gain.key), TextRole::Emphasis, Tone::Text, this), row, 0);
        gains->addWidget(
            textLabel(formatSignificant(gain.number, 4), TextRole::Emphasis, Tone::Text, this), row, 1, Qt::AlignRight);
        gains->addWidget(textLabel(tr("raw %1").arg(formatCount(gain.raw)), TextRole::Raw, Tone::Dim, this), row, 2);
        gains->addWidget(textLabel(QString::fromUtf8(unit.data(), static_cast<int>(unit.size())), TextRole::Caption,
                             Tone::Dim, this),
            row++, 3);
    }
    if (!zeros.isEmpty())
        gains->addWidget(
            textLabel(tr("%1 = 0").arg(zeros.join(QStringLiteral(", "))), TextRole::Caption, Tone::Dim, this), row, 0,
            1, 4);
    body().addLayout(gains);
    auto *figures = new QGridLayout;
    int column = 0;
    QStringList spoken;
    for (const Figure &figure : figuresOf(proposal)) {
        figures->addWidget(textLabel(figure.name, TextRole::Caption, Tone::Dim, this), 0, column);
        figures->addWidget(textLabel(figure.value, TextRole::Emphasis, Tone::Text, this), 1, column++);
        spoken << figure.name + QLatin1Char(' ') + figure.value;
    }
    body().addLayout(figures);
    setAccessibleName(tr("Proposal: %1").arg(aimText(m_aim)));
    setAccessibleDescription(spoken.join(QStringLiteral(", ")));
}

void ProposalCard::setChosen(bool chosen)
{
    setEdge(chosen ? std::optional(Tone::Accent) : std::nullopt);
}

} // namespace mb
