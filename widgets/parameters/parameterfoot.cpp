// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterfoot.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/wraplayout.h"

namespace mb {

ParameterFoot::ParameterFoot(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const Theme &t = theme.theme();
    setAttribute(Qt::WA_StyledBackground);
    setProperty("surface", QStringLiteral("window"));
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    m_help = textLabel({}, TextRole::Caption, Tone::Dim, this);
    m_help->setIndent(0);
    auto *about = new QWidget(this); // a style sheet takes the margins of a label for its own
    auto *line = layoutIn<QHBoxLayout>(about, t.u(12), {t.u(12), t.u(6), t.u(12), t.u(6)});
    m_status = new ReadStatus(theme, about);
    m_status->hide();
    line->addWidget(m_status);
    line->addWidget(m_help, 1);
    m_help->setAccessibleName(tr("What the parameter does"));
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(about);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    buildLegend();
    column->addWidget(m_legend);
    showParameter(nullptr);
}

void ParameterFoot::setCompact(bool compact)
{
    m_legend->setVisible(!compact);
}

void ParameterFoot::buildLegend()
{
    const Theme &t = m_theme.theme();
    m_legend = new QWidget(this);
    auto *row = new WrapLayout(m_legend);
    row->setContentsMargins(t.u(12), t.u(7), t.u(12), t.u(7));
    row->setSpacing(t.u(18));
    for (const auto &[count, state] : {std::pair(&m_edited, GlyphState::Edited),
             std::pair(&m_illegal, GlyphState::OutOfRange), std::pair(&m_unread, GlyphState::Fault),
             std::pair(&m_inRam, GlyphState::InRam), std::pair(&m_stored, GlyphState::Stored),
             std::pair(&m_assumed, GlyphState::Assumed), std::pair(&m_notKept, GlyphState::Volatile)}) {
        *count = addCount(state);
        row->addWidget(count->box);
    }
    row->addSpring();
    auto *keys = new QLabel(m_legend);
    nameKeys(*keys, tr("↑↓ row · Enter edit · %1 write"), {QStringLiteral("Ctrl+Shift+W")});
    setTextRole(*keys, TextRole::Caption);
    setTone(*keys, Tone::Faint);
    row->addWidget(keys);
}

ParameterFoot::Count ParameterFoot::addCount(GlyphState state)
{
    Count count;
    count.box = new QWidget(this);
    auto *row = layoutIn<QHBoxLayout>(count.box, m_theme.theme().u(6));
    count.text = new QLabel(count.box);
    setTextRole(*count.text, TextRole::Caption);
    row->addWidget(new StateGlyph(m_theme, state, count.box));
    row->addWidget(count.text);
    return count;
}

void ParameterFoot::setCount(const Count &count, int number, const QString &text)
{
    count.text->setText(text);
    count.box->setVisible(number > 0);
}

void ParameterFoot::showCounts(const ParameterCounts &counts)
{
    setCount(m_edited, counts.edited, tr("%1 edited").arg(counts.edited));
    setCount(m_illegal, counts.illegal, tr("%1 out of range").arg(counts.illegal));
    setCount(m_unread, counts.unread, tr("%1 without answer").arg(counts.unread));
    setCount(m_inRam, counts.inRam, tr("%1 in RAM").arg(counts.inRam));
    setCount(m_stored, counts.stored, tr("%1 stored").arg(counts.stored));
    setCount(m_assumed, counts.assumed, tr("%1 assumed").arg(counts.assumed));
    setCount(m_notKept, counts.notKept, tr("%1 not persistent").arg(counts.notKept));
}

void ParameterFoot::showParameter(const Parameter *parameter)
{
    if (!parameter) {
        m_help->setText(tr("Choose a parameter to see what it does."));
        return;
    }
    QStringList parts{qt(parameter->key), tableText(parameter->help)};
    if (isEditable(*parameter) && parameter->type != WireType::Boolean)
        parts += tr("%1.").arg(rangeText(*parameter));
    parts.removeAll(QString());
    m_help->setText(parts.join(QStringLiteral("   ")));
}

} // namespace mb
