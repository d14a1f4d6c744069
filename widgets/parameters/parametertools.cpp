// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametertools.h"

#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"

namespace mb {

ParameterTools::ParameterTools(
    const ThemeSource &theme, Workbench &workbench, Selection &selection, ParameterModel &model, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_search(new SearchField(theme, tr("Search parameters"), this))
    , m_segments(new Segmented(tr("Which parameters"), {tr("All"), tr("Changed"), tr("Edited"), tr("Errors")}, this))
    , m_comparison(new ComparisonBox(workbench, selection, model, this))
    , m_axes(new AxisChoice(theme, workbench, selection, *this))
{
    const Theme &t = theme.theme();
    m_search->setKeyHint(tr("Ctrl+F"));
    m_search->setFixedWidth(t.u(232));
    auto *row = new WrapLayout(this);
    row->setContentsMargins(t.u(12), t.u(4), t.u(12), t.u(8));
    row->addWidget(m_search);
    row->addWidget(m_segments);
    m_axes->addTo(*row);
    row->addSpring();
    row->addWidget(m_comparison);
    connect(m_search, &QLineEdit::textChanged, this, &ParameterTools::filterChanged);
    connect(m_search, &QLineEdit::returnPressed, this, &ParameterTools::searchEnded);
    connect(m_segments, &Segmented::currentChanged, this, &ParameterTools::filterChanged);
}

ParameterFilter ParameterTools::filter() const
{
    return {static_cast<ParameterFilter::Segment>(m_segments->current()), m_search->text(), m_axes->chosen()};
}

void ParameterTools::showCounts(const ParameterCounts &counts, int shownRows)
{
    m_segments->setText(ParameterFilter::All, tr("All %1").arg(counts.all));
    m_segments->setText(ParameterFilter::Changed, tr("Changed %1").arg(counts.changed));
    m_segments->setText(ParameterFilter::Edited, tr("Edited %1").arg(counts.edited + counts.illegal));
    m_segments->setText(ParameterFilter::Errors, tr("Errors %1").arg(counts.illegal + counts.unread));
    m_search->setResult(m_search->text().isEmpty() ? QString() : tr("%1 of %2").arg(shownRows).arg(counts.all));
}

void ParameterTools::chooseEdited()
{
    m_segments->setCurrent(ParameterFilter::Edited);
}

void ParameterTools::search()
{
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

void ParameterTools::setCompact(bool compact)
{
    m_search->setFixedWidth(m_theme.theme().u(compact ? 170 : 232));
}

} // namespace mb
