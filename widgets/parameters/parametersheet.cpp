// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametersheet.h"

#include "widgets/common/layoutin.h"

namespace mb {
namespace {

constexpr int changesWidth = 288;

} // namespace

ParameterSheet::ParameterSheet(
    const ThemeSource &theme, Workbench &workbench, ParameterModel &model, const RamLedger &ledger, QWidget *parent)
    : QSplitter(Qt::Horizontal, parent)
{
    setChildrenCollapsible(false);
    setHandleWidth(1);
    auto *left = new QWidget(this);
    auto *rows = layoutIn<QVBoxLayout>(left, 0);
    m_view = new ParameterView(theme, model, left);
    m_foot = new ParameterFoot(theme, left);
    rows->addWidget(m_view, 1);
    rows->addWidget(m_foot);
    m_changes = new ChangesPanel(theme, workbench, model, ledger, this);
    setStretchFactor(0, 1);
    setStretchFactor(1, 0);
    m_changes->setMinimumWidth(theme.theme().u(changesWidth));
}

void ParameterSheet::setCompact(bool compact)
{
    setOrientation(compact ? Qt::Vertical : Qt::Horizontal);
    setStretchFactor(0, compact ? 3 : 1);
    setStretchFactor(1, compact ? 1 : 0);
    m_changes->setCompact(compact);
    m_foot->setCompact(compact);
}

} // namespace mb
