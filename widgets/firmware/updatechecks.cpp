// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/updatechecks.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/wraplayout.h"

#include <QLabel>

namespace mb {

UpdateChecks::UpdateChecks(const ThemeSource &theme, int count, QWidget *parent)
    : QWidget(parent)
    , m_checks(static_cast<std::size_t>(count))
{
    const Theme &now = theme.theme();
    auto *row = new WrapLayout(this);
    row->setContentsMargins(now.u(16), now.u(10), now.u(16), now.u(10));
    row->setSpacing(now.u(16));
    row->setLineSpacing(now.u(4));
    row->addWidget(new SectionLabel(tr("Before start"), this));
    for (Check &check : m_checks) {
        auto *const box = new QWidget(this);
        auto *const parts = layoutIn<QHBoxLayout>(box, now.u(8));
        check.glyph = new StateGlyph(theme, GlyphState::Waiting, box);
        check.text = textLabel({}, TextRole::Body, Tone::Text, box);
        parts->addWidget(check.glyph);
        parts->addWidget(check.text);
        row->addWidget(box);
    }
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
