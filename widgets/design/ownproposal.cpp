// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/ownproposal.h"

#include "files/qttext.h"
#include "model/loopparameters.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/logslider.h"
#include "widgets/control/wrappedlabel.h"
#include "widgets/design/choicemark.h"
#include "widgets/design/proposalcard.h"
#include "widgets/design/sliderscale.h"

#include <QHBoxLayout>

#include <cmath>

namespace mb {
namespace {

constexpr double hundredth = 100.0;
constexpr int sliderHeight = 24; ///< units
constexpr double notable = 1.02; ///< times slower than asked that is said

} // namespace

OwnProposal::OwnProposal(const ThemeSource &theme, QWidget *parent)
    : Card(theme, tr("own"), parent)
    , m_theme(theme)
{
    setDense(true);
    setTitle(tr("own"), tr("Speed"));
    m_mark = new ChoiceMark(theme, this);
    addHeadMark(m_mark);
    setActivatable(true);
    setAccessibleName(tr("Own proposal"));
    addSliders();
    m_gains = wrappedLabel({}, TextRole::Emphasis, Tone::Text, this);
    m_figures = wrappedLabel({}, TextRole::Caption, Tone::Dim, this);
    m_bounds = wrappedLabel({}, TextRole::Caption, Tone::Caution, this);
    for (QLabel *line : {m_gains, m_figures, m_bounds})
        body().addWidget(line);
    connect(m_speed, &LogSlider::numberChosen, this, &OwnProposal::tellWish);
    connect(m_damping, &QSlider::valueChanged, this, &OwnProposal::tellWish);
}

/// The first is named in the head of the card.
void OwnProposal::addSliders()
{
    const ThemeSource &theme = m_theme;
    m_sliders = new QVBoxLayout;
    m_sliders->setSpacing(0);
    body().addLayout(m_sliders);
    m_speed = new LogSlider(theme, this);
    m_damping = new QSlider(Qt::Horizontal, this);
    m_damping->setRange(static_cast<int>(leastMs * hundredth), static_cast<int>(mostMs * hundredth));
    m_damping->setSingleStep(1);
    m_damping->setPageStep(5);
    m_speedScale = new SliderScale(theme, tr("calm"), tr("brisk"), this);
    m_dampingScale = new SliderScale(theme, tr("robust"), tr("lively"), this);
    m_response = textLabel({}, TextRole::Emphasis, Tone::Text, this);
    m_ms = textLabel({}, TextRole::Emphasis, Tone::Text, this);
    addHeadWidget(m_response);
    addSlider(tr("Speed"), m_speed, m_speedScale);
    auto *damping = new QHBoxLayout;
    damping->addWidget(textLabel(tr("Damping"), TextRole::Body, Tone::Dim, this));
    damping->addStretch(1);
    damping->addWidget(m_ms);
    m_sliders->addLayout(damping);
    addSlider(tr("Damping"), m_damping, m_dampingScale);
}

void OwnProposal::tellWish()
{
    sayWish();
    Q_EMIT wished();
}

void OwnProposal::addSlider(const QString &name, QSlider *slider, SliderScale *scale)
{
    slider->setAccessibleName(name);
    slider->setFixedHeight(m_theme.theme().u(sliderHeight));
    m_sliders->addWidget(slider);
    m_sliders->addWidget(scale);
}

void OwnProposal::setWish(double response, double ms, double usual, double usualMs)
{
    m_speed->setCentre(1.0 / usual);
    m_speed->showNumber(1.0 / response);
    m_speedScale->setMark(0.5, tr("proposal %1").arg(formatDuration(usual)));
    m_dampingScale->setMark((usualMs - leastMs) / (mostMs - leastMs), tr("proposal %1").arg(formatNumber(usualMs, 2)));
    const QSignalBlocker quiet(m_damping);
    m_damping->setValue(static_cast<int>(std::lround(ms * hundredth)));
    sayWish();
}

double OwnProposal::response() const
{
    const double speed = m_speed->number();
    return speed > 0.0 ? 1.0 / speed : 0.0;
}

double OwnProposal::ms() const
{
    return m_damping->value() / hundredth;
}

void OwnProposal::sayWish()
{
    m_response->setText(tr("τc %1").arg(formatDuration(response())));
    m_ms->setText(tr("Ms ≤ %1").arg(formatNumber(ms(), 2)));
    m_speed->setAccessibleDescription(m_response->text());
    m_damping->setAccessibleDescription(m_ms->text());
}

void OwnProposal::show(const Result<tuning::Proposal> &proposal)
{
    m_isPossible = proposal.has_value();
    showFigures();
    if (!proposal) {
        m_bounds->setText(tr("The device cannot have this set: %1").arg(messageText(proposal.error().message())));
        m_bounds->setVisible(true);
        return;
    }
    QStringList gains;
    for (const tuning::ScaledGains::Row &row : proposal->gains.rows) {
        if (row.raw != 0 && isGain(row.role))
            gains << qt(gainLetter(row.role)) + QChar(0x00A0) + formatSignificant(row.number, 4);
    }
    m_gains->setText(gains.join(QStringLiteral(" · ")));
    m_figures->setText(figuresText(*proposal));
    QStringList bounds;
    for (const std::string_view bound : proposal->design.bounds)
        bounds << tableText(bound);
    const bool slower = proposal->design.response > notable * response();
    m_bounds->setText(slower && !bounds.isEmpty()
            ? tr("Held at τc %1 by: %2")
                  .arg(formatDuration(proposal->design.response), bounds.join(QStringLiteral(", ")))
            : QString());
    m_bounds->setVisible(!m_bounds->text().isEmpty());
}

QString OwnProposal::boundText() const
{
    return m_bounds->text();
}

void OwnProposal::setChosen(bool chosen)
{
    m_mark->setChosen(chosen);
    setEdge(chosen ? std::optional(Tone::Accent) : std::nullopt);
    showFigures();
}

/// What came of the sliders matters where it is the set that would be written.
void OwnProposal::showFigures()
{
    for (QLabel *line : {m_gains, m_figures})
        line->setVisible(m_isPossible && m_mark->isChosen());
}

} // namespace mb
