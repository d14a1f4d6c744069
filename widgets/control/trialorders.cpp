// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/trialorders.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/guarded.h"
#include "widgets/common/trialnotebook.h"
#include "widgets/control/triallist.h"

#include <QStandardPaths>

namespace mb {

TrialOrders::TrialOrders(Workbench &workbench, TrialList &list)
    : QObject(&list)
    , m_workbench(workbench)
    , m_notebook(workbench.trials())
    , m_list(list)
{
    const auto finished = guarded(this, [this](const Result<void> &result) { failed(result); });
    connect(&list.model(), &TrialModel::starChosen, this, [this, finished](qint64 number, bool star) {
        m_notebook.setStar(number, star, finished);
        Q_EMIT changed();
    });
    connect(&list.model(), &TrialModel::noteWritten, this,
        [this, finished](qint64 number, const QString &note) { m_notebook.setNote(number, note, finished); });
    connect(&list, &TrialList::deleteRequested, this, [this, finished](qint64 number) {
        m_notebook.remove(number, finished);
        Q_EMIT changed();
    });
    connect(&list, &TrialList::exportRequested, this, &TrialOrders::exportAll);
}

void TrialOrders::failed(const Result<void> &result)
{
    if (!result)
        m_workbench.report(Severity::Danger, {}, tr("the notebook: %1").arg(errorText(result.error())));
}

/// Every trial of this loop; the rest of the notebook is the console's.
void TrialOrders::exportAll()
{
    const auto write = [this, trials = m_list.model().trials()](const QString &path) {
        m_notebook.exportTo(path, trials, guarded(this, [this, path](const Result<void> &result) {
            failed(result);
            if (result)
                m_workbench.report(Severity::Good, {}, tr("trials written to %1").arg(path));
        }));
    };
    askWhereToSave(m_list, tr("Export trials"), tr("Table (*.csv);;JSON (*.json)"),
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation), write);
}

} // namespace mb
