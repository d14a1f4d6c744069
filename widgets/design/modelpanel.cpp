// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/modelpanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/stateglyph.h"
#include "widgets/control/wrappedlabel.h"

#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr int halfWidth = 140;    ///< units, of two gates beside each other
constexpr std::size_t inLine = 4; ///< figures

enum Column { NameColumn, ValueColumn, ErrorColumn, UnitColumn };

/// Counts of a velocity have no room for what they are counted by.
QString unitText(const Message &unit)
{
    return unit.english() == tuning::MotorFound().unit ? ModelPanel::tr("counts/s") : messageText(unit);
}

QString withUnit(double value, const char *unit)
{
    return formatSignificant(value, 4) + QChar(0x00A0) + QString::fromUtf8(unit);
}

/// Those that a loop is designed on, by their letters.
int digitsBeforePoint(double value)
{
    return value == 0.0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
}

/// As far as its ± reaches: the last digit is one of those that the ± has.
QString valueText(const ModelFigure &figure)
{
    constexpr int digitsOfError = 2;
    constexpr int mostDigits = 6;
    const double error = figure.error.value_or(0.0);
    if (!(error >= 1e-4) || !std::isfinite(figure.value))
        return formatSignificant(figure.value, figure.digits);
    const int meant = std::max(0, digitsOfError - digitsBeforePoint(error));
    return formatNumber(figure.value, std::min(meant, std::max(0, mostDigits - digitsBeforePoint(figure.value))));
}

QString lineText(const std::vector<ModelFigure> &figures)
{
    QStringList words;
    for (std::size_t i = 0; i < std::min(figures.size(), inLine); ++i)
        words << QStringLiteral("%1 %2 %3")
                     .arg(figures[i].symbol, formatSignificant(figures[i].value, i + 1 < inLine ? 3 : 2),
                         figures[i].unit.section(QLatin1Char(' '), 0, 0));
    return words.join(QStringLiteral(", "));
}

} // namespace

ModelPanel::ModelPanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this, theme.theme().u(4));
    column->addWidget(buildHead());
    m_box = new QWidget(this);
    column->addWidget(m_box);
    setReport(nullptr);
}

QWidget *ModelPanel::buildHead()
{
    auto *head = new QWidget(this);
    auto *const grid = layoutIn<QGridLayout>(head, 0);
    auto *const row = new QHBoxLayout;
    row->setSpacing(m_theme.theme().u(6));
    row->addWidget(new SectionLabel(tr("Model"), head));
    m_glyph = new StateGlyph(m_theme, GlyphState::Gone, head);
    m_verdict = textLabel({}, TextRole::Emphasis, Tone::Text, head);
    m_more = linkButton({}, head);
    m_line = textLabel({}, TextRole::Caption, Tone::Dim, head);
    m_line->hide();
    row->addWidget(m_glyph);
    row->addWidget(m_verdict);
    row->addStretch(1);
    grid->addLayout(row, 0, 0);
    grid->addWidget(m_more, 0, 1);
    grid->addWidget(m_line, 1, 0, 1, 2);
    grid->setColumnStretch(0, 1);
    connect(m_more, &QPushButton::clicked, this, [this] { Q_EMIT wanted(m_isFolded); });
    return head;
}

void ModelPanel::setFolded(bool folded)
{
    m_isFolded = folded && m_mayFold;
    m_line->setVisible(m_isFolded);
    m_box->setVisible(!m_isFolded);
    m_more->setVisible(m_mayFold);
    m_more->setText(m_isFolded ? tr("All figures") : tr("Fold"));
}

void ModelPanel::addFigure(const ModelFigure &figure)
{
    const int row = m_grid->rowCount();
    m_grid->addWidget(textLabel(figure.name, TextRole::Body, Tone::Text, m_box), row, NameColumn);
    const auto number = [this](const QString &text, TextRole role, Tone tone) { // never cut
        auto *const label = new QLabel(text, m_box);
        setTextRole(*label, role);
        setTone(*label, tone);
        return label;
    };
    m_grid->addWidget(number(valueText(figure), TextRole::Emphasis, Tone::Text), row, ValueColumn, Qt::AlignRight);
    if (figure.error)
        m_grid->addWidget(number(QStringLiteral("± ") + formatSignificant(*figure.error, 2), TextRole::Body, Tone::Dim),
            row, ErrorColumn);
    m_grid->addWidget(textLabel(figure.unit, TextRole::Caption, Tone::Dim, m_box), row, UnitColumn);
}

/// What is no number.
void ModelPanel::addWords(const QString &name, const QString &words)
{
    const int row = m_grid->rowCount();
    m_grid->addWidget(textLabel(name, TextRole::Body, Tone::Text, m_box), row, NameColumn);
    m_grid->addWidget(textLabel(words, TextRole::Emphasis, Tone::Text, m_box), row, ValueColumn, 1, 3);
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

void ModelPanel::showNothing()
{
    m_grid->addWidget(wrappedLabel(tr("Nobody has identified this motor yet. Identify pushes it both ways with a part "
                                      "of the duty, inside the limits below, and changes no gain."),
                          TextRole::Body, Tone::Dim, m_box),
        0, 0);
}

void ModelPanel::showFigures(const tuning::TuneReport &report)
{
    const std::vector<ModelFigure> figures = modelFigures(report, unitText);
    for (const ModelFigure &figure : figures)
        addFigure(figure);
    m_line->setText(lineText(figures));
    if (const auto &filter = report.motor->filter)
        addWords(tr("velocity filter"), filterWords(filter->kind, formatDuration(filter->window)));
    if (report.profile)
        m_grid->addWidget(wrappedLabel(profileWords(withUnit(report.profile->speed, "counts/s"),
                                           withUnit(report.profile->acceleration, "counts/s²")),
                              TextRole::Caption, Tone::Dim, m_box),
            m_grid->rowCount(), NameColumn, 1, 4);
    addGates(report.gates);
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
    const bool good = known && std::ranges::all_of(report->gates, [](const tuning::Gate &gate) { return gate.passed; });
    m_mayFold = good;
    m_glyph->setVisible(known);
    m_verdict->setVisible(known);
    m_glyph->setState(good ? GlyphState::Done : GlyphState::Warning);
    m_verdict->setText(good ? tr("good fit") : tr("not believed"));
    if (known)
        showFigures(*report);
    else
        showNothing();
    setFolded(m_isFolded);
}

} // namespace mb
