// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/linkaddress.h"

#include <algorithm>
#include <array>

namespace mb {
namespace {

constexpr std::string_view repeatable = "fault"; ///< several may happen to a simulated link

constexpr std::array schemes{"sim", "socketcan", "qtcan", "serial", "spidev", "unix", "replay", "pty"};

Result<void> parseOptions(std::string_view text, std::vector<std::pair<std::string, std::string>> &out)
{
    while (!text.empty()) {
        const std::string_view item = text.substr(0, text.find('&'));
        text.remove_prefix(std::min(text.size(), item.size() + 1));
        const auto equals = item.find('=');
        if (equals == std::string_view::npos || equals == 0 || equals + 1 == item.size())
            return fail(Fault::OutOfRange, say("link option '%1' is not KEY=VALUE", item));
        const std::string_view key = item.substr(0, equals);
        const bool isThere = std::ranges::any_of(out, [key](const auto &option) { return option.first == key; });
        if (isThere && key != repeatable)
            return fail(
                Fault::OutOfRange, say("link option '%1' is there twice", key), say("leave one of the two out"));
        out.emplace_back(key, item.substr(equals + 1));
    }
    return {};
}

} // namespace

std::string_view toString(LinkKind kind)
{
    switch (kind) {
    case LinkKind::Can: return "can";
    case LinkKind::Serial: return "serial";
    case LinkKind::Spi: return "spi";
    }
    return "";
}

Result<LinkAddress> LinkAddress::parse(std::string_view text)
{
    const auto colon = text.find(':');
    if (colon == std::string_view::npos)
        return fail(
            Fault::Usage, say("'%1' is not a link: SCHEME:PATH is needed, such as socketcan:can0 or sim:", text));
    LinkAddress address;
    address.scheme = text.substr(0, colon);
    if (std::ranges::find(schemes, address.scheme) == schemes.end())
        return fail(Fault::Usage,
            say("unknown link kind '%1': sim, socketcan, qtcan, serial, spidev, unix and replay are known",
                address.scheme));
    const std::string_view rest = text.substr(colon + 1);
    const auto question = rest.find('?');
    address.path = rest.substr(0, question);
    if (question != std::string_view::npos)
        MB_TRY_VOID(parseOptions(rest.substr(question + 1), address.options));
    if (address.isSimulated()) {
        if (!address.path.empty() && address.path != "can" && address.path != "serial" && address.path != "spi")
            return fail(Fault::OutOfRange,
                say("there is no simulated link 'sim:%1': can, serial and spi are known", address.path));
    } else if (address.path.empty()) {
        return fail(Fault::OutOfRange, say("'%1' names no interface", text));
    }
    return address;
}

std::string LinkAddress::text() const
{
    std::string out = scheme + ':' + path;
    char separator = '?';
    for (const auto &[key, value] : options) {
        out += separator;
        out += key + '=' + value;
        separator = '&';
    }
    return out;
}

std::string LinkAddress::shortName() const
{
    if (isSimulated())
        return scheme + ':' + path;
    const auto slash = path.find_last_of('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

Result<void> LinkAddress::takesOrders() const
{
    if (!isRecording())
        return {};
    return fail(Fault::Unsupported, say("%1 is a recording: it can be watched, not written to or driven", shortName()),
        say("open the link that it was made on"));
}

std::optional<std::string_view> LinkAddress::option(std::string_view key) const
{
    for (const auto &[name, value] : options) {
        if (name == key)
            return value;
    }
    return std::nullopt;
}

bool isSimulatedLink(std::string_view address)
{
    const auto parsed = LinkAddress::parse(address);
    return parsed && parsed->isSimulated();
}

LinkKind kindOf(const LinkAddress &address)
{
    if (address.scheme == "serial" || address.scheme == "pty" || (address.isSimulated() && address.path == "serial"))
        return LinkKind::Serial;
    if (address.scheme == "spidev" || address.scheme == "unix" || (address.isSimulated() && address.path == "spi"))
        return LinkKind::Spi;
    return LinkKind::Can;
}

} // namespace mb
