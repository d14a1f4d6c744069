// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/exportjob.h"

#include "recording/exportcsv.h"
#include "recording/exportmcap.h"

#include <QFileInfo>

namespace mb {

ExportJob::~ExportJob()
{
    m_cancelled = true;
    if (m_thread.joinable())
        m_thread.join();
}

bool ExportJob::start(ExportPlan plan, const QString &path)
{
    const bool table = QFileInfo(path).suffix().toLower() == QLatin1String("csv");
    return start(
        [plan = std::move(plan), table, file = path.toStdString()](const ExportProgress &progress) {
            return table ? exportCsv(plan, file, progress) : exportMcap(plan, file, progress);
        },
        path);
}

bool ExportJob::start(Work work, const QString &path)
{
    if (m_running)
        return false;
    if (m_thread.joinable())
        m_thread.join();
    m_running = true;
    m_cancelled = false;
    m_path = path;
    m_thread = std::thread([this, work = std::move(work), path] {
        int shown = -1;
        const auto progress = [this, &shown](double part) {
            const int percent = static_cast<int>(part * 100.0);
            if (percent != shown) {
                shown = percent;
                QMetaObject::invokeMethod(
                    this, [this, percent] { Q_EMIT progressed(percent); }, Qt::QueuedConnection);
            }
            return !m_cancelled.load();
        };
        const auto report = work(progress);
        QMetaObject::invokeMethod(
            this,
            [this, path, report] {
                m_running = false;
                Q_EMIT finished(path, report);
            },
            Qt::QueuedConnection);
    });
    return true;
}

} // namespace mb
