// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/replay.h"

#include "wire/number.h"

#include <algorithm>
#include <utility>

namespace mb {
namespace {

bool isPace(double pace)
{
    return pace == 0.0 || (pace >= ReplayLink::slowest && pace <= ReplayLink::fastest);
}

tl::unexpected<Error> wrongPace(const std::string &text)
{
    return fail(Fault::OutOfRange, say("speed=%1 is no speed", text), say("legal is 0.01 … 1000, or max"));
}

Result<double> parsePace(std::string_view text)
{
    if (text == "max")
        return 0.0;
    const auto pace = numberFrom(text);
    if (!pace || *pace == 0.0 || !isPace(*pace))
        return wrongPace(std::string(text));
    return *pace;
}

} // namespace

ReplayLink::ReplayLink(const LinkAddress &address, Clock &clock, double pace, std::string interface)
    : ReplayTime(clock)
    , CanLink(address, time)
    , m_pace(pace)
    , m_interface(std::move(interface))
    , m_timer(time)
    , m_read(clock)
{
}

Result<std::unique_ptr<ReplayLink>> ReplayLink::create(const LinkAddress &address, Clock &clock)
{
    double pace = 1.0;
    std::string interface;
    for (const auto &[key, value] : address.options) {
        if (key == "speed") {
            MB_TRY(const auto parsed, parsePace(value));
            pace = parsed;
        } else if (key == "interface") {
            interface = value;
        } else {
            return fail(
                Fault::OutOfRange, say("replay links have no option '%1'", key), say("they have speed and interface"));
        }
    }
    return std::unique_ptr<ReplayLink>(new ReplayLink(address, clock, pace, std::move(interface)));
}

Result<void> ReplayLink::doOpen()
{
    MB_TRY(auto file, RecordingFile::open(address().path, m_interface));
    take(std::move(file));
    return {};
}

Task<void> ReplayLink::doOpenSoon(Background &background)
{
    const std::string path = address().path;
    auto opening = inBackground<std::unique_ptr<RecordingFile>>(
        background, outer, path, openLimit,
        [path, interface = m_interface] { return RecordingFile::open(path, interface); }, WhenLate::Drop);
    Result<std::unique_ptr<RecordingFile>> file = co_await std::move(opening).attempt();
    if (!file && file.error().fault == Fault::Timeout)
        co_return fail(Fault::LinkLost, say("the disk of %1 does not answer", address().shortName()),
            say("copy the recording to another one"));
    if (!file)
        co_return fail(file.error());
    take(std::move(*file));
    co_return {};
}

void ReplayLink::take(std::unique_ptr<RecordingFile> file)
{
    m_file = std::move(file);
    time.pause();
    time.jump(instantOf(m_file->start()));
    armNext();
}

void ReplayLink::doClose()
{
    time.pause();
    m_timer.stop();
    m_read.stop();
    m_goesOn = false;
    m_next.reset();
    m_file.reset();
}

Result<void> ReplayLink::doSend(const CanFrame &, Priority)
{
    return address().takesOrders();
}

ReplayState ReplayLink::replay() const
{
    ReplayState state;
    state.pace = m_pace;
    if (!m_file)
        return state;
    state.start = m_file->start();
    state.position = std::max(time.now() - instantOf(m_file->start()), Duration::zero());
    state.length = std::max(m_file->end() - m_file->start(), state.position);
    state.surveyed = m_file->surveyedFraction();
    state.running = time.isRunning() || m_goesOn;
    state.ended = m_atEnd;
    return state;
}

void ReplayLink::play()
{
    if (state() != LinkState::Open || m_atEnd)
        return;
    m_goesOn = m_read.isActive();
    if (!m_goesOn)
        time.run(m_pace);
}

void ReplayLink::pause()
{
    m_goesOn = false;
    time.pause();
}

Result<void> ReplayLink::setPace(double pace)
{
    if (!isPace(pace))
        return wrongPace(std::to_string(pace));
    m_pace = pace;
    if (time.isRunning())
        time.run(pace);
    return {};
}

Result<void> ReplayLink::seek(Duration position)
{
    if (!m_file)
        return fail(notOpen());
    position = std::clamp(position, Duration::zero(), std::max(m_file->end() - m_file->start(), Duration::zero()));
    const bool running = time.isRunning() || m_goesOn;
    pause();
    MB_TRY_VOID(m_file->seek(m_file->start() + position));
    forgetHealth();
    time.jump(instantOf(m_file->start() + position));
    armNext();
    if (running)
        play();
    return {};
}

Result<bool> ReplayLink::survey(const std::function<void(const LoggedFrame &)> &seen)
{
    if (!m_file)
        return fail(notOpen());
    return m_file->survey(seen);
}

/// A damaged line ends the replay: survey() has named it.
void ReplayLink::armNext()
{
    auto next = m_file->next();
    m_next = next ? std::move(*next) : std::nullopt;
    m_timer.stop();
    m_read.stop();
    m_atEnd = !m_next && !(next && m_file->isReadingOn());
    if (!m_next && !m_atEnd) {
        m_goesOn = m_goesOn || time.isRunning();
        time.pause();
        m_read.startIn(Duration::zero(), [this] { readOn(); });
    }
    if (m_next)
        m_timer.start(instantOf(m_next->time), [this] { deliverNext(); });
}

void ReplayLink::readOn()
{
    armNext();
    if (m_read.isActive())
        return;
    const bool goesOn = std::exchange(m_goesOn, false);
    if (m_atEnd)
        tellEnd();
    else if (goesOn)
        time.run(m_pace);
}

void ReplayLink::deliverNext()
{
    CanFrame frame = m_next->frame;
    frame.time = instantOf(m_next->time);
    const bool sent = m_next->direction == LogDirection::Sent && !frame.error;
    armNext();
    if (m_atEnd)
        time.pause(); // before anybody hears: it may be closed or sought from there
    if (sent)
        passed(Traffic{frame.time, Direction::Sent, &frame, {}});
    else
        deliver(frame);
    endBatch();
    if (m_atEnd)
        tellEnd();
}

void ReplayLink::tellEnd()
{
    if (m_file && m_file->isCutShort())
        lose({Fault::LinkLost, say("%1 was changed while it was played", address().shortName()), say("open it again")});
    else
        m_ended.notify();
}

} // namespace mb
