// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/awaitedports.h"

#include <filesystem>

namespace mb {
namespace {

bool isUnplugged(const LinkAddress &address)
{
    std::error_code ignored;
    return address.scheme == "serial" && address.path.find('/') != std::string::npos
        && !std::filesystem::exists(address.path, ignored);
}

} // namespace

void AwaitedPorts::add(const LinkAddress &address)
{
    if (isUnplugged(address))
        m_addresses.insert(address.text());
}

void AwaitedPorts::look(const std::function<bool(const LinkAddress &)> &open)
{
    std::erase_if(m_addresses, [&open](const std::string &text) {
        const auto address = LinkAddress::parse(text);
        return !isUnplugged(*address) && open(*address); // it may be there and not ready yet
    });
}

} // namespace mb
