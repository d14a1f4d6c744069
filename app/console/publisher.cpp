// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/publisher.h"

#include "wire/number.h"

namespace mb::console {
namespace {

constexpr int usualMqttPort = 1883;
constexpr int highestPort = 65535;

Error notAnAddress(const std::string &text, const Message &why)
{
    return {Fault::OutOfRange, say("--to '%1': %2", text, why), say("give mqtt://HOST/TOPIC or udp://HOST:PORT")};
}

/// HOST or HOST:PORT; [::1]:PORT for numbers of IPv6.
Result<void> parseHost(const std::string &text, const std::string &whole, PublishAddress &into)
{
    std::string host = text;
    std::string port;
    if (!host.empty() && host.front() == '[') {
        const std::size_t end = host.find(']');
        if (end == std::string::npos)
            return fail(notAnAddress(whole, say("']' is missing")));
        port = host.substr(end + 1);
        host = host.substr(1, end - 1);
        if (!port.empty() && port.front() == ':')
            port.erase(0, 1);
    } else if (const std::size_t colon = host.rfind(':'); colon != std::string::npos) {
        port = host.substr(colon + 1);
        host.erase(colon);
        if (port.empty())
            return fail(notAnAddress(whole, say("the port is missing")));
    }
    if (host.empty())
        return fail(notAnAddress(whole, say("the host is missing")));
    into.host = host;
    if (port.empty())
        return {};
    const auto number = wholeFrom<int>(port);
    if (!number || *number < 1 || *number > highestPort)
        return fail(notAnAddress(whole, say("'%1' is no port, 1 to 65535", port)));
    into.port = *number;
    return {};
}

} // namespace

Result<PublishAddress> PublishAddress::parse(const std::string &text)
{
    PublishAddress address;
    const std::size_t colon = text.find("://");
    address.scheme = colon == std::string::npos ? std::string() : text.substr(0, colon);
    if (address.scheme != "mqtt" && address.scheme != "udp")
        return fail(notAnAddress(text, say("it begins with neither mqtt:// nor udp://")));
    std::string rest = text.substr(colon + 3);
    if (address.scheme == "mqtt") {
        const std::size_t slash = rest.find('/');
        address.topic = slash == std::string::npos ? std::string() : rest.substr(slash + 1);
        if (address.topic.empty() || address.topic.find_first_of("+#") != std::string::npos)
            return fail(notAnAddress(text, say("a topic is needed, without + and #")));
        rest = rest.substr(0, slash);
    }
    MB_TRY_VOID(parseHost(rest, text, address));
    if (address.port == 0 && address.scheme == "udp")
        return fail(notAnAddress(text, say("the port is missing")));
    if (address.port == 0)
        address.port = usualMqttPort;
    return address;
}

Error silence(const PublishAddress &address)
{
    return {Fault::LinkLost, say("%1 does not answer", address.name()),
        address.scheme == "mqtt" ? say("check that an MQTT broker listens there") : say("check the name of the host")};
}

void Publisher::publish(
    const std::string &device, std::string_view channel, double seconds, double value, std::string_view unit)
{
    if (!send(device, channel, seconds, value, unit))
        ++m_dropped;
}

} // namespace mb::console
