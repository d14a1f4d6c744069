// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/scans.h"
#include "async/noncopyable.h"

#include <cstddef>
#include <string>
#include <vector>

namespace mb {

/// The links that are lent to whoever serves units there: the engine begins nothing on them meanwhile (Operations::lend), and no scan
/// waits for them. Engine thread.
class LentLinks : NonCopyable {
public:
    LentLinks(const EngineContext &context, Scans &scans)
        : m_context(context)
        , m_scans(scans)
    {
    }
    ~LentLinks() { giveBack(); }

    /// All of them, or none, and then those before are meant still. Those before have been given back. Refused: there is none; Timeout:
    /// one is not there, or busy.
    [[nodiscard]] Result<void> take(const std::vector<std::string> &addresses);
    /// Those that were given back once more.
    [[nodiscard]] Result<void> takeAgain() { return take(m_addresses); }
    [[nodiscard]] const std::vector<std::string> &addresses() const { return m_addresses; }
    void giveBack();
    /// Gives them back, and none is meant.
    void forget();
    /// As take() found them.
    [[nodiscard]] const std::vector<Link *> &links() const { return m_links; }
    /// None was closed since.
    [[nodiscard]] bool areThere() const;
    /// Whether one has been lost since this was asked last. While areThere().
    [[nodiscard]] bool isOneMoreLost();

private:
    [[nodiscard]] Link *linkAt(const std::string &address) const;
    [[nodiscard]] bool isDriven(const Link &link) const;
    [[nodiscard]] bool lend(Link *link);

    EngineContext m_context;
    Scans &m_scans;
    std::vector<std::string> m_addresses;
    std::vector<Link *> m_links;
    std::ptrdiff_t m_lost = 0;
};

} // namespace mb
