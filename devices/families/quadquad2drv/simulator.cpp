// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulator.h"

#include "families/quadquad2drv/simulatorboot.h"
#include "wire/number.h"

#include <algorithm>

namespace mb::quadquad2drv {
namespace simulation {
namespace {

bool setVersion(BoardOptions &options, std::string_view text)
{
    const auto dot = text.find('.');
    return dot != std::string_view::npos && takeNumber(text.substr(0, dot), options.version[0])
        && takeNumber(text.substr(dot + 1), options.version[1]);
}

bool setOption(BoardOptions &options, std::string_view key, std::string_view value)
{
    if (key == "motor") {
        options.motors.fill(std::string(value));
        return motorByName(value) != nullptr;
    }
    if (key == "load") {
        double load = 0.0;
        const bool good = takeNumber(value, load) && load >= 1.0 && load <= 1000.0;
        options.loads.fill(load);
        return good;
    }
    if (key == "boot") {
        auto address = LinkAddress::parse(value);
        if (address)
            options.boot = *address;
        return address.has_value();
    }
    if (key == "state") {
        options.inBootloader = value == "bootloader";
        return options.inBootloader || value == "application";
    }
    if (key == "jumper") {
        options.jumper = value == "closed";
        return options.jumper || value == "open";
    }
    if (key == "scale")
        return takeNumber(value, options.gainScale) && options.gainScale >= 1e-3 && options.gainScale <= 1e3;
    if (key == "inputs") {
        options.libraryPolarity = value == "library";
        return options.libraryPolarity || value == "datasheet";
    }
    if (key == "target") {
        options.shiftedTarget = value == "shifted";
        return options.shiftedTarget || value == "plain";
    }
    return key == "serial" || (key == "firmware" && setVersion(options, value));
}

} // namespace

Result<BoardOptions> BoardOptions::parse(const SimulatedUnit &unit)
{
    if (unit.address != 0)
        return fail(Fault::OutOfRange, say("a QuadQuad2Drv has no address but 0"));
    BoardOptions options;
    options.motors = {"25d", "n20", "25dlp", "25d"};
    options.seed = unit.seed;
    options.faults = unit.faults;
    // the timed ones in order, so that one index serves
    std::stable_sort(options.faults.begin(), options.faults.end(),
        [](const SimulatedFault &a, const SimulatedFault &b) { return a.at < b.at; });
    for (const auto &[key, value] : unit.options) {
        constexpr std::array<std::string_view, 10> known{
            "motor", "load", "firmware", "serial", "boot", "state", "jumper", "scale", "inputs", "target"};
        if (std::find(known.begin(), known.end(), key) == known.end())
            return fail(Fault::OutOfRange, say("a simulated QuadQuad2Drv has no option '%1'", key));
        if (!setOption(options, key, value))
            return fail(
                Fault::OutOfRange, say("'%1' is no value for the option '%2' of a simulated QuadQuad2Drv", value, key));
    }
    if ((options.jumper || options.inBootloader) && !options.boot)
        return fail(Fault::OutOfRange, say("a bootloader needs the board's serial line, such as boot=pty:./boot"));
    return options;
}

} // namespace simulation

namespace {

class SimulatedQuadQuad final : public Simulator {
public:
    SimulatedQuadQuad(SpiSlaveLink &link, Clock &clock, const simulation::BoardOptions &options)
        : m_board(link, clock, options,
            [this, &clock](std::string_view what, double value) { emitEvent(clock.now(), std::string(what), value); })
    {
    }
    Result<void> openBoot(Clock &clock, const simulation::BoardOptions &options)
    {
        if (!options.boot)
            return {};
        auto boot = simulation::Boot::open(*options.boot, clock, m_board, options);
        if (!boot)
            return fail(boot.error());
        m_boot = std::move(*boot);
        return {};
    }

    [[nodiscard]] std::string name() const override { return "quadquad2drv:0"; }
    [[nodiscard]] bool isOutputOn() const override
    {
        bool on = false;
        for (int i = 0; i < axes; ++i)
            on = on || m_board.axis(i).output() != 0.0;
        return on;
    }
    [[nodiscard]] double speed() const override { return m_board.axis(0).motor().countSpeed(); }
    [[nodiscard]] double position() const override { return m_board.axis(0).motor().countPosition(); }
    void setPowered(bool powered) override { m_board.setPowered(powered); }
    bool disturb(std::string_view what, double value) override
    {
        if (what.size() == 6 && what.starts_with("input") && what[5] >= '1' && what[5] <= '4') {
            m_board.axis(what[5] - '1').setInputLevel(value != 0.0);
            return true;
        }
        if (what == "reset") {
            m_board.reset();
            return true;
        }
        if (what == "jumper" && m_boot) {
            m_boot->setJumper(value != 0.0);
            return true;
        }
        bool known = true;
        for (int i = 0; i < axes; ++i)
            known = m_board.axis(i).motor().disturb(what, value) && known;
        return known;
    }

private:
    simulation::Board m_board;
    std::unique_ptr<simulation::Boot> m_boot;
};

} // namespace

Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit)
{
    auto *slave = dynamic_cast<SpiSlaveLink *>(&link);
    if (!slave)
        return fail(Fault::OutOfRange, say("a QuadQuad2Drv is simulated on the board's end of an SPI link"));
    const auto options = simulation::BoardOptions::parse(unit);
    if (!options)
        return fail(options.error());
    auto simulated = std::make_unique<SimulatedQuadQuad>(*slave, clock, *options);
    if (auto opened = simulated->openBoot(clock, *options); !opened)
        return fail(opened.error());
    return simulated;
}

} // namespace mb::quadquad2drv
