// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/recordingfile.h"

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr std::size_t pieceSize = 256 * 1024;

/// Not by strerror(), whose words depend on the locale.
Error unreadable(const std::string &path, int number)
{
    switch (number) {
    case ENOENT:
    case ENOTDIR: return {Fault::LinkLost, say("%1: no such file", path), say("check the path"), {}, Ailment::NotThere};
    case EACCES:
    case EPERM:
        return {Fault::LinkLost, say("%1: no permission to read it", path), say("change its mode, or copy it"), {},
            Ailment::NoPermission};
    default: return {Fault::LinkLost, say("%1: cannot be read (system error %2)", path, number), say("check the disk")};
    }
}

} // namespace

RecordingFile::RecordingFile(std::string path, std::string interface, int descriptor)
    : m_path(std::move(path))
    , m_interface(std::move(interface))
    , m_descriptor(descriptor)
{
}

RecordingFile::~RecordingFile()
{
    ::close(m_descriptor);
}

Result<std::unique_ptr<RecordingFile>> RecordingFile::open(const std::string &path, std::string interface)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); // a pipe must not block
    if (descriptor < 0)
        return fail(unreadable(path, errno));
    std::unique_ptr<RecordingFile> file(new RecordingFile(path, std::move(interface), descriptor));
    struct stat status { };
    if (::fstat(descriptor, &status) != 0)
        return fail(unreadable(path, errno));
    if (!S_ISREG(status.st_mode))
        return fail(Fault::OutOfRange, say("%1 is not a file", path), say("name a recording"));
    (void)::flock(descriptor, LOCK_SH | LOCK_NB); // nobody empties it; one that is being recorded is read as it is
    file->m_size = static_cast<std::uint64_t>(status.st_size);
    file->m_places.push_back({});
    MB_TRY(auto first, file->read(file->m_player));
    if (!first)
        return file->m_interface.empty()
            ? fail(Fault::OutOfRange, say("%1 has no frame in it", path), say("record again"))
            : fail(
                Fault::OutOfRange, say("%1 has no frame of %2", path, file->m_interface), say("leave out interface="));
    file->m_start = first->time;
    file->m_end = file->m_start;
    file->m_sought = std::move(first);
    return file;
}

/// The next line without its end, valid until the next call; nothing at the end of the file. `cut`: the end came first.
Result<std::optional<std::string_view>> RecordingFile::line(Cursor &cursor, bool &cut) const
{
    std::size_t end = cursor.text.find('\n', cursor.used);
    while (end == std::string::npos) {
        if (cursor.text.size() - cursor.used > FrameLogParser::longestLine)
            return fail(located(cursor.place.parser.tooLong()));
        cursor.text.erase(0, std::exchange(cursor.used, 0));
        const std::size_t kept = cursor.text.size();
        cursor.text.resize(kept + pieceSize);
        ssize_t got = -1;
        do {
            got = ::pread(
                m_descriptor, cursor.text.data() + kept, pieceSize, static_cast<off_t>(cursor.place.offset + kept));
        } while (got < 0 && errno == EINTR);
        const int cause = errno;
        cursor.text.resize(kept + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        if (got < 0)
            return fail(unreadable(m_path, cause));
        if (got == 0) {
            if (kept == 0)
                return std::optional<std::string_view>();
            cut = true;
            end = kept;
            break;
        }
        end = cursor.text.find('\n', kept);
    }
    const std::string_view text = std::string_view(cursor.text).substr(cursor.used, end - cursor.used);
    const std::size_t taken = text.size() + (cut ? 0 : 1);
    cursor.used += taken;
    cursor.place.offset += taken;
    return std::optional(text);
}

Result<std::optional<LoggedFrame>> RecordingFile::read(Cursor &cursor, std::uint64_t until) const
{
    while (cursor.place.offset < until) {
        bool cut = false;
        MB_TRY(const auto text, line(cursor, cut));
        if (!text)
            return std::optional<LoggedFrame>();
        auto frame = cut ? cursor.place.parser.parseLast(*text) : cursor.place.parser.parse(*text);
        if (!frame)
            return fail(located(frame.error()));
        if (!*frame || (!m_interface.empty() && (*frame)->link != m_interface))
            continue;
        cursor.place.time = std::max(cursor.place.time, (*frame)->time);
        (*frame)->time = cursor.place.time;
        return frame;
    }
    return std::optional<LoggedFrame>();
}

Result<std::optional<LoggedFrame>> RecordingFile::next()
{
    if (m_sought)
        return std::exchange(m_sought, std::nullopt);
    const std::uint64_t until = m_player.place.offset + pieceSize;
    auto frame = read(m_player, until);
    m_readsOn = frame && !*frame && m_player.place.offset >= until;
    return frame;
}

Result<void> RecordingFile::seek(Duration time)
{
    time = std::clamp(time, m_start, m_end);
    const auto after = std::lower_bound(m_places.begin(), m_places.end(), time,
        [](const Place &place, Duration wanted) { return place.time < wanted; });
    m_player = Cursor{after == m_places.begin() ? m_places.front() : *std::prev(after), {}, 0};
    m_sought.reset();
    do {
        MB_TRY(auto frame, read(m_player));
        m_sought = std::move(frame);
    } while (m_sought && m_sought->time < time);
    return {};
}

Result<bool> RecordingFile::survey(const std::function<void(const LoggedFrame &)> &seen)
{
    const std::uint64_t until = m_surveyor.place.offset + pieceSize;
    while (!m_surveyed && m_surveyor.place.offset < until) {
        const auto frame = read(m_surveyor, until);
        if (!frame || !*frame)
            m_surveyed = !frame || m_surveyor.place.offset < until;
        if (!frame)
            return fail(frame.error());
        if (*frame) {
            m_end = (*frame)->time;
            seen(**frame);
        }
        if (!m_surveyed && m_surveyor.place.offset - m_places.back().offset >= pieceSize)
            m_places.push_back(m_surveyor.place);
    }
    return m_surveyed;
}

double RecordingFile::surveyedFraction() const
{
    if (m_surveyed || m_size == 0)
        return 1.0;
    return std::min(1.0, static_cast<double>(m_surveyor.place.offset) / static_cast<double>(m_size));
}

} // namespace mb
