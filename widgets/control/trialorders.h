// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

namespace mb {

class TrialList;
class TrialNotebook;

/// What somebody does to trials in the list: star, note, delete, export. Says what went wrong. Belongs to the list.
class TrialOrders : public QObject {
    Q_OBJECT
public:
    TrialOrders(Workbench &workbench, TrialList &list);

Q_SIGNALS:
    /// The notebook has other trials, or another order of them.
    void changed();

private:
    void exportAll();
    void failed(const Result<void> &result);

    Workbench &m_workbench;
    TrialNotebook &m_notebook;
    TrialList &m_list;
};

} // namespace mb
