// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulatoroptions.h"

#include "wire/number.h"

#include <algorithm>
#include <cmath>

namespace mb::abstractdc::simulation {
namespace {

template <class T> bool parseNumber(std::string_view text, T low, T high, T &out)
{
    T value{};
    if (!takeNumber(text, value) || !(value >= low && value <= high))
        return false;
    out = value;
    return true;
}

bool setOption(UnitOptions &options, std::string_view key, std::string_view value)
{
    if (key == "dialect") {
        options.dialect = dialectByKey(value);
        return options.dialect != nullptr;
    }
    if (key == "motor") {
        options.motor = motorByName(value);
        return options.motor != nullptr;
    }
    if (key == "load")
        return parseNumber(value, 1.0, 1000.0, options.load);
    if (key == "glitches")
        return parseNumber(value, 1, 1'000'000, options.glitches);
    if (key == "gains") {
        options.gains = value == "default" ? StoredGains::Default
            : value == "overshoot"         ? StoredGains::Overshoot
                                           : StoredGains::Tuned;
        return value == "default" || value == "overshoot" || value == "tuned";
    }
    return true; // serial
}

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
    options.seed = unit.seed;
    options.faults = unit.faults;
    constexpr std::array<std::string_view, 6> known{"dialect", "motor", "load", "glitches", "gains", "serial"};
    for (const auto &[key, value] : unit.options) {
        if (std::find(known.begin(), known.end(), key) == known.end())
            return fail(Fault::OutOfRange, say("a simulated Abstract DC Drive has no option '%1'", key));
        if (!setOption(options, key, value))
            return fail(Fault::OutOfRange,
                say("'%1' is no value for the option '%2' of a simulated Abstract DC Drive", value, key));
    }
    return options;
}

const SimulatedFault *UnitOptions::find(std::string_view fault) const
{
    const auto found
        = std::find_if(faults.begin(), faults.end(), [&](const SimulatedFault &f) { return f.kind == fault; });
    return found == faults.end() ? nullptr : &*found;
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
    const double natural = 0.25 / delay;
    const double positionP = harder * lag * natural * natural / speed * 1.2;
    const double positionD = std::max(0.0, (2.0 * natural * lag - 1.0) / speed);
    const double perPwm = motor.stallCurrent * countsPerAmpere / fullPwm;
    const double currentI = 0.25 / (perPwm * 0.02);
    const auto scale = static_cast<std::int32_t>(divisor);
    return {Record{raw(velocityP * divisor), raw(velocityI * divisor / 1000.0), 0, scale, 1},
        Record{0, raw(currentI * divisor / 1000.0), 0, scale, 1},
        Record{raw(positionP * divisor), 0, raw(-1000.0 * positionD * divisor), scale, 1}};
}

} // namespace mb::abstractdc::simulation
