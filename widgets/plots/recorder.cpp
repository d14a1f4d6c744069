// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/recorder.h"

#include "recording/joinrecordings.h"
#include "widgets/common/devicetext.h"
#include "widgets/plots/telemetrysource.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>

namespace mb {
namespace {

constexpr std::chrono::milliseconds period{500};

/// Nothing is left under the name where it fails.
Result<ExportReport> saveTo(RollingRecorder &recorder, const QString &path)
{
    auto report = recorder.save(path.toStdString(), {});
    if (!report && QFileInfo(path).size() == 0)
        QFile::remove(path);
    return report;
}

} // namespace

QString recordingIn(const QString &folder)
{
    QDir().mkpath(folder);
    const QString name
        = QDir(folder).filePath(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")));
    QString path = name + QStringLiteral(".mcap");
    for (int i = 2; !QFile(path).open(QIODevice::NewOnly) && QFile::exists(path); ++i)
        path = name + QStringLiteral("-%1.mcap").arg(i);
    return path;
}

Recorder::Recorder(Workbench &workbench, const QString &folder, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
{
    m_options.folder = folder.toStdString();
    m_options.name = QStringLiteral("%1-%2")
                         .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")))
                         .arg(QCoreApplication::applicationPid())
                         .toStdString();
    m_follow.setInterval(period);
    connect(&m_follow, &QTimer::timeout, this, &Recorder::follow);
    m_follow.start();
    m_thread = std::thread([this] { work(); });
}

Recorder::~Recorder()
{
    {
        const std::lock_guard lock(m_mutex);
        m_now = m_workbench.now();
        m_unixOffset = m_workbench.unixOffset();
        m_sleeps = m_workbench.sleeps();
        m_end = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

void Recorder::follow()
{
    const Snapshot &shot = m_workbench.snapshot();
    std::vector<ExportChannel> channels;
    std::vector<std::pair<std::string, mcap::Map>> about;
    for (const DeviceView &device : shot.devices) {
        const LinkView *link = shot.link(device.link);
        if (link && link->replay) // it is a recording already
            continue;
        const auto all = channelsOf(device, link && link->simulated);
        channels.insert(channels.end(), all.begin(), all.end());
        auto described = describe(device);
        std::move(described.begin(), described.end(), std::back_inserter(about));
    }
    {
        const std::lock_guard lock(m_mutex);
        m_now = m_workbench.now();
        m_unixOffset = m_workbench.unixOffset();
        m_sleeps = m_workbench.sleeps();
        if (m_following.empty() || m_following.back().channels != channels)
            m_following.push_back({std::move(channels), {}});
        m_following.back().about = std::move(about);
    }
    m_wake.notify_one();
    Q_EMIT changed();
}

void Recorder::post(std::function<void(RollingRecorder &)> order)
{
    {
        const std::lock_guard lock(m_mutex);
        m_orders.push_back(std::move(order));
    }
    m_wake.notify_one();
}

void Recorder::work()
{
    recover();
    RollingRecorder recorder(m_options);
    std::unique_lock lock(m_mutex);
    for (bool end = false; !end;) {
        m_wake.wait(lock, [this] { return m_end || !m_following.empty() || !m_orders.empty(); });
        auto following = std::exchange(m_following, {});
        auto orders = std::exchange(m_orders, {});
        end = m_end;
        const bool due = !following.empty() || end;
        const Instant now = m_now;
        const Duration offset = m_unixOffset;
        const SleepLog sleeps = m_sleeps;
        lock.unlock();
        for (Following &each : following)
            recorder.follow(each.channels, std::move(each.about));
        for (const auto &order : orders)
            order(recorder);
        const Result<void> written = !due ? Result<void>()
            : end                         ? recorder.writeAll(now, offset, sleeps)
                                          : recorder.write(now, offset, sleeps);
        lock.lock();
        m_state.keeping = recorder.isKeeping();
        m_state.bytes = recorder.bytes();
        m_state.samples = recorder.samples();
        m_state.since = recorder.since() ? plotKey(*recorder.since()) : 0.0;
        if (due)
            tell(written ? QString() : errorText(written.error()));
    }
    if (recorder.isKeeping())
        saveKept(recorder);
}

void Recorder::recover()
{
    const Recovered recovered = recoverRecordings(m_options.folder);
    for (const std::string &path : recovered.paths)
        QMetaObject::invokeMethod(this, [this, path] {
            m_workbench.report(Severity::Caution, {},
                tr("The last session did not end by itself. What it recorded is in %1.").arg(qt(path)));
        });
    for (const Error &failure : recovered.failures)
        QMetaObject::invokeMethod(this, [this, failure] {
            m_workbench.report(Severity::Danger, {},
                tr("What the last session recorded waits for the next start: %1").arg(errorText(failure)));
        });
}

void Recorder::saveKept(RollingRecorder &recorder) const
{
    if (!saveTo(recorder, recordingIn(m_keepFolder)))
        recorder.leave();
}

/// Once when it begins, once when it is over.
void Recorder::tell(const QString &failure)
{
    const bool was = !m_state.failure.isEmpty();
    m_state.failure = failure;
    if (was == !failure.isEmpty())
        return;
    QMetaObject::invokeMethod(this, [this, failure] {
        if (failure.isEmpty())
            m_workbench.report(
                Severity::Good, {}, tr("Samples are recorded on disk again, those of the meantime too."));
        else
            m_workbench.report(Severity::Danger, {}, tr("Samples are not recorded on disk: %1").arg(failure));
    });
}

Recorder::State Recorder::state() const
{
    const std::lock_guard lock(m_mutex);
    return m_state;
}

void Recorder::startKeeping(const QString &folder)
{
    {
        const std::lock_guard lock(m_mutex);
        m_keepFolder = folder;
    }
    post([](RollingRecorder &recorder) { recorder.startKeeping(); });
}

void Recorder::note(Instant time, const QString &text)
{
    post([time, note = text.toStdString()](RollingRecorder &recorder) { recorder.note(time, note); });
}

void Recorder::save(const QString &path)
{
    {
        const std::lock_guard lock(m_mutex);
        m_state.saving = true;
    }
    post([this, path, now = m_workbench.now(), offset = m_workbench.unixOffset(), sleeps = m_workbench.sleeps()](
             RollingRecorder &recorder) {
        (void)recorder.writeAll(now, offset, sleeps); // why it fails save() tells
        const auto report = saveTo(recorder, path);
        const QString error = report ? QString() : errorText(report.error());
        {
            const std::lock_guard lock(m_mutex);
            m_state.saving = false;
        }
        QMetaObject::invokeMethod(this, [this, path, error] { Q_EMIT saved(path, error); });
    });
}

} // namespace mb
