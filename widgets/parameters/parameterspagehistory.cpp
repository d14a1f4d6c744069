// SPDX-License-Identifier: GPL-3.0-or-later
// The history of the unit on this page: its states, undo of what was written, snapshots.
#include "widgets/common/banner.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/parameters/historypanel.h"
#include "widgets/parameters/parameterspage.h"

#include <QBoxLayout>
#include <QPointer>
#include <QSplitter>

namespace mb {
namespace {

constexpr auto historyKey = "parameters history";

} // namespace

void ParametersPage::buildHistory(QWidget &content, QBoxLayout &column)
{
    m_history = new HistoryPanel(m_workbench, m_theme, &content);
    m_history->hide();
    column.addWidget(m_history, 1);
    connect(m_history, &HistoryPanel::restoreRequested, this, &ParametersPage::restore);
    connect(m_showHistory, &QPushButton::toggled, this, &ParametersPage::showHistory);
    connect(m_snapshot, &QPushButton::clicked, this, &ParametersPage::takeSnapshot);
}

void ParametersPage::showHistory(bool on)
{
    m_view->commitField();
    const DeviceView *shown = device();
    const bool may = on && shown && !m_fileEdits;
    if (may)
        m_history->showDevice(*shown);
    m_showHistory->setChecked(may);
    m_history->setVisible(may);
    m_tools->setVisible(!may);
    m_splitter->setVisible(!may);
}

void ParametersPage::takeSnapshot()
{
    const DeviceView *shown = device();
    if (!shown || !m_snapshot->isEnabled())
        return;
    m_workbench.send(
        orders::TakeSnapshot{shown->id, {}}, [page = QPointer(this), id = shown->id](const Result<void> &result) {
            if (page && !result)
                page->refuse(historyKey, id, errorText(result.error()), tr("Nothing is kept."));
            else if (page)
                page->m_history->reload();
        });
}

/// A write of its own, of values that were there before; also of another day.
void ParametersPage::undoWrite(bool again)
{
    const DeviceView *shown = device();
    if (!shown || m_fileEdits || !shown->liveness.heard)
        return;
    m_banners.clear(QLatin1String(historyKey));
    m_workbench.send(
        orders::UndoWrite{shown->id, again}, [page = QPointer(this), id = shown->id](const Result<void> &result) {
            if (page && !result)
                page->refuse(historyKey, id, errorText(result.error()), {});
            else if (page)
                page->m_history->reload();
        });
}

void ParametersPage::restore(const QString &from)
{
    const DeviceView *shown = device();
    if (!shown)
        return;
    m_banners.clear(QLatin1String(historyKey));
    const std::vector<ParameterChange> changes = m_history->ticked();
    m_workbench.send(orders::RestoreParameters{shown->id, changes},
        [page = QPointer(this), id = shown->id, from](const Result<void> &result) {
            if (page && !result)
                page->refuse(historyKey, id, errorText(result.error()),
                    tr("What was written before it is in force. Ctrl+Z takes it back."));
            else if (page)
                page->m_history->reload();
        });
}

} // namespace mb
