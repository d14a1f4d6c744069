// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulatoroptions.h"

#include "simulation/faultplan.h"
#include "simulation/simulatoroptions.h"

#include <algorithm>
#include <cmath>

namespace mb::abstractdc::simulation {
namespace {

using Option = SimulatorOption<UnitOptions>;

constexpr std::array<std::pair<std::string_view, StoredGains>, 3> gainWords{
    {{"default", StoredGains::Default}, {"tuned", StoredGains::Tuned}, {"overshoot", StoredGains::Overshoot}}};

constexpr std::array optionTable{
    Option{"dialect",
        [](UnitOptions &o, std::string_view text) {
            o.dialect = dialectByKey(text);
            return o.dialect != nullptr;
        }},
    Option{"motor",
        [](UnitOptions &o, std::string_view text) {
            o.motor = motorByName(text);
            return o.motor != nullptr;
        }},
    Option{"load", [](UnitOptions &o, std::string_view text) { return takeLoad(text, o.load); }},
    Option{
        "glitches", [](UnitOptions &o, std::string_view text) { return takeWithin(text, 1, 1'000'000, o.glitches); }},
    Option{"gains", [](UnitOptions &o, std::string_view text) { return takeWord(text, gainWords, o.gains); }},
    Option{"serial", [](UnitOptions &, std::string_view) { return true; }},
};

std::int32_t raw(double gain)
{
    return static_cast<std::int32_t>(std::lround(std::clamp(gain, -2147483648.0, 2147483647.0)));
}

} // namespace

Result<UnitOptions> UnitOptions::parse(const SimulatedUnit &unit)
{
    if (unit.address < 0 || unit.address > maxOffset)
        return fail(Fault::OutOfRange, say("an Abstract DC Drive has an offset from 0 to 99, not %1", unit.address));
    UnitOptions options;
    options.offset = unit.address;
    options.motor = motorByName("25d");
    if (auto taken = takeOptions(unit, say("a simulated Abstract DC Drive"), optionTable,
            {FaultKind::BusOff, FaultKind::Duplicate}, options);
        !taken)
        return fail(taken.error());
    return options;
}

const SimulatedFault *UnitOptions::find(FaultKind fault) const
{
    return findFault(faults, fault);
}

std::array<Record, 3> storedGains(const UnitOptions &options)
{
    if (options.gains == StoredGains::Default)
        return {};
    const MotorParameters &motor = *options.motor;
    constexpr double pi = 3.14159265358979;
    constexpr double divisor = 1e6;
    constexpr double delay = 0.035; // half of the averaging, one loop, half a hold
    const double speed = motor.rotorFreeSpeed() * motor.countsPerTurn / (2.0 * pi) / fullPwm; // counts/s per PWM
    const double lag = motor.inertia * options.load * motor.resistance / (motor.constant * motor.constant);
    const double harder = options.gains == StoredGains::Overshoot ? 2.2 : 1.0;
    const double closed = 2.0 * delay;
    const double velocityP = harder * lag / (speed * (closed + delay));
    const double velocityI = harder * velocityP / std::min(lag, 4.0 * (closed + delay));
    // Friction holds the motor where P times the error is below it; a heavy load would be at full power all the way.
    const double natural = 0.54 / delay * std::sqrt(std::min(1.0, 0.125 / lag));
    const double damping = 0.9;
    const double positionP = harder * lag * natural * natural / speed;
    const double positionD = std::max(0.0, (2.0 * damping * natural * lag - 1.0) / speed);
    const double perPwm = motor.stallCurrent * countsPerAmpere / fullPwm;
    const double currentI = 0.25 / (perPwm * 0.02);
    const auto scale = static_cast<std::int32_t>(divisor);
    return {Record{raw(velocityP * divisor), raw(velocityI * divisor / 1000.0), 0, scale, 1},
        Record{0, raw(currentI * divisor / 1000.0), 0, scale, 1},
        Record{raw(positionP * divisor), 0, raw(-1000.0 * positionD * divisor), scale, 1}};
}

} // namespace mb::abstractdc::simulation
