// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <thread>

namespace mb {

/// Writes an export plan to a file in a thread of its own, so that a day of samples never stops the window. GUI thread.
class ExportJob : public QObject {
    Q_OBJECT
public:
    using Work = std::function<Result<ExportReport>(const ExportProgress &progress)>;

    explicit ExportJob(QObject *parent)
        : QObject(parent)
    {
    }
    /// Ends a job that runs, and waits for it.
    ~ExportJob() override;

    /// csv or mcap by the suffix. Refused while another one runs.
    bool start(ExportPlan plan, const QString &path);
    bool start(Work work, const QString &path);
    void cancel() { m_cancelled = true; }
    [[nodiscard]] bool isRunning() const { return m_running; }
    [[nodiscard]] QString path() const { return m_path; }

Q_SIGNALS:
    /// 0 … 100
    void progressed(int percent);
    void finished(const QString &path, const mb::Result<mb::ExportReport> &report);

private:
    std::thread m_thread;
    std::atomic<bool> m_cancelled{false};
    bool m_running = false;
    QString m_path;
};

} // namespace mb
