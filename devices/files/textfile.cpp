// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/textfile.h"

#include "async/descriptor.h"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mb {
namespace {

tl::unexpected<Error> refused(const std::string &path, const Message &cause)
{
    return fail(Fault::OutOfRange, say("%1: %2", path, cause), say("check the path"));
}

/// Not by strerror(), whose words depend on the locale.
Message causeOf(int number)
{
    switch (number) {
    case ENOENT:
    case ENOTDIR: return say("no such file");
    case EACCES:
    case EPERM: return say("no permission to read it");
    case EISDIR: return say("is a directory");
    default: return say("cannot be read (system error %1)", number);
    }
}

Message tooLong(std::size_t maxBytes)
{
    return say("is longer than %1 bytes", maxBytes);
}

} // namespace

Result<std::string> readTextFile(const std::string &path, std::size_t maxBytes)
{
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)); // a pipe must not block
    struct stat status { };
    if (file.get() < 0 || ::fstat(file.get(), &status) != 0)
        return refused(path, causeOf(errno));
    if (S_ISDIR(status.st_mode))
        return refused(path, say("is a directory"));
    if (!S_ISREG(status.st_mode))
        return refused(path, say("is not a regular file"));
    if (status.st_size > 0 && static_cast<std::uintmax_t>(status.st_size) > maxBytes)
        return refused(path, tooLong(maxBytes));
    std::string text;
    std::array<char, 65536> block{};
    while (true) {
        const ssize_t got = ::read(file.get(), block.data(), block.size());
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return refused(path, causeOf(errno));
        if (got == 0)
            return text;
        if (text.size() + static_cast<std::size_t>(got) > maxBytes) // it grows, or has no size, as in /proc
            return refused(path, tooLong(maxBytes));
        text.append(block.data(), static_cast<std::size_t>(got));
    }
}

} // namespace mb
