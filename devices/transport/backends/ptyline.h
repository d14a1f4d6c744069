// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/backends/virtualserial.h"

#include <cstdint>
#include <memory>
#include <string>

class QSocketNotifier;

namespace mb {

/// A line in memory that ends at a pseudo terminal: simulated devices for another program, on the event loop of the thread
/// that opens it. Nothing collides on it: a terminal does not carry when bytes were sent, so what waited in it because one of
/// the two programs was late would meet answers that it never met. `pty:PATH?baud=N` (docs/names.md#links): PATH becomes a symbolic link to the terminal; without `baud` the line
/// has the speed that the program sets on it.
class PtyLine {
public:
    /// OutOfRange for an option that it does not have.
    [[nodiscard]] static Result<std::unique_ptr<PtyLine>> create(const LinkAddress &address, Clock &clock);
    ~PtyLine();

    /// Makes the terminal and the symbolic link. An old link to a terminal that is gone is replaced; anything else that is there stays
    /// and this fails with LinkLost.
    [[nodiscard]] Result<void> open();
    /// A closed end for one device; this outlives it.
    [[nodiscard]] std::unique_ptr<VirtualSerialLink> makeEnd();

private:
    PtyLine(LinkAddress address, Clock &clock);
    [[nodiscard]] Result<void> claimPath();
    [[nodiscard]] Result<void> openTerminal();
    [[nodiscard]] Result<void> putLink();
    void readTerminal();
    void writeTerminal(std::span<const std::uint8_t> bytes);
    void rest();

    LinkAddress m_address;
    VirtualSerialLine m_line;
    VirtualSerialLink m_bridge;
    Subscription m_received;
    int m_master = -1;
    int m_claim = -1;       ///< holds the path as long as this lives
    std::string m_terminal; ///< /dev/pts/N
    bool m_linked = false;
    std::unique_ptr<QSocketNotifier> m_notifier;
    Timer m_rest;
};

} // namespace mb
