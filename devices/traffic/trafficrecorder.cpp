// SPDX-License-Identifier: GPL-3.0-or-later
#include "traffic/trafficrecorder.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration tickTime = std::chrono::milliseconds(100);

} // namespace

Result<std::unique_ptr<TrafficRecorder>> TrafficRecorder::start(
    Link &link, Clock &clock, Duration unixOffset, const std::string &path)
{
    MB_TRY(auto file, BackgroundFile::create(path));
    return start(link, clock, unixOffset, std::move(file));
}

Result<std::unique_ptr<TrafficRecorder>> TrafficRecorder::start(
    Link &link, Clock &clock, Duration unixOffset, std::unique_ptr<BackgroundFile> file)
{
    if (link.kind() != LinkKind::Can)
        return fail(
            Fault::Unsupported, say("%1 is no CAN link", link.address().shortName()), say("only those are recorded"));
    return std::unique_ptr<TrafficRecorder>(new TrafficRecorder(link, clock, unixOffset, std::move(file)));
}

TrafficRecorder::TrafficRecorder(Link &link, Clock &clock, Duration unixOffset, std::unique_ptr<BackgroundFile> file)
    : m_clock(clock)
    , m_file(std::move(file))
    , m_writer(formatOfName(m_file->path()))
    , m_unixOffset(unixOffset - clock.slept())
    , m_linkLostBefore(link.counters().lost)
    , m_since(clock.now())
    , m_tick(clock)
    , m_traffic(link.traffic().add([this](const Traffic &traffic) { take(traffic); }))
    , m_opened(link.stateChanged().add([this, &link](LinkState) { // a link that was closed counts from 0 again
        m_linkLostBefore = std::min(m_linkLostBefore, link.counters().lost);
    }))
    , m_batch(link.batchEnded().add([this, &link] {
        m_linkLost += link.counters().lost - m_linkLostBefore;
        m_linkLostBefore = link.counters().lost;
    }))
{
    m_frame.link = link.address().shortName();
    std::replace_if(
        m_frame.link.begin(), m_frame.link.end(), [](char c) { return c <= ' ' && c >= 0; }, '_');
    tick();
}

TrafficRecorder::~TrafficRecorder()
{
    stop();
}

void TrafficRecorder::take(const Traffic &traffic)
{
    if (!traffic.can)
        return;
    ++m_frames;
    m_sleeps.look(m_clock.now(), m_clock.slept());
    const Duration offset = m_unixOffset + m_sleeps.sleptAt(traffic.time);
    m_frame.time = std::max(traffic.time.time_since_epoch() + offset, Duration::zero());
    m_frame.frame = *traffic.can;
    m_frame.direction = traffic.direction == Direction::Sent ? LogDirection::Sent : LogDirection::Received;
    m_text.clear();
    m_writer.write(m_frame, m_text);
    append();
}

void TrafficRecorder::append()
{
    if (m_file->append(m_text))
        m_bytes += m_text.size();
}

void TrafficRecorder::tick()
{
    m_tick.startIn(tickTime, [this] { tick(); });
    m_sleeps.look(m_clock.now(), m_clock.slept());
    m_file->flush();
    const BackgroundFile::Status status = m_file->status();
    const bool news = status.finished || (!m_told && !status.problem.empty());
    m_told = m_told || !status.problem.empty();
    if (status.finished)
        m_tick.stop();
    if (news)
        m_changed.notify(); // last: whoever hears it may destroy this
}

std::shared_ptr<BackgroundFile> TrafficRecorder::end()
{
    stop();
    m_tick.stop();
    return std::move(m_file);
}

void TrafficRecorder::stop()
{
    if (std::exchange(m_stopped, true))
        return;
    m_traffic.reset();
    m_opened.reset();
    m_batch.reset();
    m_text.clear();
    m_writer.finish(m_text);
    if (!m_text.empty())
        append();
    m_file->finish();
}

RecordingState TrafficRecorder::state() const
{
    const BackgroundFile::Status status = m_file->status();
    RecordingState state;
    state.path = m_file->path();
    state.since = m_since;
    state.frames = m_frames;
    state.bytes = m_bytes;
    state.lost = m_linkLost + std::min(status.refused, m_frames);
    if (!status.problem.empty())
        state.lost += status.taken - status.written;
    state.finished = status.finished;
    state.problem = status.problem;
    return state;
}

} // namespace mb
