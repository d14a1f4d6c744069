// SPDX-License-Identifier: GPL-3.0-or-later
// Boards with several axes: one of them, all, or what the board has once.
#include "widgets/common/axistext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/segmented.h"
#include "widgets/parameters/axisparameters.h"
#include "widgets/parameters/parameterspage.h"

#include <QMenu>

namespace mb {

void ParametersPage::buildAxes(QWidget &tools)
{
    m_axes = new Segmented(tr("Which axis"), {tr("All axes"), tr("Board")}, &tools);
    m_axes->hide();
    m_copy = new CommandButton(m_theme, tr("Copy from"), &tools);
    m_copy->setAccessibleName(tr("Copy gains and limits from another axis"));
    m_copy->setToolTip(tr("Stages the gains and limits of another axis for this one; Write sends them."));
    auto *menu = new QMenu(m_copy);
    m_copy->setMenu(menu);
    m_copy->hide();
    connect(menu, &QMenu::aboutToShow, this, &ParametersPage::fillCopyMenu);
    connect(m_axes, &Segmented::currentChanged, this, &ParametersPage::axisChosen);
}

/// All, 1 … n, board.
void ParametersPage::followAxes(const Family &family)
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
    for (int axis = 1; axis <= axes; ++axis)
        m_axes->setText(axis, QString::number(axis));
    m_axes->setText(axes + 1, tr("Board"));
    m_axes->setCurrent(m_boardOnly ? axes + 1 : m_selection.axis());
    if (m_comparedAxis > 0) {
        m_comparedAxis = 0;
        m_model->setReference(defaultsOf(family));
    }
}

std::optional<int> ParametersPage::filterAxis() const
{
    const DeviceView *shown = device();
    if (!shown || !hasAxes(*shown->family))
        return std::nullopt;
    if (m_selection.axis() > 0)
        return m_selection.axis();
    return m_boardOnly ? std::optional(0) : std::nullopt;
}

void ParametersPage::axisChosen(int place)
{
    const DeviceView *shown = device();
    if (!shown)
        return;
    m_boardOnly = place > shown->family->capabilities.axes;
    const DeviceId id = shown->id;
    m_selection.select(id, m_boardOnly ? 0 : place);
    follow();
}

void ParametersPage::fillCopyMenu()
{
    const DeviceView *shown = device();
    QMenu &menu = *m_copy->menu();
    menu.clear();
    for (int axis = 1; shown && axis <= shown->family->capabilities.axes; ++axis) {
        if (axis == m_selection.axis())
            continue;
        QAction *action = menu.addAction(axisTitle(axis), this, [this, axis] { copyFrom(axis); });
        action->setEnabled(!gainsOfAxis(*shown->family, editsOf(*shown), axis, m_selection.axis()).empty());
    }
}

void ParametersPage::copyFrom(int axis)
{
    const DeviceView *shown = device();
    if (!shown || m_selection.axis() == 0)
        return;
    StagedEdits &edits = editsOf(*shown);
    edits.stageAll(
        gainsOfAxis(*shown->family, edits, axis, m_selection.axis()), tr("Gains and limits of axis %1").arg(axis));
}

} // namespace mb
