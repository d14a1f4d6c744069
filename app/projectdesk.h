// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/project.h"
#include "widgets/common/workbench.h"

#include <set>

namespace mb {

/// Writes the machine into a folder and puts such a folder into force: its links are opened; scales and limits are given to each unit
/// once it is there, and of a dialect that it was not found to speak it is said so. What a unit itself holds is not touched. GUI thread; the
/// book outlives it.
class ProjectDesk : public QObject {
    Q_OBJECT
public:
    /// `layouts`: where layouts of plots are kept; empty: nowhere.
    ProjectDesk(Workbench &workbench, EnvelopeBook &limits, const QString &layouts, QWidget &window);

    void askSave();
    void askOpen();
    void save(const QString &folder);
    void open(const QString &folder);

Q_SIGNALS:
    /// This is the folder of the machine from now on.
    void folderChosen(const QString &folder);

private:
    void follow();
    void apply(const DeviceView &device, const ProjectUnit &unit);

    Workbench &m_workbench;
    EnvelopeBook &m_limits;
    QString m_layouts;
    QWidget &m_window;
    Project m_project;
    std::set<DeviceId> m_applied;
};

} // namespace mb
