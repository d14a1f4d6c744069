// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/identity.h"

#include "wire/number.h"

#include <array>
#include <cstdio>

namespace mb {
namespace {

std::optional<int> parseInt(std::string_view text, int base)
{
    const auto value = wholeFrom<int>(text, base);
    return value && *value >= 0 ? value : std::nullopt;
}

} // namespace

std::string_view toString(DeviceState state)
{
    switch (state) {
    case DeviceState::Duplicate: return "duplicate";
    case DeviceState::Unassigned: return "unassigned";
    case DeviceState::Bootloader: return "bootloader";
    case DeviceState::Online: return "online";
    }
    return "";
}

Result<DeviceSelector> DeviceSelector::parse(std::string_view text)
{
    const auto bad = [text] {
        return fail(Fault::OutOfRange,
            say("'%1' is not a device: LINK/FAMILY:ADDRESS is needed, such as sim:can/dmc60c:5", text));
    };
    const auto [linkText, device, addressText, sessionText] = partsOf(text);
    const auto colon = device.find(':');
    if (linkText.empty())
        return bad();
    MB_TRY(auto link, LinkAddress::parse(linkText));
    const auto address = parseInt(addressText, 10);
    if (colon == 0 || !address)
        return bad();
    DeviceSelector selector{std::move(link), std::string(device.substr(0, colon)), *address, std::nullopt};
    if (!sessionText.empty()) {
        selector.session = parseInt(sessionText.substr(1), 16);
        if (!selector.session)
            return bad();
    }
    return selector;
}

std::string DeviceSelector::text() const
{
    std::string out = link.text() + '/' + family + ':' + std::to_string(address);
    if (session) {
        std::array<char, 16> hex{};
        std::snprintf(hex.data(), hex.size(), "@%04x", static_cast<unsigned>(*session));
        out += hex.data();
    }
    return out;
}

SelectorParts partsOf(std::string_view selector)
{
    const auto slash = selector.rfind('/');
    SelectorParts parts;
    parts.link = selector.substr(0, slash == std::string_view::npos ? 0 : slash);
    parts.device = selector.substr(slash + 1); // all of it without a slash
    const auto colon = parts.device.find(':');
    if (colon == std::string_view::npos)
        return parts;
    const std::string_view number = parts.device.substr(colon + 1);
    parts.address = number.substr(0, number.find('@'));
    parts.session = number.substr(parts.address.size());
    return parts;
}

DeviceSelector selectorOf(const LinkAddress &link, const Identity &identity)
{
    DeviceSelector selector{link, identity.family, identity.address, std::nullopt};
    if (identity.state == DeviceState::Duplicate)
        selector.session = identity.session;
    return selector;
}

} // namespace mb
