// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametersheet.h"

#include "widgets/common/layoutin.h"

namespace mb {
namespace {

constexpr int changesWidth = 288;
constexpr int roomForBoth = 1150;       ///< for whole names beside a panel that is empty
constexpr int leastTable = 26 + 4 * 30; ///< units: its head and four rows

} // namespace

ParameterSheet::ParameterSheet(const ThemeSource &theme, Workbench &workbench, ParameterModel &model, QWidget *parent)
    : QSplitter(Qt::Horizontal, parent)
    , m_theme(theme)
{
    setChildrenCollapsible(false);
    setHandleWidth(1);
    auto *left = new QWidget(this);
    auto *rows = layoutIn<QVBoxLayout>(left, 0);
    m_view = new ParameterView(theme, model, left);
    m_view->setMinimumHeight(theme.theme().u(leastTable));
    m_foot = new ParameterFoot(theme, left);
    rows->addWidget(m_view, 1);
    rows->addWidget(m_foot);
    m_changes = new ChangesPanel(theme, workbench, model, this);
    setStretchFactor(0, 1);
    setStretchFactor(1, 0);
    m_changes->setMinimumWidth(theme.theme().u(changesWidth));
    connect(m_changes, &ChangesPanel::filled, this, &ParameterSheet::fit);
}

void ParameterSheet::setCompact(bool compact)
{
    setOrientation(compact ? Qt::Vertical : Qt::Horizontal);
    setStretchFactor(0, compact ? 3 : 1);
    setStretchFactor(1, compact ? 1 : 0);
    m_compact = compact;
    m_changes->setCompact(compact);
    m_foot->setCompact(compact);
    fit();
}

void ParameterSheet::setWritable(bool writable)
{
    m_writable = writable;
    fit();
}

void ParameterSheet::resizeEvent(QResizeEvent *event)
{
    QSplitter::resizeEvent(event);
    fit();
}

/// What is edited stays in sight when the changes come in below it.
void ParameterSheet::fit()
{
    const bool shown
        = m_writable && (m_changes->isFilled() || (!m_compact && width() >= m_theme.theme().u(roomForBoth)));
    if (shown != m_changes->isHidden())
        return;
    m_changes->setVisible(shown);
    if (m_compact)
        QMetaObject::invokeMethod(
            m_view, [view = m_view] { view->scrollTo(view->currentIndex()); }, Qt::QueuedConnection);
}

} // namespace mb
