// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/tuningsteps.h"

#include "files/qttext.h"
#include "model/loopparameters.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/stateglyph.h"
#include "widgets/common/wraplayout.h"
#include "widgets/control/wrappedlabel.h"
#include "widgets/design/proposalcard.h"
#include "widgets/design/stepcurves.h"

#include <QPainter>

#include <cmath>

namespace mb {
namespace {

constexpr std::size_t mostLines = 9;

class StepNumber : public QWidget {
public:
    StepNumber(const ThemeSource &theme, int number, QWidget *parent)
        : QWidget(parent)
        , m_theme(theme)
        , m_number(number)
    {
        setFixedSize(theme.theme().u(20), theme.theme().u(20));
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        const Theme &look = m_theme.theme();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(look.outline, 1));
        painter.drawEllipse(QRectF(rect()).adjusted(1, 1, -1, -1));
        painter.setPen(look.text);
        painter.setFont(look.font(TextRole::Caption, font()));
        painter.drawText(rect(), Qt::AlignCenter, QString::number(m_number));
    }

private:
    const ThemeSource &m_theme;
    int m_number;
};

QString stepPercent(double share)
{
    return formatNumber(share * 100.0, 1);
}

/// No line ends between a number and its unit, nor behind "≤".
QString withUnits(QString text)
{
    text.replace(QStringLiteral(" %"), QStringLiteral("\u00A0%"));
    return text.replace(QStringLiteral("≤ "), QStringLiteral("≤\u00A0"));
}

QString limitsText(const tuning::ProofLimits &limits)
{
    return withUnits(limits.settle
            ? TuningSteps::tr("over ≤ %1 %, settle ≤ %2, error ≤ %3 %")
                  .arg(stepPercent(limits.overshoot), formatDuration(*limits.settle), stepPercent(limits.error))
            : TuningSteps::tr("over ≤ %1 %, error ≤ %2 %")
                  .arg(stepPercent(limits.overshoot), stepPercent(limits.error)));
}

QString measuredText(const tuning::Metrics &measured)
{
    return withUnits(TuningSteps::tr("over %1 %, settle %2, error %3 %")
                         .arg(measured.overshoot ? stepPercent(*measured.overshoot) : QString(UnknownMark),
                             measured.settle ? formatDuration(*measured.settle) : QString(UnknownMark),
                             measured.sse ? stepPercent(std::abs(*measured.sse)) : QString(UnknownMark)));
}

bool isGood(tuning::TuneResult result)
{
    return result == tuning::TuneResult::Kept || result == tuning::TuneResult::Proposed;
}

} // namespace

QString resultText(const tuning::TuneReport &report)
{
    switch (report.result) {
    case tuning::TuneResult::Kept: return TuningSteps::tr("Kept");
    case tuning::TuneResult::Proposed: return TuningSteps::tr("Proposed, nothing written");
    case tuning::TuneResult::RolledBack:
        return isPutBack(report) ? TuningSteps::tr("Rolled back") : TuningSteps::tr("Not kept");
    case tuning::TuneResult::Refused: return TuningSteps::tr("Refused");
    case tuning::TuneResult::Stopped: return TuningSteps::tr("Stopped");
    }
    return {};
}

TuningSteps::TuningSteps(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const Theme &look = theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, look.u(5));
    column->addWidget(buildHead());
    m_state = new QVBoxLayout;
    m_state->setSpacing(look.u(5));
    column->addLayout(m_state);
    auto *row = new QHBoxLayout;
    m_glyph = new StateGlyph(theme, GlyphState::Waiting, this);
    m_head = wrappedLabel({}, TextRole::Emphasis, Tone::Text, this);
    row->addWidget(m_glyph, 0, Qt::AlignTop);
    row->addWidget(m_head, 1);
    m_state->addLayout(row);
    m_words = wrappedLabel({}, TextRole::Caption, Tone::Dim, this);
    m_lines = new QVBoxLayout;
    m_lines->setSpacing(look.u(5));
    column->addLayout(m_lines);
    m_pushes = wrappedLabel({}, TextRole::Caption, Tone::Dim, this);
    column->addWidget(m_pushes);
    show(nullptr, nullptr, nullptr, {});
}

/// The title, and how long the motor will turn.
QWidget *TuningSteps::buildHead()
{
    auto *top = new QWidget(this);
    auto *wrap = new WrapLayout(top);
    wrap->setContentsMargins(0, 0, 0, 0);
    wrap->addWidget(new SectionLabel(tr("What happens"), top));
    wrap->addSpring();
    m_time = new QWidget(top);
    auto *time = layoutIn<QHBoxLayout>(m_time, m_theme.theme().u(6));
    m_seconds = new QLabel(m_time);
    setTextRole(*m_seconds, TextRole::Caption);
    setTone(*m_seconds, Tone::Caution);
    time->addWidget(new StateGlyph(m_theme, GlyphState::Moving, m_time));
    time->addWidget(m_seconds);
    wrap->addWidget(m_time);
    return top;
}

void TuningSteps::show(
    const OperationView *running, const tuning::TuneReport *report, const Ahead *ahead, const Envelope &inForce)
{
    showState(running, report);
    const QString bounds = inForce.travel ? messageText(textOf(tuning::extentOf(inForce))) : QString();
    m_pushes->setText(tr("Identify and Autotune push first: %1").arg(bounds));
    m_pushes->setVisible(ahead && !running && !bounds.isEmpty());
    const bool tells = ahead && !running;
    m_time->setVisible(tells);
    if (tells)
        m_seconds->setText(tr("motor turns %1 s").arg(formatNumber(std::ceil(ahead->course.seconds))));
    say(running ? stepsOf(*running) : ahead ? stepsOf(*ahead, report) : stepsFromTheBeginning(bounds), !running);
}

