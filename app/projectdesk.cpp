// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/projectdesk.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/guarded.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/control/envelopebook.h"

#include <memory>

namespace mb {

ProjectDesk::ProjectDesk(Workbench &workbench, EnvelopeBook &limits, const QString &layouts, QWidget &window)
    : QObject(&window)
    , m_workbench(workbench)
    , m_limits(limits)
    , m_layouts(layouts)
    , m_window(window)
{
    connect(&workbench, &Workbench::changed, this, &ProjectDesk::follow);
}

void ProjectDesk::askSave()
{
    askForFolder(m_window, tr("Save the machine into a folder"), {}, [this](const QString &folder) { save(folder); });
}

void ProjectDesk::askOpen()
{
    askForFolder(m_window, tr("Open the folder of a machine"), {}, [this](const QString &folder) { open(folder); });
}

void ProjectDesk::save(const QString &folder)
{
    Project project = Project::of(m_workbench.snapshot(), m_limits);
    project.layouts = m_layouts;
    if (const auto saved = project.save(folder); !saved)
        return m_workbench.report(Severity::Danger, {}, errorText(saved.error()));
    m_workbench.report(Severity::Good, {},
        tr("%n unit(s) saved into %1", nullptr, static_cast<int>(project.units.size())).arg(folder));
    Q_EMIT folderChosen(folder);
}

void ProjectDesk::open(const QString &folder)
{
    auto project = Project::load(folder);
    if (!project) {
        m_workbench.report(Severity::Danger, {}, errorText(project.error()));
        return;
    }
    m_project = std::move(*project);
    m_applied.clear();
    Q_EMIT folderChosen(folder);
    if (!m_layouts.isEmpty() && !m_project.layouts.isEmpty()) {
        if (const auto kept = copyLayouts(m_project.layouts, m_layouts, false); !kept)
            m_workbench.report(Severity::Caution, {}, errorText(kept.error()));
    }
    for (const QString &link : m_project.links) {
        if (!m_workbench.snapshot().link(link.toStdString()))
            openAddress(m_workbench, link, {});
    }
    follow();
}

void ProjectDesk::follow()
{
    if (m_project.units.empty())
        return;
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        const ProjectUnit *unit = m_project.unitOf(device);
        if (unit && m_applied.insert(device.id).second)
            apply(device, *unit);
    }
}

/// A dialect that the scan did not find is its user's to confirm, in the inspector: the same code may mean another motion.
void ProjectDesk::apply(const DeviceView &device, const ProjectUnit &unit)
{
    const auto open = std::make_shared<int>(1); // answers, and this itself
    const auto told = guarded(this, [this, title = titleOf(device), open](const Result<void> &done) {
        if (!done)
            m_workbench.report(Severity::Caution, title, errorText(done.error()));
        else if (--*open == 0)
            m_workbench.report(Severity::Info, title, tr("scales and limits of the project are in force"));
    });
    for (const auto &[key, value] : unit.calibration) {
        const auto known = device.profile->calibration.find(key);
        if (known != device.profile->calibration.end() && known->second == value)
            continue;
        ++*open;
        m_workbench.send(orders::Calibrate{device.id, key, value}, told);
    }
    if (!unit.dialect.empty() && unit.dialect != device.identity->dialect)
        m_workbench.report(Severity::Caution, titleOf(device),
            tr("dialect %1 of the folder is not in force: choose it in the inspector if that is what it speaks")
                .arg(qt(unit.dialect)));
    if (unit.limits != Envelope())
        m_limits.enter(device.unit, unit.limits);
    told(Result<void>());
}

} // namespace mb
