// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/projectdesk.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/control/envelopebook.h"

#include <QDir>

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
        QDir().mkpath(m_layouts);
        for (const QString &name : QDir(m_project.layouts).entryList({QStringLiteral("*.json")}, QDir::Files)) {
            const QString own = m_layouts + QLatin1Char('/') + name;
            if (!QFile::exists(own)) // a layout of one's own is not written over
                QFile::copy(m_project.layouts + QLatin1Char('/') + name, own);
        }
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

void ProjectDesk::apply(const DeviceView &device, const ProjectUnit &unit)
{
    for (const auto &[key, value] : unit.calibration) {
        const auto known = device.profile->calibration.find(key);
        if (known == device.profile->calibration.end() || known->second != value)
            m_workbench.send(orders::Calibrate{device.id, key, value});
    }
    if (!unit.dialect.empty() && unit.dialect != device.profile->dialect)
        m_workbench.send(orders::SetDialect{device.id, unit.dialect});
    if (unit.limits != Envelope())
        m_limits.enter(device.unit, unit.limits);
    m_workbench.report(Severity::Info, titleOf(device), tr("scales and limits of the project are in force"));
}

} // namespace mb
