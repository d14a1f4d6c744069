// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/simulatedbus.h"

#include "transport/backends/virtualcan.h"
#include "transport/backends/virtualserial.h"

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

struct Rates {
    int usual;
    int lowest;
    int highest;
};

Result<int> rateOf(int asked, const Rates &rates)
{
    const int rate = asked == 0 ? rates.usual : asked;
    if (rate < rates.lowest || rate > rates.highest)
        return fail(Fault::OutOfRange, "link option bitrate=" + std::to_string(asked) + " is out of range");
    return rate;
}

template <class Bus>
Result<std::unique_ptr<SimulatedBus>> make(Clock &clock, int asked, std::uint64_t seed, const Rates &rates)
{
    const auto rate = rateOf(asked, rates);
    if (!rate)
        return fail(rate.error());
    return std::make_unique<Bus>(clock, *rate, seed);
}

} // namespace

Result<std::unique_ptr<SimulatedBus>> makeSimulatedBus(LinkKind kind, Clock &clock, int bitrate, std::uint64_t seed)
{
    switch (kind) {
    case LinkKind::Can: return make<SimulatedCan>(clock, bitrate, seed, {1'000'000, 1250, 1'000'000});
    case LinkKind::Serial:
        return make<SimulatedLine>(clock, bitrate, seed, {115'200, SerialLink::slowest, SerialLink::fastest});
    case LinkKind::Spi: break;
    }
    return fail(Fault::Unsupported, "this build simulates no devices on sim:" + std::string(toString(kind)));
}

} // namespace mb
