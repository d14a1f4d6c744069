// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/statusline.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/theme.h"

namespace mb {

StatusLine::StatusLine(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
{
    auto *row = layoutIn<QHBoxLayout>(this, theme.theme().u(8));
    m_glyph = new StateGlyph(theme, GlyphState::Gone, this);
    m_cause = new ElidedLabel({}, this);
    setTextRole(*m_cause, TextRole::Emphasis);
    m_remedy = new ElidedLabel({}, this);
    setTone(*m_remedy, Tone::Dim);
    row->addWidget(m_glyph);
    row->addWidget(m_cause);
    row->addWidget(m_remedy, 1);
}

void StatusLine::say(const PageStatus &status, bool compact)
{
    m_glyph->setState(status.glyph);
    const bool folded = compact && !status.remedy.isEmpty();
    m_cause->setText(folded ? status.cause + QStringLiteral(" · ") + status.remedy : status.cause);
    m_remedy->setText(status.remedy);
    m_remedy->setVisible(!compact);
}

} // namespace mb
