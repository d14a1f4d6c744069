// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/unixsocket.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace mb {

Error busySocket(const std::string &path)
{
    return {Fault::LinkLost, say("%1 is busy: it serves one client at a time", path), {}, {}, Ailment::Busy};
}

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

Error causeOf(int error, const std::string &path)
{
    switch (error) {
    case ENOENT:
        return {Fault::LinkLost, say("there is no socket %1", path), say("start the simulator first"),
            "motorbenchctl simulate --on unix:" + path, Ailment::NotThere};
    case ECONNREFUSED:
        return {
            Fault::LinkLost, say("nobody serves %1", path), say("start the simulator again"), {}, Ailment::NotThere};
    case EACCES: return {Fault::LinkLost, say("no permission to use %1", path), {}, {}, Ailment::NoPermission};
    case EAGAIN: return busySocket(path);
    case EADDRINUSE:
        return {Fault::LinkLost, say("%1 is served by another program already", path), {}, {}, Ailment::Busy};
    default: return {Fault::LinkLost, say("%1: %2", path, std::strerror(error))};
    }
}

tl::unexpected<Error> lost(int error, const std::string &path)
{
    return fail(causeOf(error, path));
}

tl::unexpected<Error> tooLong(const std::string &path)
{
    return fail(Fault::OutOfRange, say("'%1' is no path of a socket: it has 1 to 107 characters", path));
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
            return fail(Fault::LinkLost, say("%1 exists and is no socket", path), say("choose another path"));
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
        if (error == ENOENT)
            return fail(
                Fault::LinkLost, say("%1 cannot be made: %2", path, std::strerror(error)), say("choose another path"));
        return lost(error, path);
    }
    return descriptor;
}

bool receiveFrom(int descriptor, std::vector<std::uint8_t> &in)
{
    std::array<std::uint8_t, 4096> chunk{};
    const auto got = ::recv(descriptor, chunk.data(), chunk.size(), MSG_DONTWAIT);
    if (got <= 0)
        return got < 0 && (errno == EAGAIN || errno == EINTR);
    in.insert(in.end(), chunk.begin(), chunk.begin() + got);
    return true;
}

} // namespace mb
