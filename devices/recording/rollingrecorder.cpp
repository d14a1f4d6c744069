// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/rollingrecorder.h"

#include "recording/exportmcap.h"
#include "recording/joinrecordings.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace mb {
namespace {

namespace fs = std::filesystem;

constexpr Duration settling = std::chrono::milliseconds(100); ///< channels of a device are committed together
constexpr const char *lockName = "lock";
constexpr const char *lastName = "last-session";

/// A unit that has not told its serial number yet, or again, is the one before.
bool isSame(const ExportChannel &known, const ExportChannel &now)
{
    return known.unit == now.unit && (known.serial == now.serial || known.serial.empty() || now.serial.empty());
}

std::uint64_t lostBefore(const ExportChannel &channel, Instant time)
{
    for (const History::Gap &gap : channel.telemetry->gaps(channel.channel, time, time)) {
        if (gap.to == time)
            return gap.lost;
    }
    return 0;
}

} // namespace

RollingRecorder::RollingRecorder(Options options)
    : m_options(std::move(options))
    , m_path(m_options.folder + '/' + m_options.name)
{
}

RollingRecorder::~RollingRecorder()
{
    (void)endSegment();
    if (m_lock < 0)
        return;
    if (m_left) {
        ::close(m_lock);
        return;
    }
    std::error_code error;
    const std::string last = m_options.folder + '/' + lastName;
    fs::remove_all(m_segments.empty() ? m_path : last, error);
    if (!m_segments.empty()) {
        fs::rename(m_path, last, error);
        if (!error) // the lock last: what is cut short, or refused, is recovered at the next start
            fs::remove(last + '/' + lockName, error);
    }
    ::close(m_lock);
}

