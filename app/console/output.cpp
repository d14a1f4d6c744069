// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/output.h"

#include "async/event.h"
#include "async/sleep.h"

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
constexpr int lastWords = 1000; // ms

/// What others wrote into names and notes moves no cursor: each control character is one '?'.
std::string printable(std::string_view text, std::string_view kept)
{
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
        const bool isPair = byte == 0xC2U && next >= 0x80U && next < 0xA0U; // U+0080 to U+009F
        const bool isControl
            = isPair || byte == 0x7FU || (byte < 0x20U && kept.find(text[i]) == std::string_view::npos);
        out += isControl ? '?' : text[i];
        i += isPair ? 1 : 0;
    }
    return out;
}

void put(const std::string &text, int patience)
{
    std::string line = text;
    std::replace(line.begin(), line.end(), '\n', ' ');
    line = printable(line, "\t");
    line += '\n';
    const Outlet outlet(STDERR_FILENO);
    const Outlet::Written written = outlet.write(line);
    if (written.error != 0 || written.bytes == line.size())
        return;
    pollfd room{outlet.descriptor(), POLLOUT, 0};
    if (::poll(&room, 1, patience) > 0)
        (void)outlet.write(std::string_view(line).substr(written.bytes));
}

} // namespace

Output::Output(Clock &clock)
    : m_clock(clock)
    , m_outlet(STDOUT_FILENO)
    , m_timer(clock)
    , m_posted(clock)
    , m_writable(m_outlet.descriptor(), QSocketNotifier::Write)
{
    m_writable.setEnabled(false);
    QObject::connect(&m_writable, &QSocketNotifier::activated, &m_writable, [this] { flush(); });
}

std::string onOneLine(std::string_view text)
{
    return printable(text, {});
}

void Output::line(std::string_view text)
{
    append(printable(text, "\n\t"));
}

void Output::append(std::string_view text)
{
    if (m_isBroken)
        return;
    m_buffer += text;
    m_buffer += '\n';
    if (m_buffer.size() >= mostWaiting)
        failed({Fault::Refused, say("nobody reads standard output, and what waits has grown too long"),
            say("read it, or write to a file")});
    else if (m_writable.isEnabled())
        return;
    else if (m_buffer.size() >= enough)
        flush();
    else if (!m_timer.isActive())
        m_timer.startIn(latency, [this] { flush(); });
}

void Output::json(const QJsonObject &object)
{
    const QByteArray text = QJsonDocument(object).toJson(QJsonDocument::Compact);
    append(std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
}

void Output::flush()
{
    m_timer.stop();
    if (isDone())
        return;
    const Outlet::Written written = m_outlet.write(m_buffer);
    m_buffer.erase(0, written.bytes);
    if (written.error == EPIPE)
        failed({Fault::Refused, {}});
    else if (written.error != 0)
        failed({Fault::Refused, say("standard output cannot be written: %1", std::strerror(written.error)),
            say("make room, or choose another place")});
    m_writable.setEnabled(!isDone());
    if (isDone())
        m_posted.startIn(Duration::zero(), [this] { m_done.notify(); });
}

bool Output::hasRoom() const
{
    return m_buffer.size() < enough;
}

Task<void> Output::room()
{
    co_await Sleep(m_clock, Duration::zero());
    if (hasRoom())
        co_return {};
    Event taken;
    const Subscription read = m_done.add([&taken] { taken.set(); });
    const Subscription gone = m_broken.add([&taken] { taken.set(); });
    co_await taken.wait();
    co_return {};
}

void Output::abandon()
{
    if (!isDone())
        failed({Fault::Refused, say("standard output was not read, and its end is lost"),
            say("read it, or write to a file")});
}

void Output::failed(Error error)
{
    m_isBroken = true;
    m_error = std::move(error);
    m_buffer.clear();
    m_writable.setEnabled(false);
    m_timer.startIn(Duration::zero(), [this] { m_broken.notify(); });
}

void complain(std::string_view text)
{
    put("motorbenchctl: " + std::string(text), 0);
}

void complainAtLast(std::string_view text)
{
    put("motorbenchctl: " + std::string(text), lastWords);
}

void complainPlain(std::string_view text)
{
    put(std::string(text), lastWords);
}

} // namespace mb::console
