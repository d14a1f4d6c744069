// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/updatechecks.h"

#include "widgets/common/labels.h"

#include <QHBoxLayout>

namespace mb {

UpdateChecks::UpdateChecks(const ThemeSource &theme, int count, QWidget *parent)
    : QWidget(parent)
    , m_checks(static_cast<std::size_t>(count))
    , m_row(new QHBoxLayout(this))
{
    const int edge = theme.theme().u(10);
    m_row->setContentsMargins(theme.theme().u(16), edge, theme.theme().u(16), edge);
    m_row->setSpacing(theme.theme().u(8));
    m_row->addWidget(new SectionLabel(tr("Before start"), this));
    for (Check &check : m_checks) {
        m_row->addSpacing(theme.theme().u(8));
        check.glyph = new StateGlyph(theme, GlyphState::Waiting, this);
        check.text = textLabel({}, TextRole::Body, Tone::Text, this);
        m_row->addWidget(check.glyph);
        m_row->addWidget(check.text);
    }
    m_row->addStretch();
}

void UpdateChecks::set(int place, GlyphState state, const QString &text)
{
    const Check &check = m_checks.at(static_cast<std::size_t>(place));
    check.glyph->setState(state);
    check.text->setText(text);
}

QString UpdateChecks::text(int place) const
{
    return m_checks.at(static_cast<std::size_t>(place)).text->text();
}

GlyphState UpdateChecks::state(int place) const
{
    return m_checks.at(static_cast<std::size_t>(place)).glyph->state();
}

} // namespace mb
