// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/advicepanel.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/wrappedlabel.h"

#include <QCoreApplication>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

using tuning::Cause;

struct AdviceText {
    Q_DECLARE_TR_FUNCTIONS(mb::AdviceText)
};

constexpr std::size_t mostShown = 2;

QString percent(double fraction)
{
    return formatNumber(fraction * 100.0, std::abs(fraction) < 0.1 ? 1 : 0);
}

} // namespace

QString adviceText(const tuning::Advice &advice)
{
    const double n = advice.number;
    switch (advice.cause) {
    case Cause::FeedForward:
        return AdviceText::tr("F·K is %1 with I active: the initial lag is paid back as overshoot.")
            .arg(formatNumber(n, 2));
    case Cause::Deadband:
        return AdviceText::tr("It stops %1 counts short: P alone does not overcome friction there.")
            .arg(formatNumber(n));
    case Cause::Resolution:
        return AdviceText::tr("A gain has only %1 steps of its integer; it cannot be set finely.").arg(formatNumber(n));
    case Cause::DerivativeNoise:
        return AdviceText::tr(
            "One count of the sensor moves the duty by %1 % through D; 10 % is the most that is quiet.")
            .arg(percent(n));
    case Cause::Ramp:
        return AdviceText::tr("The drive's ramp takes %1 to full duty, which is slower than this loop.")
            .arg(formatDuration(n));
    case Cause::Saturation:
        return AdviceText::tr("The duty was at its limit for %1: the loop cannot go faster there.")
            .arg(formatDuration(n));
    case Cause::Windup:
        return AdviceText::tr("The duty was at its limit for %1 while I went on; that is paid back as overshoot.")
            .arg(formatDuration(n));
    case Cause::FilterDelay:
        return AdviceText::tr("The measured velocity is %1 late; the gains are too lively for that.")
            .arg(formatDuration(n));
    case Cause::BlockVelocity:
        return AdviceText::tr("The velocity comes anew every %1 only; a loop cannot be quicker than that.")
            .arg(formatDuration(n));
    case Cause::Friction:
        return AdviceText::tr("It moved late, at %1 % duty: friction holds it until then.").arg(percent(n));
    case Cause::Gravity:
        return AdviceText::tr("It takes %1 % duty to stay in place: a load pulls one way.").arg(percent(n));
    case Cause::Backlash:
        return AdviceText::tr("It swings by %1 counts without end: play between motor and load.").arg(formatNumber(n));
    }
    return {};
}

QStringList remedyTexts(const Family &family, const std::vector<std::pair<std::string, double>> &changes)
{
    QStringList parts;
    for (const auto &[key, value] : changes) {
        const auto index = findParameter(family.parameters, key);
        if (!index)
            continue;
        const Parameter &parameter = family.parameters[index->value];
        parts << QStringLiteral("%1 = %2").arg(shortName(parameter), shortNumber(parameter, value));
    }
    return parts;
}

AdvicePanel::AdvicePanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    m_column = layoutIn<QVBoxLayout>(this, theme.theme().u(4));
    hide();
}

void AdvicePanel::setTrial(const Family *family, const tuning::Trial *trial)
{
    std::vector<tuning::Advice> now;
    if (family && trial)
        now = tuning::advise(*family, *trial);
    const auto windup = std::ranges::find(now, Cause::Windup, &tuning::Advice::cause);
    m_windup = windup == now.end() ? std::nullopt : std::optional(windup->number);
    if (now.size() > mostShown)
        now.resize(mostShown);
    if (now == m_advice)
        return;
    m_advice = std::move(now);
    rebuild(family);
}

void AdvicePanel::rebuild(const Family *family)
{
    while (QLayoutItem *item = m_column->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    setVisible(!m_advice.empty());
    if (m_advice.empty())
        return;
    m_column->addWidget(new SectionLabel(tr("Why it did that"), this));
    for (const tuning::Advice &advice : m_advice) {
        m_column->addWidget(wrappedLabel(adviceText(advice), TextRole::Body, Tone::Text, this));
        const QStringList remedies = family ? remedyTexts(*family, advice.changes) : QStringList();
        if (remedies.isEmpty())
            continue;
        QPushButton *const button
            = linkButton(AdviceText::tr("Stage %1").arg(remedies.join(QStringLiteral(",\n"))), this);
        button->setToolTip(tr("Stages these values; nothing is written yet."));
        m_column->addWidget(button, 0, Qt::AlignLeft);
        connect(button, &QPushButton::clicked, this, [this, advice] { Q_EMIT stageRequested(advice); });
    }
}

} // namespace mb
