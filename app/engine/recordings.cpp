// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/recordings.h"

#include "async/background.h"

namespace mb {
namespace {

constexpr Duration diskLimit = std::chrono::seconds(10);

Task<void> answered(Task<void> work, Finished finished)
{
    const Result<void> result = co_await std::move(work).attempt();
    finished(result);
    co_return {};
}

} // namespace

Recordings::Recordings(const EngineContext &context, Motion &motion)
    : m_context(context)
    , m_motion(motion)
    , m_files(context.clock)
{
}

Recordings::~Recordings()
{
    m_files.clear();
}

Link *Recordings::linkUnder(const std::string &address) const
{
    const auto parsed = LinkAddress::parse(address);
    return parsed ? m_context.session.linkBook().find(*parsed) : nullptr;
}

void Recordings::follow(Link &link)
{
    if (m_kept.try_emplace(&link).second)
        keepTraffic(link);
}

/// From now on: another log, so that whoever shows the old one sees that time has jumped.
void Recordings::keepTraffic(Link &link)
{
    Kept &kept = m_kept[&link];
    kept.tap.reset();
    kept.traffic = std::make_shared<TrafficLog>();
    kept.unknown = std::make_unique<UnknownFrames>(m_context.session.families());
    kept.tap = link.traffic().add([log = kept.traffic, &unknown = *kept.unknown](const Traffic &traffic) {
        if (!traffic.can) {
            log->append(traffic.direction, traffic.time, traffic.bytes);
            return;
        }
        log->append(traffic.direction, *traffic.can);
        if (traffic.direction == Direction::Received)
            unknown.take(*traffic.can);
    });
}

/// What is left to write is waited for elsewhere.
void Recordings::forget(Link &link)
{
    Kept kept = std::move(m_kept[&link]);
    m_kept.erase(&link);
    if (!kept.recorder || !m_background)
        return;
    kept.recorderChanged.reset();
    const auto file = kept.recorder->end();
    kept.recorder.reset();
    m_background->run(
        file->path(), [file] {}, [] {});
}

void Recordings::playWhenKnown(Link &link)
{
    ReplayLink *const replay = replayOf(link);
    if (!replay || std::exchange(m_kept[&link].played, true))
        return;
    if (const Message remark = replay->remark(); !remark.empty())
        m_context.log.tell(Severity::Caution, link.address().shortName(), remark);
    replay->play();
}

void Recordings::describe(const Link &link, LinkView &view) const
{
    const auto kept = m_kept.find(&link);
    if (kept == m_kept.end())
        return;
    view.traffic = kept->second.traffic;
    view.unknown = kept->second.unknown->count();
    if (kept->second.recorder)
        view.recording = kept->second.recorder->state();
}

void Recordings::carryOut(const orders::StartRecording &order, const Finished &finished)
{
    m_files.spawn<void>(answered(record(order.link, order.path), finished));
}

Task<void> Recordings::record(std::string link, std::string path)
{
    if (auto may = mayRecord(link); !may)
        co_return may;
    auto file = co_await makeFile(path);
    if (auto may = mayRecord(link); !may) // while the file was being made
        co_return may;
    Link *const open = linkUnder(link);
    follow(*open);
    Kept &kept = m_kept[open];
    kept.recorderChanged.reset();
    auto recorder = TrafficRecorder::start(
        *open, m_context.clock, m_context.session.clockOf(*open).unixOffset(), std::move(file));
    if (!recorder)
        co_return fail(recorder.error());
    kept.recorder = std::move(*recorder);
    kept.toldOfEnd = false;
    kept.recorderChanged = kept.recorder->changed().add([this, open] { recorderChanged(*open); });
    co_return {};
}

Result<void> Recordings::mayRecord(const std::string &link) const
{
    const Link *const open = linkUnder(link);
    if (!open)
        return fail(Fault::LinkLost, say("the link is not open"));
    if (open->kind() != LinkKind::Can)
        return fail(
            Fault::Unsupported, say("%1 is no CAN link", open->address().shortName()), say("only those are recorded"));
    const auto kept = m_kept.find(open);
    if (kept != m_kept.end() && kept->second.recorder && !kept->second.recorder->state().finished)
        return fail(Fault::Unsafe, say("%1 is being recorded already", open->address().shortName()));
    return {};
}

Task<std::unique_ptr<BackgroundFile>> Recordings::makeFile(std::string path)
{
    if (!m_background)
        co_return BackgroundFile::create(path);
    auto making = inBackground<std::unique_ptr<BackgroundFile>>(
        *m_background, m_context.clock, path, diskLimit, [path] { return BackgroundFile::create(path); },
        WhenLate::Drop);
    auto made = co_await std::move(making).attempt();
    if (!made && made.error().fault == Fault::Timeout)
        co_return fail(Fault::LinkLost, say("the disk has not made %1 within 10 s", path), say("name another folder"));
    co_return std::move(made);
}

void Recordings::recorderChanged(Link &link)
{
    Kept &kept = m_kept[&link];
    const RecordingState state = kept.recorder->state();
    if (std::exchange(kept.toldOfEnd, true))
        return;
    const std::string name = link.address().shortName();
    if (!state.problem.empty()) {
        kept.recorder->stop();
        m_context.log.tell(Severity::Danger, name, say("the recording has ended: %1", state.problem));
    } else if (state.lost > 0)
        m_context.log.tell(
            Severity::Caution, name, say("%1 frames recorded, %2 are missing", state.frames, state.lost));
    else
        m_context.log.tell(Severity::Good, name, say("%1 frames recorded, none is missing", state.frames));
}

void Recordings::carryOut(const orders::StopRecording &order, const Finished &finished)
{
    const auto kept = m_kept.find(linkUnder(order.link));
    if (kept != m_kept.end() && kept->second.recorder)
        kept->second.recorder->stop();
    finished({});
}

void Recordings::carryOut(const orders::SteerReplay &order, const Finished &finished)
{
    Link *const open = linkUnder(order.link);
    ReplayLink *const replay = open ? replayOf(*open) : nullptr;
    if (!open)
        return finished(fail(Fault::LinkLost, say("the link is not open")));
    if (!replay)
        return finished(fail(Fault::Unsupported, say("%1 is no recording", open->address().shortName())));
    const Result<void> done = steer(*open, *replay, order.order);
    if (!done)
        m_context.log.tell(Severity::Danger, open->address().shortName(), done.error().message());
    finished(done);
}

/// A new position ends what its devices were doing.
Result<void> Recordings::steer(Link &link, ReplayLink &replay, const ReplayOrder &order)
{
    if (order.pace) {
        MB_TRY_VOID(replay.setPace(*order.pace));
    }
    if (order.position) {
        m_motion.forget(link);
        m_context.operations.forget(link);
        const Result<void> sought = m_context.session.seek(replay, *order.position);
        keepTraffic(link);
        if (!sought)
            return sought;
    }
    if (order.run)
        *order.run ? replay.play() : replay.pause();
    return {};
}

} // namespace mb