Result<void> RollingRecorder::lockFolder()
{
    std::error_code error;
    if (m_lock >= 0 && fs::exists(m_path + '/' + lockName, error))
        return {};
    if (m_lock >= 0)
        ::close(m_lock);
    fs::create_directories(m_path, error);
    m_lock = error ? -1 : ::open((m_path + '/' + lockName).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    if (m_lock < 0)
        return fail(Fault::OutOfRange,
            say("%1 cannot be written: %2", m_path, (error ? error.message() : std::string(std::strerror(errno)))));
    (void)::flock(m_lock, LOCK_EX | LOCK_NB);
    return {};
}

void RollingRecorder::follow(
    const std::vector<ExportChannel> &channels, std::vector<std::pair<std::string, mcap::Map>> about)
{
    for (Tracked &tracked : m_tracked)
        tracked.gone = true;
    for (const ExportChannel &channel : channels) {
        const auto known = std::ranges::find_if(m_tracked, [&](const Tracked &tracked) {
            return tracked.channel.telemetry == channel.telemetry && tracked.channel.channel == channel.channel;
        });
        const bool isKnown = known != m_tracked.end();
        if (isKnown && isSame(known->channel, channel)) {
            known->gone = false;
            const bool isNews = known->channel.serial.empty() && !channel.serial.empty();
            if (isNews || known->channel.device != channel.device) { // it has another number now
                const std::string serial = channel.serial.empty() ? known->channel.serial : channel.serial;
                known->channel = channel;
                known->channel.serial = serial;
                if (m_writer)
                    addToFile(*known);
            }
            continue;
        }
        if (isKnown)
            m_tracked.erase(known); // what it had in its unit, or of the one before, is forgotten there, too
        m_tracked.push_back({channel, SampleCursor(channel.telemetry, channel.channel), m_trackedEver++, isKnown});
        if (m_writer)
            addToFile(m_tracked.back());
    }
    m_aboutChanged = m_aboutChanged || about != m_about;
    m_about = std::move(about);
}

void RollingRecorder::addToFile(Tracked &tracked)
{
    mcap::Map about = aboutChannel(tracked.channel);
    about[trackFact] = std::to_string(tracked.number);
    tracked.id = m_writer->addChannel({tracked.channel.topic(), std::move(about)});
}

void RollingRecorder::note(Instant time, const std::string &text)
{
    m_newNotes.push_back({time, text});
}

Result<void> RollingRecorder::beginSegment(Instant now)
{
    MB_TRY_VOID(lockFolder());
    std::string number = std::to_string(m_number++);
    number.insert(0, 6 - std::min<std::size_t>(number.size(), 6), '0');
    Segment segment{m_path + "/segment-" + number + ".mcap", now, now, 0, 0, {}};
    for (const Tracked &tracked : m_tracked)
        segment.begins[tracked.number] = tracked.safe;
    MB_TRY(auto writer, McapWriter::create(segment.path));
    m_writer = std::move(writer);
    for (Tracked &tracked : m_tracked)
        addToFile(tracked);
    m_aboutChanged = true;
    m_safe = segment;
    m_segments.push_back(std::move(segment));
    return {};
}

Result<void> RollingRecorder::endSegment()
{
    if (!m_writer)
        return {};
    auto finished = m_writer->finish();
    m_segments.back().bytes = m_writer->bytes();
    if (finished)
        m_writer.reset();
    else
        salvage();
    return finished;
}

/// What was written is in the kernel's hands.
void RollingRecorder::settle()
{
    m_segments.back().bytes = m_writer->bytes();
    m_safe = m_segments.back();
    for (Tracked &tracked : m_tracked)
        tracked.safe = tracked.cursor.place();
    m_tracked.remove_if([](Tracked &tracked) { return tracked.gone && !tracked.cursor.peek(); });
}

/// The disk took less than it was given: the file ends where it was whole, and what it did not get is written again.
void RollingRecorder::salvage()
{
    m_writer.reset();
    for (Tracked &tracked : m_tracked)
        tracked.cursor.rewind(tracked.safe);
    std::error_code error;
    if (m_safe.samples > 0)
        fs::resize_file(m_safe.path, m_safe.bytes, error);
    else
        fs::remove(m_safe.path, error);
    m_segments.back() = m_safe;
    if (m_safe.samples == 0)
        m_segments.pop_back();
}

void RollingRecorder::writeSamples(Instant horizon)
{
    Segment &segment = m_segments.back();
    const auto timeOf = [horizon](Tracked &tracked) {
        const Point *next = tracked.cursor.peek(horizon);
        return next ? next->time : Instant::max();
    };
    while (true) {
        Tracked *earliest = nullptr;
        Instant time = Instant::max();
        for (Tracked &tracked : m_tracked) {
            if (const Instant next = timeOf(tracked); next < time) {
                time = next;
                earliest = &tracked;
            }
        }
        if (!earliest)
            return;
        Point point = *earliest->cursor.peek(horizon);
        earliest->cursor.pop();
        const bool gap = point.isGap();
        if (gap) { // its sample comes with it
            point = *earliest->cursor.peek(horizon);
            earliest->cursor.pop();
        }
        const std::uint64_t lost = gap ? lostBefore(earliest->channel, point.time) : 0;
        const Duration slept = m_sleeps.sleptAt(point.time);
        const bool isAfterSleep = std::exchange(earliest->slept, slept).value_or(slept) != slept;
        const bool isApart = std::exchange(earliest->isApart, false) || isAfterSleep || gap;
        m_writer->write(earliest->id, unixNanoseconds(point.time), point.value, lost, isApart);
        segment.last = std::max(segment.last, point.time);
        ++segment.samples;
    }
}

Result<void> RollingRecorder::write(Instant now, Duration unixOffset, const SleepLog &sleeps)
{
    followClock(now, unixOffset, sleeps);
    return writeUntil(now, now - settling);
}

Result<void> RollingRecorder::writeAll(Instant now, Duration unixOffset, const SleepLog &sleeps)
{
    followClock(now, unixOffset, sleeps);
    return writeUntil(now, now);
}

void RollingRecorder::followClock(Instant now, Duration unixOffset, const SleepLog &sleeps)
{
    m_unixOffset = m_unixOffset.value_or(unixOffset - sleeps.sleptAt(now));
    m_sleeps = sleeps;
}

std::int64_t RollingRecorder::unixNanoseconds(Instant time) const
{
    return (time.time_since_epoch() + *m_unixOffset + m_sleeps.sleptAt(time)).count();
}

Result<void> RollingRecorder::writeUntil(Instant now, Instant horizon)
{
    if (m_tracked.empty() && !m_writer)
        return {};
    auto missed = missWhatIsGone();
    auto written = writeSegment(now, horizon);
    m_failure = written ? std::nullopt : std::optional(written.error());
    prune(now);
    return written ? missed : written;
}

/// Writing would go on into a file that nobody finds any more.
Result<void> RollingRecorder::missWhatIsGone()
{
    std::error_code ignored;
    if (m_segments.empty() || fs::exists(m_segments.back().path, ignored))
        return {};
    m_writer.reset();
    std::map<std::size_t, SampleCursor::Place> begins;
    while (!m_segments.empty() && !fs::exists(m_segments.back().path, ignored)) {
        begins = std::move(m_segments.back().begins);
        m_segments.pop_back();
    }
    for (Tracked &tracked : m_tracked) {
        const auto begin = begins.find(tracked.number);
        tracked.safe = begin == begins.end() ? SampleCursor::Place() : begin->second;
        tracked.cursor.rewind(tracked.safe);
    }
    return fail(Fault::OutOfRange, say("%1 was taken away; what memory still has of it is recorded anew", m_path),
        say("leave that folder where it is"));
}

Result<void> RollingRecorder::writeSegment(Instant now, Instant horizon)
{
    if (m_writer && now - m_segments.back().begun >= m_options.segment) {
        MB_TRY_VOID(endSegment());
    }
    if (!m_writer) {
        MB_TRY_VOID(beginSegment(now));
    }
    if (m_aboutChanged) {
        for (const auto &[name, facts] : m_about)
            m_writer->metadata(name, facts);
        m_aboutChanged = false;
    }
    for (const TimedNote &note : m_newNotes)
        m_writer->metadata("note", {{"time", std::to_string(unixNanoseconds(note.time))}, {"text", note.text}});
    writeSamples(horizon);
    auto flushed = m_writer->flush();
    if (!flushed) {
        salvage();
        return flushed;
    }
    m_newNotes.clear();
    settle();
    return {};
}

void RollingRecorder::prune(Instant now)
{
    if (m_keeping)
        return;
    while (m_segments.size() > 1 && (now - m_segments.front().last > m_options.keep || bytes() > m_options.mostBytes)) {
        std::error_code ignored;
        fs::remove(m_segments.front().path, ignored);
        m_segments.pop_front();
    }
}

Result<ExportReport> RollingRecorder::save(const std::string &path, const ExportProgress &progress)
{
    if (m_failure)
        return fail(*m_failure);
    (void)endSegment(); // its samples are all there, though a summary may find no room
    std::vector<std::string> paths;
    for (const Segment &segment : m_segments)
        paths.push_back(segment.path);
    auto joined = joinRecordings(paths, path, progress);
    if (joined)
        m_keeping = false;
    return joined;
}

std::uint64_t RollingRecorder::bytes() const
{
    std::uint64_t sum = 0;
    for (const Segment &segment : m_segments)
        sum += segment.bytes;
    return sum;
}

std::uint64_t RollingRecorder::samples() const
{
    std::uint64_t sum = 0;
    for (const Segment &segment : m_segments)
        sum += segment.samples;
    return sum;
}

std::optional<Instant> RollingRecorder::since() const
{
    if (m_segments.empty())
        return std::nullopt;
    return m_segments.front().begun;
}

} // namespace mb
