// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/backgroundfile.h"

#include "async/descriptor.h"
#include "async/outputfile.h"

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr std::size_t worthWriting = 64 * 1024;

/// Of what is no regular file 0, as of what is not open.
nlink_t namesOf(int descriptor)
{
    struct stat status { };
    return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) ? status.st_nlink : 0;
}

} // namespace

BackgroundFile::BackgroundFile(std::string path, int descriptor)
    : m_path(std::move(path))
    , m_descriptor(descriptor)
    , m_hasName(namesOf(descriptor) > 0)
    , m_writer([this] { run(); })
{
}

Result<std::unique_ptr<BackgroundFile>> BackgroundFile::create(const std::string &path)
{
    Descriptor descriptor(::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666));
    if (descriptor.get() < 0)
        return fail(writeFailure(Fault::LinkLost, errno).about(path));
    if (namesOf(descriptor.get()) > 0) {
        if (::flock(descriptor.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
            return fail(
                Error{Fault::LinkLost, say("it is being recorded or replayed"), say("choose another place")}.about(
                    path));
        if (::ftruncate(descriptor.get(), 0) != 0)
            return fail(writeFailure(Fault::LinkLost, errno).about(path));
    }
    return std::unique_ptr<BackgroundFile>(new BackgroundFile(path, descriptor.give()));
}

BackgroundFile::~BackgroundFile()
{
    finish();
    m_writer.join();
}

bool BackgroundFile::append(std::string_view record)
{
    const std::lock_guard lock(m_mutex);
    if (m_finish || !m_status.problem.empty() || m_waiting.size() + record.size() > mostWaiting) {
        ++m_status.refused;
        return false;
    }
    m_waiting += record;
    m_waitingEnds.push_back(m_waiting.size());
    ++m_status.taken;
    if (m_waiting.size() >= worthWriting)
        m_wake.notify_one();
    return true;
}

void BackgroundFile::flush()
{
    const std::lock_guard lock(m_mutex);
    m_flush = true;
    m_wake.notify_one();
}

void BackgroundFile::finish()
{
    const std::lock_guard lock(m_mutex);
    m_finish = true;
    m_wake.notify_one();
}

BackgroundFile::Status BackgroundFile::status() const
{
    const std::lock_guard lock(m_mutex);
    return m_status;
}

void BackgroundFile::run()
{
    std::unique_lock lock(m_mutex);
    std::string text;
    std::vector<std::size_t> ends;
    while (true) {
        m_wake.wait(lock, [this] { return m_finish || m_flush || m_waiting.size() >= worthWriting; });
        const bool last = m_finish;
        m_flush = false;
        text.clear();
        text.swap(m_waiting);
        ends.clear();
        ends.swap(m_waitingEnds);
        if (m_status.problem.empty() && !text.empty()) {
            lock.unlock();
            Written written = writeAll(text);
            const std::size_t records = written.problem.empty() ? ends.size() : keepWhole(ends, written.bytes);
            lock.lock();
            m_status.written += records;
            m_status.problem = std::move(written.problem);
        }
        if (isDeleted() && m_status.problem.empty()) {
            m_status.written = 0;
            m_status.problem
                = Error{Fault::LinkLost, say("the file was deleted while it was written"), say("write it anew")}
                      .about(m_path)
                      .message();
        }
        if (last)
            break;
    }
    lock.unlock();
    const int failed = ::close(m_descriptor) == 0 ? 0 : errno;
    lock.lock();
    if (failed != 0 && m_status.problem.empty())
        m_status.problem = writeFailure(Fault::LinkLost, failed).about(m_path).message();
    m_status.finished = true;
}

/// What is written then nobody finds any more.
bool BackgroundFile::isDeleted() const
{
    return m_hasName && namesOf(m_descriptor) == 0;
}

/// No problem when all is written.
BackgroundFile::Written BackgroundFile::writeAll(std::string_view text) const
{
    Written written;
    while (written.bytes < text.size()) {
        const ssize_t done = ::write(m_descriptor, text.data() + written.bytes, text.size() - written.bytes);
        if (done >= 0) {
            written.bytes += static_cast<std::size_t>(done);
        } else if (errno != EINTR) {
            written.problem = writeFailure(Fault::LinkLost, errno).about(m_path).message();
            break;
        }
    }
    return written;
}

/// Of what was written before the disk was full, the half of a record that came last is taken away; yields how many are whole.
std::size_t BackgroundFile::keepWhole(const std::vector<std::size_t> &ends, std::size_t written) const
{
    const auto half = std::upper_bound(ends.begin(), ends.end(), written);
    const std::size_t whole = half == ends.begin() ? 0 : *std::prev(half);
    const off_t end = ::lseek(m_descriptor, 0, SEEK_CUR);
    if (end >= 0 && written > whole) // what is no regular file cannot be cut
        (void)!::ftruncate(m_descriptor, end - static_cast<off_t>(written - whole));
    return static_cast<std::size_t>(half - ends.begin());
}

} // namespace mb
