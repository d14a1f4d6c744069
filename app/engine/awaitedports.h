// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/linkaddress.h"

#include <functional>
#include <set>
#include <string>

namespace mb {

/// Serial ports that the user asked for while their adapter was not plugged in: opened once it is.
class AwaitedPorts {
public:
    /// Remembers the port if its device file is not there.
    void add(const LinkAddress &address);
    void forget(const std::string &address) { m_addresses.erase(address); }
    /// Calls `open` for each whose device file is there now. It may be there and not ready yet: each is remembered until forget().
    void look(const std::function<void(const LinkAddress &)> &open) const;

private:
    std::set<std::string> m_addresses;
};

} // namespace mb
