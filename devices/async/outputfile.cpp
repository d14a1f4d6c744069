// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/outputfile.h"

#include <cerrno>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mb {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t enough = 64 * 1024;
constexpr int mostLinks = 40;
constexpr int mostNames = 1000;

int writeAll(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t done = ::write(descriptor, bytes.data(), bytes.size());
        if (done < 0 && errno != EINTR)
            return errno;
        if (done > 0)
            bytes.remove_prefix(static_cast<std::size_t>(done));
    }
    return 0;
}

/// Where a chain of symbolic links ends, whether or not there is something.
std::string followed(const std::string &path)
{
    fs::path at(path);
    std::error_code error;
    for (int i = 0; i < mostLinks && fs::is_symlink(at, error); ++i) {
        const fs::path next = fs::read_symlink(at, error);
        at = next.is_absolute() ? next : at.parent_path() / next;
    }
    return at.string();
}

/// The rename is on the disk as well. A file system that cannot do that has done what it can.
void syncFolder(const std::string &file)
{
    const fs::path folder = fs::path(file).parent_path();
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    (void)::fsync(descriptor);
    ::close(descriptor);
}

} // namespace

Error writeFailure(Fault fault, int systemError)
{
    switch (systemError) {
    case ENOSPC:
    case EDQUOT: return {fault, say("the disk is full"), say("make room, or choose another place")};
    case EACCES:
    case EPERM:
    case EROFS: return {fault, say("no permission to write there"), say("choose another folder")};
    case ENOENT:
    case ENOTDIR: return {fault, say("there is no such folder"), say("choose another one")};
    case EISDIR: return {fault, say("it is a folder"), say("name a file")};
    case EFBIG: return {fault, say("the file has reached the greatest size there"), say("choose another place")};
    case ENXIO: return {fault, say("nobody reads from this pipe"), say("start the reader first")};
    case EPIPE: return {fault, say("its reader has gone"), say("start it again")};
    case ENOTBLK: return {fault, say("it is a disk"), say("name a file")};
    default: return {fault, say("it cannot be written (system error %1)", systemError), say("check the disk")};
    }
}

Error notWritten(Fault fault, const std::string &path, int systemError)
{
    Error error = writeFailure(fault, systemError);
    error.detail = say("%1 cannot be written: %2", path, error.detail);
    return error;
}

Result<void> checkWritable(const std::string &path)
{
    struct stat status { };
    if (::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode))
        return {};
    return OutputFile(path).open();
}

OutputFile::OutputFile(std::string path)
    : m_path(std::move(path))
{
}

OutputFile::~OutputFile()
{
    closeFile();
    if (!m_temporary.empty())
        ::unlink(m_temporary.c_str());
}

tl::unexpected<Error> OutputFile::notOpened(int number) const
{
    return fail(notWritten(Fault::OutOfRange, m_path, number));
}

tl::unexpected<Error> OutputFile::notKept(int number) const
{
    return fail(notWritten(Fault::NotKept, m_path, number));
}

Result<void> OutputFile::open()
{
    struct stat status { };
    const bool exists = ::stat(m_path.c_str(), &status) == 0;
    if (m_path.empty() || (!exists && errno != ENOENT))
        return notOpened(m_path.empty() ? ENOENT : errno);
    if (exists && S_ISDIR(status.st_mode))
        return notOpened(EISDIR);
    if (exists && S_ISBLK(status.st_mode))
        return notOpened(ENOTBLK);
    if (!exists || S_ISREG(status.st_mode))
        return openBeside();
    m_descriptor = ::open(m_path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    if (m_descriptor < 0)
        return notOpened(errno);
    (void)::fcntl(m_descriptor, F_SETFL, O_WRONLY); // only the opening must not wait
    return {};
}

Result<void> OutputFile::openBeside()
{
    m_target = followed(m_path);
    struct stat old { };
    const bool exists = ::stat(m_target.c_str(), &old) == 0;
    if (exists && ::access(m_target.c_str(), W_OK) != 0)
        return notOpened(errno);
    for (int i = 0; i < mostNames && m_descriptor < 0; ++i) {
        const std::string name = m_target + '.' + std::to_string(::getpid()) + '-' + std::to_string(i) + ".part";
        m_descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (m_descriptor >= 0)
            m_temporary = name;
        else if (errno != EEXIST)
            return notOpened(errno);
    }
    if (m_descriptor < 0)
        return notOpened(EEXIST);
    if (exists)
        (void)::fchmod(m_descriptor, old.st_mode & 07777U);
    return {};
}

void OutputFile::write(std::string_view bytes)
{
    m_buffer += bytes;
    if (m_buffer.size() >= enough)
        drain();
}

void OutputFile::drain()
{
    if (m_error == 0)
        m_error = writeAll(m_descriptor, m_buffer);
    m_buffer.clear();
}

int OutputFile::closeFile()
{
    const int descriptor = std::exchange(m_descriptor, -1);
    return descriptor < 0 || ::close(descriptor) == 0 ? 0 : errno;
}

Result<void> OutputFile::commit()
{
    drain();
    const bool syncs = !m_temporary.empty();
    if (m_error == 0 && syncs && ::fsync(m_descriptor) != 0)
        m_error = errno;
    if (const int error = closeFile(); m_error == 0)
        m_error = error;
    if (m_error != 0)
        return notKept(m_error);
    return syncs ? replace() : Result<void>();
}

Result<void> OutputFile::replace()
{
    if (::rename(m_temporary.c_str(), m_target.c_str()) != 0)
        return notKept(errno);
    m_temporary.clear();
    syncFolder(m_target);
    return {};
}

Result<void> writeFile(const std::string &path, std::string_view bytes)
{
    OutputFile file(path);
    MB_TRY_VOID(file.open());
    file.write(bytes);
    return file.commit();
}

} // namespace mb