void TuningSteps::showState(const OperationView *running, const tuning::TuneReport *report)
{
    if (running) {
        m_glyph->setState(GlyphState::Moving);
        m_head->setText(tr("Working: the motor turns"));
        m_words->setText(tr("STOP ends it at any moment; what was changed is put back."));
    } else if (report) {
        m_glyph->setState(isGood(report->result) ? GlyphState::Done : GlyphState::Warning);
        m_head->setText(resultText(*report));
        m_words->setText(messageText(report->evidence));
    } else {
        m_glyph->setState(GlyphState::Waiting);
        m_head->setText(tr("Nothing has moved yet"));
        m_words->clear();
    }
    m_isGood = report && !running && isGood(report->result);
    m_words->setVisible(!m_words->text().isEmpty());
    placeEvidence();
}

void TuningSteps::setEvidenceLast(bool last)
{
    m_isEvidenceLast = last;
    placeEvidence();
}

void TuningSteps::placeEvidence()
{
    auto *const place = m_isEvidenceLast && m_isGood ? static_cast<QVBoxLayout *>(layout()) : m_state;
    if (place->indexOf(m_words) < 0)
        place->addWidget(m_words); // out of where it was
}

void TuningSteps::setBrief(bool brief)
{
    m_isBrief = brief;
    for (QLabel *words : m_always)
        words->setHidden(brief);
}

std::vector<TuningSteps::Step> TuningSteps::stepsOf(const OperationView &running)
{
    std::vector<Step> steps;
    const std::vector<LogLine> &log = running.status.log;
    for (std::size_t i = log.size() > mostLines ? log.size() - mostLines : 0; i < log.size(); ++i)
        steps.push_back({messageText(log[i].text), {}, {}});
    return steps;
}

std::vector<TuningSteps::Step> TuningSteps::stepsFromTheBeginning(const QString &bounds)
{
    return {{tr("Identify the motor"), tr("Pushes with a part of the duty, both ways. No gain is changed."), bounds},
        {tr("Choose a set"), tr("The plots show what each would do."), {}},
        {tr("Write and prove it"), tr("The gains are written, steps both ways are measured."), {}},
        {tr("Keep it, or put everything back"), tr("It stays if it does what was predicted; else the reason is said."),
            {}}};
}

/// With what it came to, where this very set was put to the proof.
std::vector<TuningSteps::Step> TuningSteps::stepsOf(const Ahead &ahead, const tuning::TuneReport *report)
{
    QStringList gains;
    for (const tuning::ScaledGains::Row &row : ahead.proposal.gains.rows) {
        if (const Role role = roleOf(ahead.family, row.key); isGain(role))
            gains << qt(gainLetter(role));
    }
    const QString written = gains.join(QStringLiteral(", "));
    const bool several = ahead.gainSlots > 1;
    const bool proven = report && !report->proof.empty() && tuning::isSameSet(report->proposed, ahead.proposal.gains);
    const QString limits = limitsText(ahead.course.limits);
    std::vector<Step> steps{
        {several ? tr("Write %1 to slot %2").arg(written).arg(ahead.course.slot) : tr("Write %1").arg(written),
            several ? tr("The slot that the result is not for; what it had comes back.")
                    : tr("What is replaced is kept, to be put back."),
            {}},
        {tr("Run %1 steps of %2 %3")
                .arg(ahead.course.steps)
                .arg(formatSignificant(ahead.proposal.step, 4), stepUnit(ahead.loop)),
            tr("Both ways, every guard on; each is a trial."), messageText(textOf(ahead.course.extent))},
        {several ? tr("Keep it in slot %1 when all hold").arg(ahead.slot) : tr("Keep it when all hold"), {},
            proven ? limits + QLatin1Char('\n') + tr("measured: %1").arg(measuredText(report->measured)) : limits},
        {tr("Else put everything back"), tr("Gains as before, the reason in the log."), {}}};
    if (ahead.isFoundAnew)
        steps.insert(steps.begin(),
            {tr("Find the gains anew"), {}, tr("Those that are shown were found for other limits, or elsewhere.")});
    return steps;
}

/// The number of a step stands in a ring.
void TuningSteps::say(std::vector<Step> steps, bool numbered)
{
    if (steps == m_said)
        return;
    m_said = std::move(steps);
    while (QLayoutItem *item = m_lines->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_always.clear();
    int number = 0;
    for (const Step &step : m_said) {
        QWidget *const line = lineOf(step, numbered ? ++number : 0);
        m_lines->addWidget(line);
        line->show();
    }
    Q_EMIT rebuilt();
}

/// Without a number: what was done.
QWidget *TuningSteps::lineOf(const Step &step, int number)
{
    auto *const box = new QWidget(this);
    auto *const grid = layoutIn<QGridLayout>(box);
    grid->setHorizontalSpacing(m_theme.theme().u(8));
    grid->setVerticalSpacing(0);
    grid->setColumnStretch(1, 1);
    if (number > 0)
        grid->addWidget(new StepNumber(m_theme, number, box), 0, 0, 3, 1, Qt::AlignTop);
    const TextRole role = number > 0 ? TextRole::Body : TextRole::Caption;
    grid->addWidget(wrappedLabel(step.head, role, Tone::Text, box), 0, 1);
    if (!step.always.isEmpty()) {
        QLabel *const always = wrappedLabel(step.always, TextRole::Caption, Tone::Dim, box);
        grid->addWidget(always, 1, 1);
        always->setHidden(m_isBrief);
        box->setToolTip(step.always);
        m_always.push_back(always);
    }
    if (!step.words.isEmpty())
        grid->addWidget(wrappedLabel(step.words, TextRole::Caption, Tone::Dim, box), 2, 1);
    return box;
}

} // namespace mb
