// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/backgroundfile.h"

#include "async/outputfile.h"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr std::size_t worthWriting = 64 * 1024;

} // namespace

BackgroundFile::BackgroundFile(std::string path, int descriptor)
    : m_path(std::move(path))
    , m_descriptor(descriptor)
    , m_writer([this] { run(); })
{
}

Result<std::unique_ptr<BackgroundFile>> BackgroundFile::create(const std::string &path)
{
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NONBLOCK, 0666);
    if (descriptor < 0)
        return fail(Error::fromPhrase(Fault::LinkLost, path + ": " + writeFailure(errno)));
    return std::unique_ptr<BackgroundFile>(new BackgroundFile(path, descriptor));
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
    ++m_waitingRecords;
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
    while (true) {
        m_wake.wait(lock, [this] { return m_finish || m_flush || m_waiting.size() >= worthWriting; });
        const bool last = m_finish;
        m_flush = false;
        text.clear();
        text.swap(m_waiting);
        const std::uint64_t records = std::exchange(m_waitingRecords, 0);
        if (m_status.problem.empty() && !text.empty()) {
            lock.unlock();
            std::string problem = writeAll(text);
            lock.lock();
            m_status.written += problem.empty() ? records : 0;
            m_status.problem = std::move(problem);
        }
        if (last)
            break;
    }
    lock.unlock();
    const int failed = ::close(m_descriptor) == 0 ? 0 : errno;
    lock.lock();
    if (failed != 0 && m_status.problem.empty())
        m_status.problem = m_path + ": " + writeFailure(failed);
    m_status.finished = true;
}

/// Empty when all is written, else why not.
std::string BackgroundFile::writeAll(std::string_view text) const
{
    while (!text.empty()) {
        const ssize_t done = ::write(m_descriptor, text.data(), text.size());
        if (done < 0 && errno == EINTR)
            continue;
        if (done < 0)
            return m_path + ": " + writeFailure(errno);
        text.remove_prefix(static_cast<std::size_t>(done));
    }
    return {};
}

} // namespace mb
