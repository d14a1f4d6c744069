// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/outlet.h"

#include <cerrno>
#include <climits>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mb::console {

Outlet::Outlet(int shared)
    : m_shared(shared)
{
    struct stat status { };
    if (::fstat(shared, &status) != 0 || S_ISREG(status.st_mode) || S_ISBLK(status.st_mode))
        return;
    if (S_ISSOCK(status.st_mode)) {
        m_kind = Kind::Socket;
        return;
    }
    const std::string name = "/proc/self/fd/" + std::to_string(shared);
    m_own = ::open(name.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    m_kind = m_own >= 0 ? Kind::Own : Kind::Careful;
}

Outlet::~Outlet()
{
    if (m_own >= 0)
        ::close(m_own);
}

long Outlet::writeOnce(std::string_view text) const
{
    if (m_kind == Kind::Own)
        return ::write(m_own, text.data(), text.size());
    if (m_kind == Kind::Socket)
        return ::send(m_shared, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (m_kind == Kind::Plain)
        return ::write(m_shared, text.data(), text.size());
    pollfd room{m_shared, POLLOUT, 0};
    if (::poll(&room, 1, 0) == 0) {
        errno = EAGAIN;
        return -1;
    }
    return ::write(m_shared, text.data(), text.substr(0, PIPE_BUF).size()); // so much fits once there is room
}

Outlet::Written Outlet::write(std::string_view text) const
{
    Written result;
    while (result.bytes < text.size()) {
        const long done = writeOnce(text.substr(result.bytes));
        if (done >= 0) {
            result.bytes += static_cast<std::size_t>(done);
        } else if (errno == EAGAIN) {
            break;
        } else if (errno != EINTR) {
            result.error = errno;
            break;
        }
    }
    return result;
}

} // namespace mb::console
