// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/unitsteps.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/wraplayout.h"
#include "widgets/firmware/queuelines.h"

namespace mb {
namespace {

using service::RowState;
using service::Step;
using service::StepEntry;

bool isPart(Step step, const service::Recipe *recipe)
{
    if (!recipe)
        return true;
    switch (step) {
    case Step::Firmware: return recipe->firmware.has_value();
    case Step::Parameters: return recipe->parameters.has_value();
    case Step::Test: return recipe->test.has_value();
    case Step::Number: return recipe->number.has_value();
    default: return true;
    }
}

struct Found {
    const StepEntry *begun = nullptr;
    const StepEntry *ended = nullptr;
};

/// The last time that it was done.
Found lastOf(const std::vector<StepEntry> &steps, Step step)
{
    Found found;
    for (const StepEntry &entry : steps) {
        if (entry.step != step)
            continue;
        if (entry.ended)
            found.ended = &entry;
        else
            found = {&entry, nullptr};
    }
    return found;
}

} // namespace

UnitSteps::UnitSteps(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Steps of this unit"));
    auto *column = layoutIn<QVBoxLayout>(this, theme.theme().u(4), {0, theme.theme().u(4), 0, theme.theme().u(4)});
    m_title = new ElidedLabel({}, this);
    setTextRole(*m_title, TextRole::Title);
    m_serial = textLabel({}, TextRole::Raw, Tone::Dim, this);
    column->addWidget(m_title);
    column->addWidget(m_serial);
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(theme.theme().u(8));
    grid->setVerticalSpacing(theme.theme().u(1));
    grid->setColumnStretch(1, 1);
    for (int i = 0; i < static_cast<int>(m_lines.size()); ++i)
        buildLine(*grid, static_cast<Step>(i));
    column->addLayout(grid);
    auto *orders = new QWidget(this);
    auto *row = new WrapLayout(orders);
    row->setContentsMargins(0, 0, 0, 0);
    m_skip = new CommandButton(m_theme, tr("Skip this unit"), this);
    m_again = new CommandButton(m_theme, Symbol::Refresh, tr("Do it again"), this);
    row->addWidget(m_skip);
    row->addWidget(m_again);
    column->addWidget(orders);
    connect(m_skip, &QPushButton::clicked, this, [this] { Q_EMIT skipWanted(m_row); });
    connect(m_again, &QPushButton::clicked, this, [this] { Q_EMIT againWanted(m_row); });
    show(nullptr, {}, nullptr);
}

void UnitSteps::buildLine(QGridLayout &grid, Step step)
{
    Line &line = m_lines.at(static_cast<std::size_t>(step));
    const int row = 2 * static_cast<int>(step);
    line.glyph = new StateGlyph(m_theme, GlyphState::Waiting, this);
    line.name = textLabel(stepText(step), TextRole::Body, Tone::Dim, this);
    line.time = textLabel({}, TextRole::Caption, Tone::Dim, this);
    line.detail = textLabel({}, TextRole::Caption, Tone::Dim, this);
    line.detail->setWordWrap(true);
    grid.addWidget(line.glyph, row, 0);
    grid.addWidget(line.name, row, 1);
    grid.addWidget(line.time, row, 2);
    grid.addWidget(line.detail, row + 1, 1, 1, 2);
}

void UnitSteps::show(const service::QueueRow *row, const QString &title, const service::Recipe *recipe)
{
    m_row = row ? row->id : 0;
    m_title->setText(title.isEmpty() ? tr("No unit selected") : title);
    m_serial->setText(row ? qt(row->visit.serial.empty() ? row->link : row->visit.serial) : QString());
    m_serial->setVisible(!m_serial->text().isEmpty());
    const service::QueueRow none;
    for (std::size_t i = 0; i < m_lines.size(); ++i)
        showStep(static_cast<Step>(i), row ? *row : none, row && isPart(static_cast<Step>(i), recipe));
    m_skip->setEnabled(row && (row->state == RowState::Waiting || row->state == RowState::Running));
    const bool over
        = row && (row->state == RowState::Failed || row->state == RowState::Refused || row->state == RowState::Skipped);
    m_again->setEnabled(over);
    m_skip->setVisible(row);
    m_again->setVisible(row);
}

void UnitSteps::showStep(Step step, const service::QueueRow &row, bool wanted)
{
    const Line &line = m_lines.at(static_cast<std::size_t>(step));
    const Found found = lastOf(row.visit.steps, step);
    const bool ends = row.state == RowState::Failed || row.state == RowState::Refused;
    const bool broken = ends && row.visit.step == step;
    const bool active = row.state == RowState::Running && found.begun && !found.ended;
    line.glyph->setState(broken ? GlyphState::Fault
            : active            ? GlyphState::Busy
            : found.ended       ? GlyphState::Done
                                : GlyphState::Waiting);
    setTextRole(*line.name, active ? TextRole::Emphasis : TextRole::Body);
    setTone(*line.name, broken ? Tone::Danger : active ? Tone::Text : Tone::Dim);
    const bool timed = found.begun && found.ended && found.begun->time > 0.0;
    line.time->setText(timed ? formatValue(found.ended->time - found.begun->time, 1, QStringLiteral("s")) : QString());
    line.detail->setText(found.ended && wanted ? messageText(found.ended->detail) : QString());
    setTone(*line.detail, broken ? Tone::Danger : Tone::Dim);
    for (QWidget *part : std::initializer_list<QWidget *>{line.glyph, line.name, line.time})
        part->setVisible(wanted);
    line.detail->setVisible(!line.detail->text().isEmpty());
}

} // namespace mb
