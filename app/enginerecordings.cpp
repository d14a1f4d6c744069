// SPDX-License-Identifier: GPL-3.0-or-later
// What is recorded, and what is replayed.
#include "app/enginecore.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration diskLimit = std::chrono::seconds(10);

Task<void> answered(Task<void> work, EngineCore::Finished finished)
{
    const Result<void> result = co_await std::move(work).attempt();
    if (finished)
        finished(result);
    co_return {};
}

} // namespace

Link *EngineCore::linkUnder(const std::string &address) const
{
    const auto parsed = LinkAddress::parse(address);
    return parsed ? m_session.findLink(*parsed) : nullptr;
}

void EngineCore::startRecording(const std::string &link, const std::string &path, const Finished &finished)
{
    m_files.spawn<void>(answered(record(link, path), finished));
}

Task<void> EngineCore::record(std::string link, std::string path)
{
    if (auto may = mayRecord(link); !may)
        co_return may;
    auto making = makeFile(path);
    auto file = co_await std::move(making);
    if (auto may = mayRecord(link); !may) // while the file was being made
        co_return may;
    Link *const open = linkUnder(link);
    watch(*open);
    Watched &watched = m_watched[open];
    watched.recorderChanged.reset();
    auto recorder = TrafficRecorder::start(*open, m_clock, m_session.clockOf(*open).unixOffset(), std::move(file));
    if (!recorder)
        co_return fail(recorder.error());
    watched.recorder = std::move(*recorder);
    watched.toldOfRecording = false;
    watched.recorderChanged = watched.recorder->changed().add([this, open] { recorderChanged(*open); });
    touch();
    co_return {};
}

Result<void> EngineCore::mayRecord(const std::string &link) const
{
    const Link *const open = linkUnder(link);
    if (!open)
        return fail(Fault::LinkLost, say("the link is not open"));
    if (open->kind() != LinkKind::Can)
        return fail(
            Fault::Unsupported, say("%1 is no CAN link", open->address().shortName()), say("only those are recorded"));
    const auto watched = m_watched.find(open);
    if (watched != m_watched.end() && watched->second.recorder && !watched->second.recorder->state().finished)
        return fail(Fault::Unsafe, say("%1 is being recorded already", open->address().shortName()));
    return {};
}

Task<std::unique_ptr<BackgroundFile>> EngineCore::makeFile(std::string path)
{
    if (!m_background)
        co_return BackgroundFile::create(path);
    auto making = inBackground<std::unique_ptr<BackgroundFile>>(
        *m_background, m_clock, path, diskLimit, [path] { return BackgroundFile::create(path); }, WhenLate::Drop);
    auto made = co_await std::move(making).attempt();
    if (!made && made.error().fault == Fault::Timeout)
        co_return fail(Fault::LinkLost, say("the disk has not made %1 within 10 s", path), say("name another folder"));
    co_return std::move(made);
}

/// What is left to write is waited for elsewhere.
void EngineCore::endRecording(Watched &watched)
{
    if (!watched.recorder || !m_background)
        return;
    watched.recorderChanged.reset();
    const auto file = watched.recorder->end();
    watched.recorder.reset();
    m_background->run(
        file->path(), [file] {}, [] {});
}

void EngineCore::recorderChanged(Link &link)
{
    Watched &watched = m_watched[&link];
    const RecordingState state = watched.recorder->state();
    touch();
    if (std::exchange(watched.toldOfRecording, true))
        return;
    if (!state.problem.empty()) {
        watched.recorder->stop();
        notice(Severity::Danger, link.address().shortName(), say("the recording has ended: %1", state.problem));
    } else if (state.lost > 0)
        notice(Severity::Caution, link.address().shortName(),
            say("%1 frames recorded, %2 are missing", state.frames, state.lost));
    else
        notice(Severity::Good, link.address().shortName(), say("%1 frames recorded, none is missing", state.frames));
}

void EngineCore::stopRecording(const std::string &link)
{
    const auto watched = m_watched.find(linkUnder(link));
    if (watched != m_watched.end() && watched->second.recorder)
        watched->second.recorder->stop();
    touch();
}

void EngineCore::steerReplay(const std::string &link, const ReplayOrder &order)
{
    Link *const open = linkUnder(link);
    ReplayLink *const replay = open ? Session::replayOf(*open) : nullptr;
    if (!replay)
        return;
    Result<void> done;
    if (order.pace)
        done = replay->setPace(*order.pace);
    if (done && order.position) {
        forgetWork(*open);
        done = m_session.seek(*replay, *order.position);
        keepTraffic(*open);
    }
    if (done && order.run)
        *order.run ? replay->play() : replay->pause();
    if (!done)
        notice(Severity::Danger, open->address().shortName(), done.error().text());
    touch();
}

/// From now on: another log, so that whoever shows the old one sees that time has jumped.
void EngineCore::keepTraffic(Link &link)
{
    Watched &watched = m_watched[&link];
    watched.tap.reset();
    watched.traffic = std::make_shared<TrafficLog>();
    watched.unknown = std::make_unique<UnknownFrames>(m_session.families());
    watched.tap = link.traffic().add([log = watched.traffic, &unknown = *watched.unknown](const Traffic &traffic) {
        if (!traffic.can) {
            log->append(traffic.direction, traffic.time, traffic.bytes);
            return;
        }
        log->append(traffic.direction, *traffic.can);
        if (traffic.direction == Direction::Received)
            unknown.take(*traffic.can);
    });
}

/// The devices are about to go, or to begin anew.
/// Whoever gave an order is answered, though it will not be carried out.
void EngineCore::dismissWork(DeviceId id, const Error &error)
{
    const auto runs = [id](const Running &running) { return running.device == id && running.operation->isRunning(); };
    for (auto found = std::find_if(m_operations.begin(), m_operations.end(), runs); found != m_operations.end();
         found = std::find_if(m_operations.begin(), m_operations.end(), runs))
        found->operation->dismiss(error);
}

void EngineCore::forgetWork(const Link &link)
{
    for (Device *device : m_session.devices()) {
        if (&device->link() != &link)
            continue;
        const DeviceId id = m_session.idOf(*device);
        m_streams.erase(id);
        dismissWork(id, {Fault::LinkLost, say("the device is gone")});
        std::erase_if(m_operations, [id](const Running &running) { return running.device == id; });
    }
}

/// A recording is let go once its devices are known: the first time that it has been looked through.
void EngineCore::playWhenKnown(Link &link)
{
    Watched &watched = m_watched[&link];
    ReplayLink *const replay = Session::replayOf(link);
    if (replay && !std::exchange(watched.played, true))
        replay->play();
}

} // namespace mb
