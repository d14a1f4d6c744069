// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/modelpanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/stateglyph.h"
#include "widgets/control/wrappedlabel.h"

#include <algorithm>

namespace mb {
namespace {

constexpr int halfWidth = 140; ///< units, of two gates beside each other

enum Column { NameColumn, ValueColumn, ErrorColumn, UnitColumn };

QString filterText(const tuning::VelocityFilter &filter)
{
    switch (filter.kind) {
    case tuning::VelocityFilter::Kind::None: return ModelPanel::tr("as fresh as the position");
    case tuning::VelocityFilter::Kind::Rolling: return ModelPanel::tr("rolling, %1").arg(formatDuration(filter.window));
    case tuning::VelocityFilter::Kind::Block: return ModelPanel::tr("block, %1").arg(formatDuration(filter.window));
    }
    return {};
}

} // namespace

ModelPanel::ModelPanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const Theme &look = theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, look.u(4));
    auto *head = new QHBoxLayout;
    head->addWidget(new SectionLabel(tr("Model"), this));
    head->addStretch(1);
    m_glyph = new StateGlyph(theme, GlyphState::Gone, this);
    m_verdict = textLabel({}, TextRole::Emphasis, Tone::Text, this);
    head->addWidget(m_glyph);
    head->addWidget(m_verdict);
    column->addLayout(head);
    m_box = new QWidget(this);
    column->addWidget(m_box);
    setReport(nullptr);
}

void ModelPanel::addFigure(
    int row, const QString &name, double value, std::optional<double> error, int digits, const QString &unit)
{
    m_grid->addWidget(textLabel(name, TextRole::Body, Tone::Text, m_box), row, NameColumn);
    m_grid->addWidget(textLabel(formatSignificant(value, digits), TextRole::Emphasis, Tone::Text, m_box), row,
        ValueColumn, Qt::AlignRight);
    if (error)
        m_grid->addWidget(
            textLabel(QStringLiteral("± ") + formatSignificant(*error, 2), TextRole::Body, Tone::Dim, m_box), row,
            ErrorColumn);
    m_grid->addWidget(textLabel(unit, TextRole::Caption, Tone::Dim, m_box), row, UnitColumn);
}

/// Two beside each other where both are short; a long one has the width for itself.
void ModelPanel::addGates(const std::vector<tuning::Gate> &gates)
{
    auto *const box = new QWidget(m_box);
    auto *const grid = layoutIn<QGridLayout>(box);
    grid->setHorizontalSpacing(m_theme.theme().u(10));
    grid->setVerticalSpacing(m_theme.theme().u(2));
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    const QFontMetrics metrics(m_theme.theme().font(TextRole::Caption, font()));
    int row = 0;
    int column = 0;
    for (const tuning::Gate &gate : gates) {
        const QString words = messageText(gate.detail);
        const bool isLong = metrics.horizontalAdvance(words) > m_theme.theme().u(halfWidth);
        if (isLong && column == 1)
            ++row;
        column = isLong ? 0 : column;
        auto *line = new QWidget(box);
        auto *const parts = layoutIn<QHBoxLayout>(line, m_theme.theme().u(5));
        parts->addWidget(
            new StateGlyph(m_theme, gate.passed ? GlyphState::Done : GlyphState::Warning, line), 0, Qt::AlignTop);
        parts->addWidget(wrappedLabel(words, TextRole::Caption, gate.passed ? Tone::Dim : Tone::Caution, line), 1);
        grid->addWidget(line, row, column, 1, isLong ? 2 : 1, Qt::AlignTop);
        row += isLong || column == 1 ? 1 : 0;
        column = isLong ? 0 : 1 - column;
    }
    m_grid->addWidget(box, m_grid->rowCount(), NameColumn, 1, 4);
}

void ModelPanel::setReport(const tuning::TuneReport *report)
{
    delete m_grid;
    qDeleteAll(m_box->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly));
    m_grid = layoutIn<QGridLayout>(m_box);
    m_grid->setVerticalSpacing(m_theme.theme().u(1));
    m_grid->setHorizontalSpacing(m_theme.theme().u(10));
    m_grid->setColumnStretch(UnitColumn, 1);
    const bool known = report && report->motor;
    m_glyph->setVisible(known);
    m_verdict->setVisible(known);
    if (!known) {
        m_grid->addWidget(
            wrappedLabel(tr("Nobody has identified this motor yet. Identify pushes it both ways with a part of the "
                            "duty, inside the limits below, and changes no gain."),
                TextRole::Body, Tone::Dim, m_box),
            0, 0);
        return;
    }
    const tuning::MotorFound &motor = *report->motor;
    const bool good
        = std::all_of(report->gates.begin(), report->gates.end(), [](const tuning::Gate &gate) { return gate.passed; });
    m_glyph->setState(good ? GlyphState::Done : GlyphState::Warning);
    m_verdict->setText(good ? tr("good fit") : tr("not believed"));
    addFigure(0, tr("gain K"), motor.line.gain, motor.line.gainError, 4,
        motor.unit == tuning::MotorFound().unit ? tr("counts/s") : tableText(motor.unit));
    addFigure(1, tr("lag τ"), 1e3 * motor.pushes.tau, 1e3 * motor.pushes.tauError, 3, tr("ms"));
    addFigure(2, tr("dead time θ"), 1e3 * report->plant.delay, 1e3 * motor.pushes.delayError, 3, tr("ms"));
    addFigure(3, tr("friction kS"), 100.0 * motor.line.friction, 100.0 * motor.line.frictionError, 3, tr("% duty"));
    if (motor.filter) {
        m_grid->addWidget(textLabel(tr("velocity filter"), TextRole::Body, Tone::Text, m_box), 4, NameColumn);
        m_grid->addWidget(
            textLabel(filterText(*motor.filter), TextRole::Emphasis, Tone::Text, m_box), 4, ValueColumn, 1, 3);
    }
    addGates(report->gates);
}

} // namespace mb
