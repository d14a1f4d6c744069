// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/awaitedports.h"

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

void AwaitedPorts::look(const std::function<void(const LinkAddress &)> &open) const
{
    for (const std::string &text : std::set(m_addresses)) { // what opens at once is forgotten meanwhile
        if (const auto address = LinkAddress::parse(text); !isUnplugged(*address))
            open(*address);
    }
}

} // namespace mb
