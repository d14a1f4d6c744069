// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunesteps.h"

#include "widgets/common/stateglyph.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace mb {
namespace {

constexpr int discSize = 18;
constexpr int wordGap = 6;
constexpr int stepGap = 14;

/// The trial ended well and ran with what is in the device now.
bool isOfTheseGains(const TuneKnowledge &known)
{
    if (!known.newest || known.newest->trial.reason != tuning::EndReason::Done || known.gains.empty())
        return false;
    return std::ranges::all_of(known.gains, [&known](ParameterIndex index) {
        const Parameter &row = known.device->family->parameters[index.value];
        const auto &gains = known.newest->trial.gains;
        const auto found = std::ranges::find_if(gains, [&](const auto &entry) { return entry.first == row.key; });
        if (found == gains.end() || !found->second)
            return false;
        const auto raw = toRaw(row, *found->second);
        return raw && (*known.device->parameters)[index.value].raw == *raw;
    });
}

bool allAre(const TuneKnowledge &known, bool (*is)(const ParameterStore::Entry &))
{
    return !known.gains.empty() && std::ranges::all_of(known.gains, [&](ParameterIndex index) {
        return is((*known.device->parameters)[index.value]);
    });
}

} // namespace

TuneSteps::TuneSteps(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("tuneSteps"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    followTheme(theme, *this);
    tell();
}

QString TuneSteps::wordOf(int step)
{
    const std::array<QString, StepCount> words{
        tr("Direction"), tr("Envelope"), tr("Identify"), tr("Gains"), tr("Verify"), tr("Store")};
    return words.at(static_cast<std::size_t>(step));
}

void TuneSteps::show(const TuneKnowledge &known)
{
    setVisible(known.device && !known.gains.empty());
    if (isHidden())
        return;
    const auto &verdicts = known.device->profile->verdicts;
    const auto verdict = verdicts.find(directionKey(known.axis));
    const bool ofTheseGains = isOfTheseGains(known) && !known.staged;
    const bool stored
        = allAre(known, [](const ParameterStore::Entry &entry) { return entry.state == ParameterState::Stored; });
    const bool isChecked = verdict != verdicts.end();
    m_done[Direction] = isChecked && verdict->second == DirectionVerdict::Agrees;
    m_done[Envelope] = known.missing.isEmpty();
    m_done[Identify] = known.identified > 0;
    m_done[Gains] = !known.staged && allAre(known, [](const auto &entry) { return entry.raw.has_value(); });
    m_done[Verify] = ofTheseGains;
    m_done[Store] = stored && !known.staged;
    m_tips[Direction] = m_done[Direction]
        ? tr("The direction of motor and encoder was checked; the first closed loop of a run checks it again.")
        : isChecked ? tr("The last check found it wrong: the encoder is reversed, or the motor did not move.")
                    : tr("Checked by itself before the first closed loop of a run.");
    m_tips[Envelope] = m_done[Envelope] ? tr("Every limit of an experiment is known.") : known.missing;
    m_tips[Identify] = m_done[Identify] ? tr("Trial #%1 pushed the motor without a loop.").arg(known.identified)
                                        : tr("No model of the motor yet: the page Design identifies it.");
    m_tips[Gains] = m_done[Gains] ? tr("The device has the gains that are shown.")
        : known.staged            ? tr("Edited gains wait to be written.")
                                  : tr("The gains of the device are not known yet.");
    m_tips[Verify] = m_done[Verify] ? tr("Trial #%1 ran with these gains.").arg(known.newest->number)
                                    : tr("No trial with these gains yet: Run makes one.");
    m_tips[Store] = m_done[Store] ? tr("The gains are in flash.") : tr("The gains are not known to be in flash.");
    tell();
    update();
}

int TuneSteps::next() const
{
    return static_cast<int>(std::ranges::find(m_done, false) - m_done.begin());
}

void TuneSteps::tell()
{
    QStringList words;
    for (int step = 0; step < StepCount; ++step)
        words << (m_done.at(static_cast<std::size_t>(step)) ? tr("%1: done", "step").arg(wordOf(step)) : wordOf(step));
    setAccessibleName(next() < StepCount ? tr("Steps; next is %1").arg(wordOf(next())) : tr("Steps; all are done"));
    setAccessibleDescription(words.join(QStringLiteral(", ")));
}

void TuneSteps::setFolded(bool folded)
{
    if (folded == m_folded)
        return;
    m_folded = folded;
    updateGeometry();
    update();
}

QFont TuneSteps::fontOf(int step) const
{
    return m_theme.theme().font(step == next() ? TextRole::Emphasis : TextRole::Body, font());
}

int TuneSteps::widthOfStep(int step, bool folded) const
{
    const Theme &theme = m_theme.theme();
    QFont bold = m_theme.theme().font(TextRole::Emphasis, font()); // so that nothing moves with the next step
    const bool worded = !folded || step == next();
    return theme.u(discSize) + (worded ? theme.u(wordGap) + QFontMetrics(bold).horizontalAdvance(wordOf(step)) : 0);
}

int TuneSteps::widthOf(bool folded) const
{
    int width = 0;
    for (int step = 0; step < StepCount; ++step)
        width += widthOfStep(step, folded) + (step > 0 ? m_theme.theme().u(folded ? stepGap / 2 : stepGap) : 0);
    return width;
}

QSize TuneSteps::sizeHint() const
{
    return {widthOf(m_folded), m_theme.theme().u(32)};
}

void TuneSteps::paintDisc(QPainter &painter, const QRect &box, int step) const
{
    const Theme &theme = m_theme.theme();
    if (m_done.at(static_cast<std::size_t>(step))) {
        const int side = theme.u(12);
        paintGlyph(
            painter, QRectF(box.center() - QPoint(side / 2, side / 2), QSizeF(side, side)), GlyphState::Done, theme.ok);
        return;
    }
    const bool now = step == next();
    painter.setPen(QPen(now ? theme.fill : theme.outline, 1));
    painter.setBrush(now ? QBrush(theme.fill) : QBrush(Qt::NoBrush));
    painter.drawEllipse(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setPen(now ? theme.onFill : theme.dim);
    painter.setFont(theme.font(TextRole::Caption, font()));
    painter.drawText(box, Qt::AlignCenter, QString::number(step + 1));
}

void TuneSteps::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int disc = theme.u(discSize);
    const int gap = theme.u(m_folded ? stepGap / 2 : stepGap);
    int left = 0;
    for (int step = 0; step < StepCount; ++step) {
        paintDisc(painter, QRect(left, (height() - disc) / 2, disc, disc), step);
        const int width = widthOfStep(step, m_folded);
        if (width > disc) {
            painter.setFont(fontOf(step));
            painter.setPen(step > next() && !m_done.at(static_cast<std::size_t>(step)) ? theme.dim : theme.text);
            const int from = left + disc + theme.u(wordGap);
            painter.drawText(
                QRect(from, 0, left + width - from, height()), Qt::AlignLeft | Qt::AlignVCenter, wordOf(step));
        }
        left += width + gap;
    }
}

bool TuneSteps::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *const help = static_cast<QHelpEvent *>(event);
    int left = 0;
    for (int step = 0; step < StepCount; ++step) {
        const int width = widthOfStep(step, m_folded) + m_theme.theme().u(m_folded ? stepGap / 2 : stepGap);
        if (help->x() >= left && help->x() < left + width)
            QToolTip::showText(
                help->globalPos(), wordOf(step) + QStringLiteral(": ") + toolTipOf(static_cast<Step>(step)), this);
        left += width;
    }
    return true;
}

} // namespace mb
