// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/virtualspi.h"

namespace mb {

void VirtualSpiSlaveLink::doReadyChanged()
{
    if (m_master)
        m_master->sampleReady();
}

VirtualSpiLink::VirtualSpiLink(
    LinkAddress address, Clock &clock, VirtualSpiSlaveLink &board, int hertz, std::uint64_t seed)
    : SpiLink(std::move(address), clock, hertz)
    , m_board(board)
    , m_random(seed)
    , m_done(clock)
    , m_ready(clock)
{
}

VirtualSpiLink::~VirtualSpiLink()
{
    close();
    if (m_board.m_master == this)
        m_board.m_master = nullptr;
}

Result<void> VirtualSpiLink::doOpen()
{
    if (m_board.m_master && m_board.m_master != this)
        return fail(Fault::LinkLost, say("the simulated board is in use by another link"));
    m_board.m_master = this;
    setReady(m_board.slave() && m_board.slave()->isReady());
    return {};
}

void VirtualSpiLink::doClose()
{
    m_done.stop();
    m_ready.stop();
    m_board.m_master = nullptr;
    dropTransfers();
}

void VirtualSpiLink::unplug()
{
    m_done.stop();
    lose({Fault::LinkLost, say("the board was unplugged"), {}, {}, Ailment::Gone});
    dropTransfers();
}

void VirtualSpiLink::doTransfer(const Bytes &mosi)
{
    const auto wire = Duration(std::chrono::seconds(1)) * (8 * static_cast<std::int64_t>(mosi.size())) / clockRate();
    m_done.startIn(wire, [this, mosi] {
        Bytes miso(mosi.size());
        if (SpiSlave *slave = m_board.slave())
            slave->transfer(mosi, miso);
        if (!miso.empty() && std::uniform_real_distribution<>()(m_random) < m_loss)
            miso[m_random() % miso.size()] ^= static_cast<std::uint8_t>(1U << (m_random() % 8U));
        setReady(m_board.slave() && m_board.slave()->isReady());
        finishTransfer(std::move(miso));
    });
}

Result<void> VirtualSpiLink::doPulseReset()
{
    if (SpiSlave *slave = m_board.slave())
        slave->reset();
    return {};
}

void VirtualSpiLink::sampleReady()
{
    m_ready.startIn(Duration::zero(), [this] { setReady(m_board.slave() && m_board.slave()->isReady()); });
}

} // namespace mb
