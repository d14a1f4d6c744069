// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/parameters.h"

#include "families/quadquad2drv/literal.h"
#include "families/quadquad2drv/protocol.h"

#include <QtGlobal>

#include <algorithm>
#include <array>

namespace mb::quadquad2drv {
namespace {

template <int Axis, Literal Suffix>
constexpr auto keyText = [] {
    std::array<char, 4 + sizeof(Suffix.data) - 1> text{'c', 'h', static_cast<char>('1' + Axis), '.'};
    std::copy_n(Suffix.data, sizeof(Suffix.data) - 1, text.data() + 4);
    return text;
}();

template <int Axis, Literal Suffix> constexpr std::string_view key()
{
    return {keyText<Axis, Suffix>.data(), keyText<Axis, Suffix>.size()};
}

constexpr std::array<std::string_view, 4> channelGroups{
    QT_TRANSLATE_NOOP("table", "Channel 1"),
    QT_TRANSLATE_NOOP("table", "Channel 2"),
    QT_TRANSLATE_NOOP("table", "Channel 3"),
    QT_TRANSLATE_NOOP("table", "Channel 4"),
};
constexpr std::string_view boardGroup = QT_TRANSLATE_NOOP("table", "Stream and velocity");

constexpr std::array inputModes{
    Choice{0, QT_TRANSLATE_NOOP("table", "disabled")},
    Choice{1, QT_TRANSLATE_NOOP("table", "home switch")},
    Choice{2, QT_TRANSLATE_NOOP("table", "index pulse")},
    Choice{3, QT_TRANSLATE_NOOP("table", "both edges")},
};

constexpr std::array polarities{
    Choice{0, QT_TRANSLATE_NOOP("table", "active high")},
    Choice{1, QT_TRANSLATE_NOOP("table", "active low")},
};
constexpr std::array<Choice, 4> edges{{
    {0, QT_TRANSLATE_NOOP("table", "record at the positive end")},
    {1, QT_TRANSLATE_NOOP("table", "set at the positive end")},
    {2, QT_TRANSLATE_NOOP("table", "record at the negative end")},
    {3, QT_TRANSLATE_NOOP("table", "set at the negative end")},
}};

constexpr std::string_view positionGainHelp = QT_TRANSLATE_NOOP("table",
    "Of the position loop, in the board's own units, whose scale is not documented. Cannot be read back; the four are "
    "sent together.");
constexpr std::string_view windupHelp = QT_TRANSLATE_NOOP(
    "table", "Bound of the position loop's integral, in power units: 8191 is full power. Cannot be read back.");
constexpr std::string_view velocityGainHelp = QT_TRANSLATE_NOOP("table",
    "Of the velocity loop, in the board's own units, whose scale is not documented. Cannot be read back; the three are "
    "sent together.");
constexpr std::string_view powerHelp = QT_TRANSLATE_NOOP("table",
    "Greatest power in every mode, 1 is full. What the board starts with is not documented: begin small. Cannot be "
    "read back.");
constexpr std::string_view velocityHelp = QT_TRANSLATE_NOOP(
    "table", "Greatest speed in both closed loops. What the board starts with is not documented. Cannot be read back.");
constexpr std::string_view accelerationHelp
    = QT_TRANSLATE_NOOP("table", "Greatest acceleration in both closed loops; 0 is no limit. Cannot be read back.");
constexpr std::string_view inputHelp = QT_TRANSLATE_NOOP("table",
    "What the input of the channel is for. Cannot be read back; the five values of an input are sent together.");
constexpr std::string_view polarityHelp = QT_TRANSLATE_NOOP("table",
    "At which level the input is active. Data sheet and the maker's library say it with opposite bits: which one the "
    "board follows is a setting of the device, and an experiment tells.");
constexpr std::string_view edgeHelp = QT_TRANSLATE_NOOP("table",
    "At which end of the switch the position is recorded, or also set as the counter. Data sheet and library disagree, "
    "as for the polarity.");
constexpr std::string_view spacingHelp = QT_TRANSLATE_NOOP(
    "table", "Distance between the two ends of the switch; 0 is a single end stop. Cannot be read back.");
constexpr std::string_view inputPositionHelp
    = QT_TRANSLATE_NOOP("table", "What the counter becomes at the edge. Cannot be read back.");
constexpr std::string_view maskHelp = QT_TRANSLATE_NOOP("table",
    "What the board sends of this channel: bits 0 and 1 size of the position, 2 relative, 3 velocity, 5 status. "
    "The program needs the full position.");
constexpr std::string_view counterHelp
    = QT_TRANSLATE_NOOP("table", "The encoder's counter. Writing it moves the zero, not the motor.");
constexpr std::string_view periodHelp
    = QT_TRANSLATE_NOOP("table", "Of the telemetry, in units of 40.96 µs: 244 is 10 ms, 49 is 2 ms, 0 is off.");
constexpr std::string_view configHelp
    = QT_TRANSLATE_NOOP("table", "What a stream packet has besides: bit 0 timing, bit 1 number of skipped periods.");
constexpr std::string_view historyHelp = QT_TRANSLATE_NOOP(
    "table", "Edges, times four, over which velocity is measured: fewer is faster and coarser. 8 is good for tuning.");
constexpr std::string_view bitsHelp = QT_TRANSLATE_NOOP(
    "table", "Longest time over which velocity is measured: 2 to this power, times 0.64 µs; 20 is 671 ms.");

// Every value is lost with the supply: nothing is persistent (README.md#nothing-kept).
constexpr Parameter row(std::string_view name, std::uint16_t id, WireType type, double one, std::string_view unit,
    double low, double high, double fallback, Access access, std::string_view group, std::string_view label,
    std::string_view help)
{
    return {name, id, type, one, unit, low, high, fallback, access, false, Nature::Setting, group, label, help, {}};
}

constexpr Parameter hidden(std::string_view name, std::uint16_t id, WireType type, double one, std::string_view unit,
    double high, double fallback, std::string_view group, std::string_view label, std::string_view help)
{
    return row(name, id, type, one, unit, 0.0, high, fallback, Access::WriteOnly, group, label, help);
}

template <int Axis> constexpr void fillLoops(std::span<Parameter> out, std::uint16_t id, std::string_view group)
{
    const auto gain
        = [&](Role role, std::string_view name, double fallback, std::string_view label, std::string_view help) {
              const std::size_t at = id % parametersPerAxis;
              out[at] = as(role, hidden(name, id, WireType::Uint16, 1.0, "", 65535.0, fallback, group, label, help));
              ++id;
          };
    gain(Role::Proportional, key<Axis, "position.p">(), 100.0, QT_TRANSLATE_NOOP("table", "Position P"),
        positionGainHelp);
    gain(Role::Integral, key<Axis, "position.i">(), 500.0, QT_TRANSLATE_NOOP("table", "Position I"), positionGainHelp);
    gain(
        Role::Derivative, key<Axis, "position.d">(), 500.0, QT_TRANSLATE_NOOP("table", "Position D"), positionGainHelp);
    out[3] = as(Role::IntegralLimit,
        hidden(key<Axis, "position.windup">(), id++, WireType::Uint16, 1.0, "", fullPower, 600.0, group,
            QT_TRANSLATE_NOOP("table", "Position windup"), windupHelp));
    gain(Role::Proportional, key<Axis, "velocity.p">(), 100.0, QT_TRANSLATE_NOOP("table", "Velocity P"),
        velocityGainHelp);
    gain(Role::Integral, key<Axis, "velocity.i">(), 200.0, QT_TRANSLATE_NOOP("table", "Velocity I"), velocityGainHelp);
    gain(
        Role::Derivative, key<Axis, "velocity.d">(), 500.0, QT_TRANSLATE_NOOP("table", "Velocity D"), velocityGainHelp);
}

template <int Axis> constexpr void fillLimits(std::span<Parameter> out, std::uint16_t id, std::string_view group)
{
    out[7] = hidden(key<Axis, "limit.power">(), id++, WireType::Uint16, fullPower, "fraction", 1.0, 1.0, group,
        QT_TRANSLATE_NOOP("table", "Power limit"), powerHelp);
    out[8] = hidden(key<Axis, "limit.velocity">(), id++, WireType::Uint32, limitOne, "counts/s", fastest, fastest,
        group, QT_TRANSLATE_NOOP("table", "Velocity limit"), velocityHelp);
    out[9] = hidden(key<Axis, "limit.acceleration">(), id++, WireType::Uint32, limitOne, "counts/s²", steepest, 0.0,
        group, QT_TRANSLATE_NOOP("table", "Acceleration limit"), accelerationHelp);
    for (std::size_t limit = 7; limit < 10; ++limit)
        out[limit].role = limit == 7 ? Role::PowerLimit : Role::Limit;
    out[9].zeroIsNone = true;
    out[10] = hidden(key<Axis, "input.mode">(), id++, WireType::Uint8, 1.0, "", 3.0, 0.0, group,
        QT_TRANSLATE_NOOP("table", "Input mode"), inputHelp);
    out[10].choices = inputModes;
    out[11] = hidden(key<Axis, "input.polarity">(), id++, WireType::Uint8, 1.0, "", 1.0, 0.0, group,
        QT_TRANSLATE_NOOP("table", "Input polarity"), polarityHelp);
    out[11].choices = polarities;
    out[12] = hidden(key<Axis, "input.edge">(), id++, WireType::Uint8, 1.0, "", 3.0, 0.0, group,
        QT_TRANSLATE_NOOP("table", "Input edge"), edgeHelp);
    out[12].choices = edges;
    out[13] = hidden(key<Axis, "input.spacing">(), id++, WireType::Uint16, 1.0, "counts", 65535.0, 0.0, group,
        QT_TRANSLATE_NOOP("table", "Input spacing"), spacingHelp);
    out[14] = row(key<Axis, "input.position">(), id++, WireType::Int32, 1.0, "counts", -2147483648.0, 2147483647.0, 0.0,
        Access::WriteOnly, group, QT_TRANSLATE_NOOP("table", "Input position"), inputPositionHelp);
    out[15] = row(key<Axis, "data_mask">(), id++, WireType::Uint8, 1.0, "", 0.0, 0x2F, datamask::startUp,
        Access::ReadWrite, group, QT_TRANSLATE_NOOP("table", "Data mask"), maskHelp);
    out[16] = row(key<Axis, "counter">(), id, WireType::Int32, 1.0, "counts", -2147483648.0, 2147483647.0, 0.0,
        Access::ReadWrite, group, QT_TRANSLATE_NOOP("table", "Position counter"), counterHelp);
    out[16].nature = Nature::Live;
}

constexpr std::size_t rows = 4 * parametersPerAxis + 4;

consteval std::array<Parameter, rows> makeTable()
{
    std::array<Parameter, rows> table{};
    const auto fill = [&table]<int Axis>() {
        const std::span<Parameter> out(table.data() + Axis * parametersPerAxis, parametersPerAxis);
        fillLoops<Axis>(out, Axis * parametersPerAxis, channelGroups[Axis]);
        fillLimits<Axis>(out, Axis * parametersPerAxis + 7, channelGroups[Axis]);
    };
    fill.template operator()<0>();
    fill.template operator()<1>();
    fill.template operator()<2>();
    fill.template operator()<3>();
    const auto board = [](std::string_view name, BoardParameter which, WireType type, double low, double high,
                           double fallback, std::string_view label, std::string_view help) {
        return row(
            name, indexOf(which).value, type, 1.0, "", low, high, fallback, Access::ReadWrite, boardGroup, label, help);
    };
    std::size_t at = 4 * parametersPerAxis;
    table[at++] = board("stream.period", BoardParameter::StreamPeriod, WireType::Uint16, 0.0, 65535.0, 0.0,
        QT_TRANSLATE_NOOP("table", "Stream period"), periodHelp);
    table[at++] = board("stream.config", BoardParameter::StreamConfig, WireType::Uint8, 0.0, 3.0, 0.0,
        QT_TRANSLATE_NOOP("table", "Stream contents"), configHelp);
    table[at++] = board("history.length", BoardParameter::HistoryLength, WireType::Uint8, 2.0, 127.0, 31.0,
        QT_TRANSLATE_NOOP("table", "History length"), historyHelp);
    table[at++] = board("history.time_bits", BoardParameter::HistoryTimeBits, WireType::Uint8, 14.0, 32.0, 20.0,
        QT_TRANSLATE_NOOP("table", "History time bits"), bitsHelp);
    return table;
}

constexpr std::array<Parameter, rows> table = makeTable();

static_assert(checkParameters(table));
static_assert(table[indexOf(3, AxisParameter::Counter).value].key == "ch4.counter");
static_assert(table[indexOf(2, AxisParameter::VelocityD).value].key == "ch3.velocity.d");
static_assert(table[indexOf(BoardParameter::HistoryTimeBits).value].key == "history.time_bits");

} // namespace

std::span<const Parameter> parameterTable()
{
    return table;
}

} // namespace mb::quadquad2drv
