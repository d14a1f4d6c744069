// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <QByteArray>

#include <cstdint>
#include <string>

namespace mb::console {

/// Where samples go instead of standard output: `mqtt://HOST[:PORT]/TOPIC` or `udp://HOST:PORT`.
struct PublishAddress {
    std::string scheme; ///< "mqtt" or "udp"
    std::string host;
    int port = 0;
    std::string topic; ///< mqtt only

    /// "mqtt://HOST:PORT"
    [[nodiscard]] std::string name() const { return scheme + "://" + host + ':' + std::to_string(port); }
    /// OutOfRange for anything else, with what is taken.
    [[nodiscard]] static Result<PublishAddress> parse(const std::string &text);
};

/// That nobody answers there.
[[nodiscard]] Error silence(const PublishAddress &address);

/// Sends samples to another program as they come; never waits, never listens, and counts what did not go. One thread.
class Publisher {
public:
    virtual ~Publisher() = default;

    /// One sample: `device` is FAMILY:ADDRESS, `seconds` as in the lines of `watch`.
    void publish(
        const std::string &device, std::string_view channel, double seconds, double value, std::string_view unit);
    /// Samples that did not go: no broker, nobody at the address, or no room to send.
    [[nodiscard]] std::uint64_t dropped() const { return m_dropped; }
    /// Sends what is still waiting, for 2 s at most.
    virtual void finish() { }

protected:
    /// What was taken by send() and did not go after all.
    void drop(std::uint64_t count) { m_dropped += count; }
    /// False when it was not sent.
    [[nodiscard]] virtual bool send(
        const std::string &device, std::string_view channel, double seconds, double value, std::string_view unit)
        = 0;

private:
    std::uint64_t m_dropped = 0;
};

} // namespace mb::console
