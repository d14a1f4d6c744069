// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/output.h"

#include <QJsonDocument>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <poll.h>
#include <unistd.h>

namespace mb::console {
namespace {

constexpr std::size_t enough = 65536;
constexpr Duration latency = std::chrono::milliseconds(10);

/// 0, or the number of the error.
int writeAll(int descriptor, std::string_view text)
{
    while (!text.empty()) {
        const auto written = ::write(descriptor, text.data(), text.size());
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno == EAGAIN) {
            pollfd waiting{descriptor, POLLOUT, 0};
            ::poll(&waiting, 1, -1);
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

} // namespace

Output::Output(Clock &clock)
    : m_timer(clock)
{
}

void Output::line(std::string_view text)
{
    if (m_isBroken)
        return;
    m_buffer += text;
    m_buffer += '\n';
    if (m_buffer.size() >= enough)
        flush();
    else if (!m_timer.isActive())
        m_timer.startIn(latency, [this] { flush(); });
}

void Output::json(const QJsonObject &object)
{
    const QByteArray text = QJsonDocument(object).toJson(QJsonDocument::Compact);
    line(std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
}

void Output::flush()
{
    m_timer.stop();
    if (m_buffer.empty() || m_isBroken)
        return;
    if (const int number = writeAll(STDOUT_FILENO, m_buffer))
        failed(number);
    m_buffer.clear();
}

void Output::failed(int number)
{
    m_isBroken = true;
    if (number != EPIPE)
        m_error = std::string("standard output cannot be written: ") + std::strerror(number);
    m_timer.startIn(Duration::zero(), [this] { m_broken.notify(); });
}

void complain(std::string_view text)
{
    std::string line = "motorbenchctl: " + std::string(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    line += '\n';
    (void)writeAll(STDERR_FILENO, line);
}

} // namespace mb::console
