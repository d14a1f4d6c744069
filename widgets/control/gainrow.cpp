// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/gainrow.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/logslider.h"
#include "widgets/control/resolutionmeter.h"
#include "widgets/control/wrappedlabel.h"
#include "widgets/parameters/leap.h"

#include <QLineEdit>
#include <QPushButton>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mb {
namespace {

constexpr int notch = QWheelEvent::DefaultDeltasPerStep;
constexpr int fieldWidth = 104;
constexpr int nameWidth = 22;
constexpr int boundNameWidth = 108;

GlyphState glyphOf(const ParameterStore::Entry &entry)
{
    switch (entry.state) {
    case ParameterState::Stored: return GlyphState::Stored;
    case ParameterState::Ram: return GlyphState::InRam;
    case ParameterState::Volatile: return GlyphState::Volatile;
    case ParameterState::Assumed: return GlyphState::Assumed;
    case ParameterState::Unknown:
    case ParameterState::Failed: break;
    }
    return GlyphState::Gone;
}

} // namespace

GainRow::GainRow(const ThemeSource &theme, Kind kind, StagedEdits &edits, ParameterIndex index, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_kind(kind)
    , m_edits(edits)
    , m_index(index)
    , m_parameter(edits.parameter(index))
{
    auto *grid = layoutIn<QGridLayout>(this, -1, {0, theme.theme().u(4), 0, theme.theme().u(4)});
    grid->setHorizontalSpacing(theme.theme().u(4));
    grid->setVerticalSpacing(theme.theme().u(2));
    grid->setColumnStretch(2, 1);
    buildFirstLine(*grid);
    if (kind == Kind::Gain)
        buildSecondLine(*grid);
    m_fault = wrappedLabel({}, TextRole::Caption, Tone::Danger, this);
    m_fault->hide();
    grid->addWidget(m_fault, 3, 0, 1, 5);
    m_use = linkButton(tr("Use it"), this);
    m_use->setAccessibleName(tr("Use this %1").arg(tableText(m_parameter.label)));
    m_use->hide();
    grid->addWidget(m_use, 3, 5);
    connect(m_use, &QPushButton::clicked, this, [this] { m_edits.confirm(m_index); });
    connect(m_field, &QLineEdit::textEdited, this, &GainRow::typed);
    connect(m_field, &QLineEdit::editingFinished, this, [this] {
        if (m_edits.typing() == m_index)
            m_edits.endTyping(true);
    });
    connect(m_revert, &QToolButton::clicked, this, [this] { m_edits.revert(m_index); });
}

void GainRow::buildFirstLine(QGridLayout &grid)
{
    const Theme &theme = m_theme.theme();
    const bool gain = m_kind == Kind::Gain;
    auto *name = new QLabel(shortName(m_parameter), this);
    setTextRole(*name, gain ? TextRole::Emphasis : TextRole::Body);
    name->setToolTip(tableText(m_parameter.help));
    name->setWordWrap(!gain);
    m_field = new NumberField(this);
    m_field->setFixedWidth(theme.u(fieldWidth));
    m_field->setAccessibleName(tableText(m_parameter.label));
    m_field->setPlaceholderText(UnknownMark);
    name->setBuddy(m_field);
    if (gain)
        m_field->installEventFilter(this);
    m_unit = wrappedLabel({}, TextRole::Caption, Tone::Dim, this);
    m_glyph = new StateGlyph(m_theme, GlyphState::Gone, this);
    m_word = textLabel({}, TextRole::Caption, Tone::Dim, this);
    m_revert = new IconButton(m_theme, Symbol::Undo, tr("Revert %1").arg(tableText(m_parameter.label)), this);
    auto *left = new QWidget(this);
    left->setFixedWidth(theme.u(gain ? nameWidth : boundNameWidth));
    auto *names = layoutIn<QVBoxLayout>(left, 0);
    names->addWidget(name);
    if (gain)
        grid.addWidget(m_unit, 0, 2);
    else
        names->addWidget(m_unit);
    grid.addWidget(left, 0, 0);
    grid.addWidget(m_field, 0, 1);
    grid.addWidget(m_glyph, 0, 3);
    grid.addWidget(m_word, 0, 4);
    grid.addWidget(m_revert, 0, 5);
}

void GainRow::buildSecondLine(QGridLayout &grid)
{
    const Theme &theme = m_theme.theme();
    m_detail = new QWidget(this);
    auto *inner = layoutIn<QGridLayout>(m_detail, -1, {theme.u(nameWidth + 4), 0, 0, 0});
    inner->setHorizontalSpacing(theme.u(10));
    inner->setVerticalSpacing(0);
    m_slider = new LogSlider(m_theme, m_detail);
    m_slider->setAccessibleName(tr("%1, one decade either way").arg(tableText(m_parameter.label)));
    m_slider->setToolTip(tr("One decade either way. ← → 2 %, with Shift 0.2 %, with Ctrl 20 %"));
    m_meter = new ResolutionMeter(m_theme, m_detail);
    m_raw = textLabel({}, TextRole::Raw, Tone::Dim, m_detail);
    inner->addWidget(m_slider, 0, 0);
    inner->addWidget(m_meter, 0, 1);
    inner->addWidget(m_raw, 1, 0, 1, 2);
    inner->setColumnStretch(0, 1);
    grid.addWidget(m_detail, 1, 0, 1, 6);
    connect(m_slider, &LogSlider::numberChosen, this, &GainRow::chosen);
    connect(m_slider, &LogSlider::choiceEnded, this, [this] {
        m_sliding = false;
        m_edits.endTyping(true);
    });
}

void GainRow::setUnit(const QString &unit)
{
    m_unit->setText(unit);
    m_unit->setVisible(!unit.isEmpty());
    m_field->setToolTip(unit);
}

void GainRow::focusField()
{
    m_field->setFocus(Qt::ShortcutFocusReason);
    m_field->selectAll();
}

bool GainRow::eventFilter(QObject *watched, QEvent *event)
{
    constexpr double step = 1.02;
    if (event->type() != QEvent::Wheel || watched != m_field || !m_field->hasFocus())
        return QWidget::eventFilter(watched, event);
    m_turned += static_cast<const QWheelEvent &>(*event).angleDelta().y();
    for (; std::abs(m_turned) >= notch; m_turned -= m_turned > 0 ? notch : -notch)
        multiply(m_turned > 0 ? step : 1.0 / step);
    event->accept();
    return true;
}

void GainRow::multiply(double factor)
{
    const auto now = number();
    if (!now || *now == 0.0)
        return;
    chosen(*now * factor);
    m_sliding = false;
    m_edits.endTyping(true);
}

void GainRow::chosen(double number)
{
    m_sliding = true;
    const double bounded = std::clamp(number, m_parameter.minimum, m_parameter.maximum);
    const auto raw = toRaw(m_parameter, m_parameter.type == WireType::Fixed16x16 ? bounded : std::round(bounded));
    if (raw)
        m_edits.type(m_index, fieldText(m_parameter, *raw));
}

std::optional<double> GainRow::number() const
{
    const StagedEdit *edit = m_edits.find(m_index);
    const auto raw = edit ? edit->value.raw : m_edits.known(m_index);
    if (!raw)
        return std::nullopt;
    return static_cast<double>(*raw) / m_parameter.one;
}

void GainRow::refresh(const ParameterStore::Entry &entry)
{
    const StagedEdit *edit = m_edits.find(m_index);
    const bool typing = m_field->hasFocus() && m_edits.typing() == m_index && !m_sliding;
    const QString text = edit ? edit->text : entry.raw ? fieldText(m_parameter, *entry.raw) : QString();
    if (!typing && m_field->text() != text) {
        m_field->setText(text);
        m_field->setCursorPosition(0); // the leading digits are the ones that matter
    }
    m_field->setEnabled(entry.raw.has_value() || m_parameter.access == Access::WriteOnly);
    showState(entry, edit);
    showNumbers(edit ? edit->value.raw : entry.raw, edit != nullptr);
}

QString GainRow::shortWord(GlyphState state) const
{
    switch (state) {
    case GlyphState::Stored: return tr("stored");
    case GlyphState::InRam: return tr("RAM");
    case GlyphState::Volatile: return tr("volatile");
    case GlyphState::Assumed: return tr("assumed");
    case GlyphState::Edited: return tr("edited");
    case GlyphState::OutOfRange: return tr("range");
    case GlyphState::Busy: return tr("reading");
    default: return tr("unknown");
    }
}

void GainRow::showState(const ParameterStore::Entry &entry, const StagedEdit *edit)
{
    const bool illegal = edit && !edit->value.raw;
    GlyphState state = glyphOf(entry);
    if (edit)
        state = illegal ? GlyphState::OutOfRange : GlyphState::Edited;
    else if (!entry.raw && m_reading)
        state = GlyphState::Busy;
    m_glyph->setState(state);
    m_word->setText(shortWord(state));
    setTone(*m_word, glyphTone(state));
    const QString was
        = entry.raw ? tr("edited, was %1").arg(valueWithUnit(m_parameter, *entry.raw)) : tr("edited, was unknown");
    m_word->setToolTip(edit ? was : glyphWord(state));
    m_revert->setEnabled(edit != nullptr);
    setStyleProperty(*m_field, "state", illegal ? QStringLiteral("error") : QString());
    const auto factor = m_edits.unconfirmed(m_index);
    m_fault->setText(illegal ? edit->value.fault + QLatin1Char(' ') + edit->value.remedy
            : factor         ? leapText(m_parameter, *m_edits.known(m_index), *factor)
                             : QString());
    setTone(*m_fault, illegal ? Tone::Danger : Tone::Caution);
    m_fault->setVisible(illegal || factor);
    m_use->setVisible(factor.has_value());
}

void GainRow::showNumbers(std::optional<std::int64_t> raw, bool edited)
{
    if (m_kind != Kind::Gain)
        return;
    const bool folded = raw == 0 && !edited; // a gain that is off takes one line
    m_detail->setVisible(!folded);
    const double number = raw ? static_cast<double>(*raw) / m_parameter.one : 0.0;
    if (!m_sliding) {
        m_slider->setCentre(number);
        m_slider->showNumber(number);
    }
    m_meter->setSteps(raw ? std::abs(*raw) : 0);
    m_raw->setText(raw ? tr("raw %1   %2").arg(QString::number(*raw).replace(QLatin1Char('-'), MinusSign), m_physical)
            : m_parameter.access == Access::WriteOnly ? tr("unknown until written")
                                                      : QString());
    m_raw->setToolTip(raw ? rawText(m_parameter, *raw) : QString());
}

} // namespace mb
