// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/axischoice.h"

#include "widgets/common/axistext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/segmented.h"
#include "widgets/parameters/axisparameters.h"
#include "widgets/parameters/editdesk.h"

#include <QLayout>
#include <QMenu>

namespace mb {

AxisChoice::AxisChoice(const ThemeSource &theme, Workbench &workbench, Selection &selection, QWidget &row)
    : QObject(&row)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_axes(new Segmented(tr("Which axis"), {tr("All axes"), tr("Board")}, &row))
    , m_copy(new CommandButton(theme, tr("Copy from"), &row))
{
    m_axes->hide();
    m_copy->setAccessibleName(tr("Copy gains and limits from another axis"));
    m_copy->setToolTip(tr("Stages the gains and limits of another axis for this one; Write sends them."));
    m_copy->setMenu(new QMenu(m_copy));
    m_copy->hide();
    connect(m_copy->menu(), &QMenu::aboutToShow, this, &AxisChoice::fillMenu);
    connect(m_axes, &Segmented::currentChanged, this, &AxisChoice::choose);
    connect(&selection, &Selection::changed, this, [this] { m_boardOnly = m_boardOnly && m_selection.axis() == 0; });
}

void AxisChoice::addTo(QLayout &row)
{
    row.addWidget(m_axes);
    row.addWidget(m_copy);
}

int AxisChoice::neededWidth(int gap) const
{
    const int axes = m_axes->isHidden() ? 0 : m_axes->unfoldedWidth() + gap;
    return axes + (m_copy->isHidden() ? 0 : m_copy->sizeHint().width() + gap);
}

void AxisChoice::setFolded(bool folded)
{
    if (m_axes->isFolded() == folded)
        return;
    m_axes->setFolded(folded);
    nameAxes();
}

/// Between the others a number says enough, alone it does not.
void AxisChoice::nameAxes()
{
    for (int axis = 1; axis < m_axes->count() - 1; ++axis)
        m_axes->setText(axis, m_axes->isFolded() ? axisTitle(axis) : QString::number(axis));
}

/// All, 1 … n, board.
void AxisChoice::follow(const Family &family)
{
    const int axes = hasAxes(family) ? family.capabilities.axes : 0;
    const QSignalBlocker quiet(m_axes);
    m_axes->setVisible(axes > 0);
    m_copy->setVisible(axes > 0 && m_selection.axis() > 0);
    if (axes == 0)
        return;
    while (m_axes->count() > axes + 2)
        m_axes->removeLast();
    while (m_axes->count() < axes + 2)
        m_axes->addSegment({});
    nameAxes();
    m_axes->setText(axes + 1, tr("Board"));
    m_axes->setCurrent(m_boardOnly ? axes + 1 : m_selection.axis());
}

std::optional<int> AxisChoice::chosen() const
{
    const DeviceView *shown = device();
    if (!shown || !hasAxes(*shown->family))
        return std::nullopt;
    if (m_selection.axis() > 0)
        return m_selection.axis();
    return m_boardOnly ? std::optional(0) : std::nullopt;
}

void AxisChoice::choose(int place)
{
    const DeviceView *shown = device();
    if (!shown)
        return;
    m_boardOnly = place > shown->family->capabilities.axes;
    const DeviceId id = shown->id;
    m_selection.select(id, m_boardOnly ? 0 : place);
    Q_EMIT changed();
}

void AxisChoice::fillMenu()
{
    const DeviceView *shown = device();
    QMenu &menu = *m_copy->menu();
    menu.clear();
    for (int axis = 1; shown && axis <= shown->family->capabilities.axes; ++axis) {
        if (axis == m_selection.axis())
            continue;
        QAction *action = menu.addAction(axisTitle(axis), this, [this, axis] { copyFrom(axis); });
        const StagedEdits &edits = EditDesk::of(m_workbench).editsOf(*shown);
        action->setEnabled(!gainsOfAxis(*shown->family, edits, axis, m_selection.axis()).empty());
    }
}

void AxisChoice::copyFrom(int axis)
{
    const DeviceView *shown = device();
    if (!shown || m_selection.axis() == 0)
        return;
    StagedEdits &edits = EditDesk::of(m_workbench).editsOf(*shown);
    edits.stageAll(
        gainsOfAxis(*shown->family, edits, axis, m_selection.axis()), tr("Gains and limits of axis %1").arg(axis));
}

} // namespace mb
