// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/checkrow.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/wraplayout.h"

#include <QLabel>

namespace mb {

CheckRow::CheckRow(const ThemeSource &theme, const QString &heading, int count, QWidget *parent)
    : QWidget(parent)
    , m_checks(static_cast<std::size_t>(count))
{
    const Theme &now = theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    auto *line = new QWidget(this);
    auto *row = layoutIn<WrapLayout>(line, now.u(16), {now.u(16), now.u(8), now.u(16), now.u(8)});
    row->setLineSpacing(now.u(4));
    row->addWidget(new SectionLabel(heading, line));
    for (Check &check : m_checks) {
        auto *const box = new QWidget(line);
        auto *const parts = layoutIn<QHBoxLayout>(box, now.u(6));
        parts->addWidget(check.glyph = new StateGlyph(theme, GlyphState::Waiting, box));
        parts->addWidget(check.words = textLabel({}, TextRole::Body, Tone::Text, box));
        row->addWidget(box);
    }
    column->addWidget(line);
    column->addWidget(separatorLine(Qt::Horizontal, this));
}

void CheckRow::set(int place, GlyphState state, const QString &words)
{
    const Check &check = m_checks.at(static_cast<std::size_t>(place));
    check.glyph->setState(state);
    check.words->setText(words);
    check.words->parentWidget()->setVisible(!words.isEmpty());
}

QString CheckRow::text() const
{
    QStringList words;
    for (const Check &check : m_checks)
        words << check.words->text();
    return words.join(QStringLiteral(", "));
}

} // namespace mb
