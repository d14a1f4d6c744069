// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/stepspanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/stateglyph.h"
#include "widgets/firmware/drawingview.h"

namespace mb {

StepsPanel::StepsPanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("updateSteps"));
    setAccessibleName(tr("Steps of the update"));
    m_column = layoutIn<QVBoxLayout>(this, theme.theme().u(10));
    m_column->addWidget(new SectionLabel(tr("Steps"), this));
    m_drawing = new DrawingView(theme, this);
    setVisible(false);
}

void StepsPanel::setSteps(std::span<const GuidedStep> steps)
{
    setVisible(!steps.empty());
    if (steps.data() == m_steps.data())
        return;
    m_steps = steps;
    rebuild();
}

void StepsPanel::rebuild()
{
    delete m_list;
    m_rows.clear();
    m_list = new QWidget(this);
    auto *grid = layoutIn<QGridLayout>(m_list);
    grid->setHorizontalSpacing(m_theme.theme().u(8));
    grid->setVerticalSpacing(m_theme.theme().u(1));
    grid->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        Row row;
        const int line = static_cast<int>(2 * i);
        row.glyph = new StateGlyph(m_theme, GlyphState::Waiting, m_list);
        row.title
            = textLabel(tr("%1. %2").arg(i + 1).arg(tableText(m_steps[i].title)), TextRole::Body, Tone::Dim, m_list);
        row.text = textLabel(tableText(m_steps[i].text), TextRole::Caption, Tone::Dim, m_list);
        row.text->setWordWrap(true);
        grid->addWidget(row.glyph, line, 0);
        grid->addWidget(row.title, line, 1);
        grid->addWidget(row.text, line + 1, 1);
        grid->setRowMinimumHeight(line, m_theme.theme().u(20));
        m_rows.push_back(row);
    }
    m_column->addWidget(m_drawing);
    m_column->addWidget(m_list);
    follow(nullptr);
}

void StepsPanel::showStep(std::size_t step, PartState state, bool broken)
{
    const Row &row = m_rows[step];
    const bool active = state == PartState::Active;
    row.glyph->setState(state == PartState::Done ? GlyphState::Done
            : active && broken                   ? GlyphState::Fault
            : active                             ? GlyphState::Busy
                                                 : GlyphState::Waiting);
    setTextRole(*row.title, active ? TextRole::Emphasis : TextRole::Body);
    setTone(*row.title, active ? broken ? Tone::Danger : Tone::Text : Tone::Dim);
}

/// The drawing is of the first step under way, and of the first at all before it has begun.
void StepsPanel::follow(const OperationStatus *status)
{
    const Drawing *drawing = m_steps.empty() ? nullptr : m_steps.front().drawing;
    bool any = false;
    const bool broken = status && status->state != OperationStatus::State::Running;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        PartState state = PartState::Waiting;
        if (status) {
            const auto part = status->parts.find(static_cast<int>(i));
            state = part == status->parts.end() ? PartState::Waiting : part->second;
        }
        showStep(i, state, broken);
        if (!any && (state == PartState::Active || (state == PartState::Done && i + 1 == m_rows.size()))) {
            drawing = m_steps[i].drawing;
            any = true;
        }
    }
    m_drawing->setDrawing(drawing);
}

} // namespace mb
