// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/scans.h"

#include <string>
#include <vector>

namespace mb {

/// The links that are lent to whoever serves units there: the engine begins nothing on them meanwhile (Operations::lend), and no scan
/// waits for them. Engine thread.
class LentLinks {
public:
    LentLinks(const EngineContext &context, Scans &scans)
        : m_context(context)
        , m_scans(scans)
    {
    }
    LentLinks(const LentLinks &) = delete;
    LentLinks &operator=(const LentLinks &) = delete;
    ~LentLinks() { giveBack(); }

    /// From now on these are meant; those before have been given back.
    void choose(std::vector<std::string> addresses);
    [[nodiscard]] const std::vector<std::string> &addresses() const { return m_addresses; }
    /// All of them or none. Timeout: one is not there, or busy.
    [[nodiscard]] Result<void> take();
    void giveBack();
    /// As take() found them.
    [[nodiscard]] const std::vector<Link *> &links() const { return m_links; }
    /// None was closed since.
    [[nodiscard]] bool areThere() const;

private:
    [[nodiscard]] Link *linkAt(const std::string &address) const;
    [[nodiscard]] bool isDriven(const Link &link) const;
    [[nodiscard]] bool lend(Link *link);

    EngineContext m_context;
    Scans &m_scans;
    std::vector<std::string> m_addresses;
    std::vector<Link *> m_links;
};

} // namespace mb
