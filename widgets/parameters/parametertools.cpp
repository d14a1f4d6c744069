// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametertools.h"

#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"

#include <QEvent>

namespace mb {
namespace {

constexpr int leastSearch = 90; ///< units
constexpr int mostSearch = 232;

} // namespace

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
    m_search->setKeyHint(QStringLiteral("Ctrl+F"));
    m_search->setMaximumWidth(t.u(mostSearch));
    m_row = new WrapLayout(this);
    m_row->setStretched(m_search);
    m_row->addWidget(m_search);
    m_row->addWidget(m_segments);
    m_axes->addTo(*m_row);
    m_row->addSpring();
    m_row->addWidget(m_comparison);
    setLead(nullptr);
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

void ParameterTools::setLead(QWidget *lead)
{
    const Theme &t = m_theme.theme();
    const int above = t.u(lead ? 2 : 4);
    m_row->setContentsMargins(t.u(12), above, t.u(12), lead ? above : t.u(8));
    if (lead && lead != m_lead)
        m_row->prepend(lead);
    m_lead = lead;
    fit();
}

bool ParameterTools::event(QEvent *event)
{
    if (event->type() == QEvent::LayoutRequest) // other words in it
        fit();
    return QWidget::event(event);
}

/// All in one line if it can be: first the choice of rows folds to a list, then that of axes; the comparison goes where it is in the menu too.
void ParameterTools::fit()
{
    m_search->setMinimumWidth(m_theme.theme().u(leastSearch));
    const QMargins margins = m_row->contentsMargins();
    const int gap = m_row->spacing();
    int needed = margins.left() + margins.right() + m_search->minimumWidth() + gap + m_segments->unfoldedWidth();
    needed += m_axes->neededWidth(gap);
    if (m_lead)
        needed += m_lead->sizeHint().width() + gap;
    const int compared = m_comparison->sizeHint().width() + gap;
    m_segments->setFolded(needed + compared > width());
    if (m_segments->isFolded())
        needed += m_segments->sizeHint().width() - m_segments->unfoldedWidth();
    m_axes->setFolded(needed > width());
    m_comparison->setVisible(!m_lead || needed + compared <= width());
}

} // namespace mb
