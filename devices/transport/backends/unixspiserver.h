// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/spilink.h"

#include <memory>
#include <vector>

class QSocketNotifier;

namespace mb {

/// The board's side of UnixSpiLink: serves one client at a time and hangs up on every other. `pace=1` makes bytes
/// take the time that they take at 500 kHz.
class UnixSpiServer final : public SpiSlaveLink {
public:
    /// OutOfRange for an option that it does not have, or that has no such value.
    [[nodiscard]] static Result<std::unique_ptr<UnixSpiServer>> create(const LinkAddress &address, Clock &clock);
    /// Of an address whose options are good.
    UnixSpiServer(LinkAddress address, Clock &clock);
    ~UnixSpiServer() override;

private:
    using Bytes = std::vector<std::uint8_t>;

    Result<void> doOpen() override;
    void doClose() override;
    void doReadyChanged() override { }
    void accept();
    void hangUp();
    void receive();
    void serve();
    [[nodiscard]] Bytes answer(std::size_t length);
    void send(const Bytes &bytes);

    Clock &m_clock;
    bool m_paced;
    int m_listening = -1;
    int m_client = -1;
    Bytes m_in;
    std::unique_ptr<QSocketNotifier> m_calls;
    std::unique_ptr<QSocketNotifier> m_readable;
    Timer m_wire;
    Timer m_gone;
};

} // namespace mb
