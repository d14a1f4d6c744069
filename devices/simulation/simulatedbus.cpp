// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/simulatedbus.h"

#include "transport/backends/virtualcan.h"
#include "transport/backends/virtualserial.h"
#include "transport/backends/virtualspi.h"

#include <optional>

namespace mb {
namespace {

class SimulatedCan final : public SimulatedBus {
public:
    SimulatedCan(Clock &clock, int bitrate, std::uint64_t seed)
        : m_bus(clock, bitrate, seed)
    {
    }
    std::unique_ptr<Link> makeEnd(const LinkAddress &address) override
    {
        return std::make_unique<VirtualCanLink>(address, m_bus);
    }
    void setLoss(double fraction) override { m_bus.setLoss(fraction); }
    void dropOut(Link &end) override { m_bus.forceBusOff(static_cast<VirtualCanLink &>(end)); }

private:
    VirtualCanBus m_bus;
};

class SimulatedLine final : public SimulatedBus {
public:
    SimulatedLine(Clock &clock, int bitrate, std::uint64_t seed)
        : m_line(clock, VirtualSerialLine::Wiring::HalfDuplex, seed)
        , m_bitrate(bitrate)
    {
    }
    std::unique_ptr<Link> makeEnd(const LinkAddress &address) override
    {
        auto end = std::make_unique<VirtualSerialLink>(address, m_line);
        (void)end->setBaudrate(m_bitrate); // was checked
        return end;
    }
    void setLoss(double fraction) override { m_line.setLoss(fraction); }
    void dropOut(Link &end) override { m_line.pull(static_cast<VirtualSerialLink &>(end)); }

private:
    VirtualSerialLine m_line;
    int m_bitrate;
};

/// One board and its master.
class SimulatedSpi final : public SimulatedBus {
public:
    SimulatedSpi(Clock &clock, int hertz, std::uint64_t seed)
        : m_clock(clock)
        , m_hertz(hertz)
        , m_seed(seed)
    {
    }
    std::unique_ptr<Link> makeEnd(const LinkAddress &address) override
    {
        auto board = std::make_unique<VirtualSpiSlaveLink>(address);
        m_board = board.get();
        return board;
    }
    std::unique_ptr<Link> makeHost(const LinkAddress &address) override
    {
        if (!m_board)
            m_board = &m_nobody.emplace(address);
        auto host = std::make_unique<VirtualSpiLink>(address, m_clock, *m_board, m_hertz, m_seed);
        host->setLoss(m_loss);
        return host;
    }
    void setLoss(double fraction) override { m_loss = fraction; }
    void dropOut(Link &end) override { static_cast<VirtualSpiLink &>(end).unplug(); }

private:
    Clock &m_clock;
    int m_hertz;
    std::uint64_t m_seed;
    double m_loss = 0.0;
    VirtualSpiSlaveLink *m_board = nullptr; ///< the last one that was made
    std::optional<VirtualSpiSlaveLink> m_nobody;
};

struct Rates {
    int usual;
    int lowest;
    int highest;
};

Result<int> rateOf(int asked, const Rates &rates)
{
    const int rate = asked == 0 ? rates.usual : asked;
    if (rate < rates.lowest || rate > rates.highest)
        return fail(Fault::OutOfRange, say("link option bitrate=%1 is out of range", asked),
            say("legal is %1", std::to_string(rates.lowest) + " … " + std::to_string(rates.highest)));
    return rate;
}

template <class Bus>
Result<std::unique_ptr<SimulatedBus>> make(Clock &clock, int asked, std::uint64_t seed, const Rates &rates)
{
    MB_TRY(const auto rate, rateOf(asked, rates));
    return std::make_unique<Bus>(clock, rate, seed);
}

} // namespace

Result<std::unique_ptr<SimulatedBus>> makeSimulatedBus(LinkKind kind, Clock &clock, int bitrate, std::uint64_t seed)
{
    switch (kind) {
    case LinkKind::Can: return make<SimulatedCan>(clock, bitrate, seed, {1'000'000, 1250, 1'000'000});
    case LinkKind::Serial:
        return make<SimulatedLine>(clock, bitrate, seed, {115'200, SerialLink::slowest, SerialLink::fastest});
    case LinkKind::Spi: return make<SimulatedSpi>(clock, bitrate, seed, {500'000, 10'000, 10'000'000});
    }
    return fail(Fault::Unsupported, say("this build simulates no devices on sim:%1", toString(kind)));
}

} // namespace mb
