// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/unixsocket.h"

#include <cerrno>
#include <cstring>
#include <optional>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace mb {
namespace {

std::optional<sockaddr_un> addressOf(const std::string &path)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.empty() || path.size() >= sizeof(address.sun_path))
        return std::nullopt;
    std::memcpy(address.sun_path, path.data(), path.size());
    return address;
}

const sockaddr *generic(const sockaddr_un &address)
{
    return reinterpret_cast<const sockaddr *>(&address);
}

std::string causeOf(int error, const std::string &path)
{
    switch (error) {
    case ENOENT:
        return "there is no socket " + path + "; start the simulator first: motorbenchctl simulate --on unix:" + path;
    case ECONNREFUSED: return "nobody serves " + path + "; start the simulator again";
    case EACCES: return "no permission to use " + path;
    case EAGAIN: return path + " is busy: it serves one client at a time";
    case EADDRINUSE: return path + " is served by another program already";
    default: return path + ": " + std::strerror(error);
    }
}

tl::unexpected<Error> lost(int error, const std::string &path)
{
    return fail(Error::fromPhrase(Fault::LinkLost, causeOf(error, path)));
}

tl::unexpected<Error> tooLong(const std::string &path)
{
    return fail(Fault::OutOfRange, "'" + path + "' is no path of a socket: it has 1 to 107 characters");
}

} // namespace

Result<int> connectUnixSocket(const std::string &path)
{
    const auto address = addressOf(path);
    if (!address)
        return tooLong(path);
    const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (descriptor < 0)
        return lost(errno, path);
    if (::connect(descriptor, generic(*address), sizeof(*address)) != 0) {
        const int error = errno;
        ::close(descriptor);
        return lost(error, path);
    }
    return descriptor;
}

namespace {

/// Only a socket that refuses is left over from somebody who has gone; one that is full has a server that is busy.
bool isServed(const sockaddr_un &address)
{
    const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const bool refused = descriptor < 0
        || (::connect(descriptor, generic(address), sizeof address) != 0 && (errno == ECONNREFUSED || errno == ENOENT));
    ::close(descriptor);
    return !refused;
}

} // namespace

Result<int> listenOnUnixSocket(const std::string &path)
{
    const auto address = addressOf(path);
    if (!address)
        return tooLong(path);
    struct stat there { };
    if (::lstat(path.c_str(), &there) == 0) {
        if (!S_ISSOCK(there.st_mode))
            return fail(Fault::LinkLost, path + " exists and is no socket", "choose another path");
        if (isServed(*address))
            return lost(EADDRINUSE, path);
        ::unlink(path.c_str());
    }
    const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (descriptor < 0)
        return lost(errno, path);
    if (::bind(descriptor, generic(*address), sizeof(*address)) != 0 || ::listen(descriptor, 1) != 0) {
        const int error = errno;
        ::close(descriptor);
        return lost(error, path);
    }
    return descriptor;
}

} // namespace mb
