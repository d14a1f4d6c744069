// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulator.h"

#include "families/quadquad2drv/simulatorboot.h"
#include "simulation/simulatoroptions.h"

#include <algorithm>
#include <array>

namespace mb::quadquad2drv {
namespace simulation {
namespace {

bool setVersion(BoardOptions &options, std::string_view text)
{
    const auto dot = text.find('.');
    return dot != std::string_view::npos && takeNumber(text.substr(0, dot), options.version[0])
        && takeNumber(text.substr(dot + 1), options.version[1]);
}

using Option = SimulatorOption<BoardOptions>;

constexpr std::array<std::pair<std::string_view, bool>, 2> states{{{"application", false}, {"bootloader", true}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> jumpers{{{"open", false}, {"closed", true}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> polarities{{{"datasheet", false}, {"library", true}}};
constexpr std::array<std::pair<std::string_view, bool>, 2> targets{{{"plain", false}, {"shifted", true}}};

bool setBoot(BoardOptions &options, std::string_view text)
{
    auto address = LinkAddress::parse(text);
    if (address)
        options.boot = *address;
    return address.has_value();
}

constexpr std::array optionTable{
    Option{"motor",
        [](BoardOptions &o, std::string_view text) {
            o.motors.fill(std::string(text));
            return motorByName(text) != nullptr;
        }},
    Option{"load",
        [](BoardOptions &o, std::string_view text) {
            double load = 0.0;
            const bool good = takeLoad(text, load);
            o.loads.fill(load);
            return good;
        }},
    Option{"firmware", setVersion},
    Option{"serial", [](BoardOptions &, std::string_view) { return true; }},
    Option{"boot", setBoot},
    Option{"state", [](BoardOptions &o, std::string_view text) { return takeWord(text, states, o.inBootloader); }},
    Option{"jumper", [](BoardOptions &o, std::string_view text) { return takeWord(text, jumpers, o.jumper); }},
    Option{"scale", [](BoardOptions &o, std::string_view text) { return takeWithin(text, 1e-3, 1e3, o.gainScale); }},
    Option{
        "inputs", [](BoardOptions &o, std::string_view text) { return takeWord(text, polarities, o.libraryPolarity); }},
    Option{"target", [](BoardOptions &o, std::string_view text) { return takeWord(text, targets, o.shiftedTarget); }},
};

} // namespace

Result<BoardOptions> BoardOptions::parse(const SimulatedUnit &unit)
{
    if (unit.address != 0)
        return fail(Fault::OutOfRange, say("a QuadQuad2Drv has no address but 0"));
    BoardOptions options;
    options.motors = {"25d", "n20", "25dlp", "25d"};
    MB_TRY_VOID(takeOptions(unit, say("a simulated QuadQuad2Drv"), optionTable, {FaultKind::PowerPage}, options));
    if ((options.inBootloader || unit.option("jumper")) && !options.boot)
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
        MB_TRY(auto boot, simulation::Boot::open(*options.boot, clock, m_board, options));
        m_boot = std::move(boot);
        m_otherLinks = {options.boot->text()};
        return {};
    }

    [[nodiscard]] std::string name() const override { return "quadquad2drv:0"; }
    [[nodiscard]] std::vector<std::string> otherLinks() const override { return m_otherLinks; }
    [[nodiscard]] bool isOutputOn() const override
    {
        bool on = false;
        for (int i = 0; i < axes; ++i)
            on = on || m_board.axis(i).output() != 0.0;
        return on;
    }
    [[nodiscard]] double speed() const override { return m_board.axis(0).motor().countSpeed(); }
    [[nodiscard]] double position() const override { return m_board.axis(0).motor().countPosition(); }
    [[nodiscard]] std::optional<std::int64_t> gain(std::string_view key) const override
    {
        static constexpr std::array<std::string_view, 4> names{"p", "i", "d", "windup"};
        if (!key.starts_with("ch") || key.size() < 4 || key[2] < '1' || key[2] > '4')
            return std::nullopt;
        const simulation::AxisSettings &settings = m_board.axis(key[2] - '1').settings;
        const bool isPosition = key.substr(4).starts_with("position.");
        const auto name = std::ranges::find(names, key.substr(key.rfind('.') + 1));
        const auto place = static_cast<std::size_t>(name - names.begin());
        if (isPosition && place < settings.positionGains.size())
            return settings.positionGains.at(place);
        if (key.substr(4).starts_with("velocity.") && place < settings.velocityGains.size())
            return settings.velocityGains.at(place);
        return std::nullopt;
    }
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
    std::vector<std::string> m_otherLinks;
};

} // namespace

Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit)
{
    auto *slave = dynamic_cast<SpiSlaveLink *>(&link);
    if (!slave)
        return fail(Fault::OutOfRange, say("a QuadQuad2Drv is simulated on the board's end of an SPI link"));
    MB_TRY(const auto options, simulation::BoardOptions::parse(unit));
    if (!options.boot && findFault(options.faults, FaultKind::PowerPage))
        return fail(Fault::Unsupported, say("a bootloader needs the board's serial line, such as boot=pty:./boot"));
    auto simulated = std::make_unique<SimulatedQuadQuad>(*slave, clock, options);
    MB_TRY_VOID(simulated->openBoot(clock, options));
    return simulated;
}

} // namespace mb::quadquad2drv
