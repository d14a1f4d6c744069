// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/spilink.h"

#include <random>

namespace mb {

class VirtualSpiLink;

/// The board's end of an SPI bus in memory.
class VirtualSpiSlaveLink final : public SpiSlaveLink {
public:
    explicit VirtualSpiSlaveLink(LinkAddress address)
        : SpiSlaveLink(std::move(address))
    {
    }

private:
    friend class VirtualSpiLink;
    Result<void> doOpen() override { return {}; }
    void doClose() override { }
    void doReadyChanged() override;

    VirtualSpiLink *m_master = nullptr;
};

/// The host's end: a byte takes eight clock periods, transfers end on the clock, the ready line is seen at once.
class VirtualSpiLink final : public SpiLink {
public:
    /// `hertz` of the bus clock; the board's end outlives this.
    VirtualSpiLink(LinkAddress address, Clock &clock, VirtualSpiSlaveLink &board, int hertz, std::uint64_t seed);
    ~VirtualSpiLink() override;

    /// This fraction of transfers has a bit flipped on its way to the host, 0…1.
    void setLoss(double fraction) { m_loss = fraction; }
    /// The board is unplugged.
    void unplug();

private:
    friend class VirtualSpiSlaveLink;
    Result<void> doOpen() override;
    void doClose() override;
    void doTransfer(const Bytes &mosi) override;
    Result<void> doPulseReset() override;
    void sampleReady();

    VirtualSpiSlaveLink &m_board;
    double m_loss = 0.0;
    std::mt19937_64 m_random;
    Timer m_done;
    Timer m_ready;
};

} // namespace mb
