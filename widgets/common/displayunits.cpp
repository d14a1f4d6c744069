// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/displayunits.h"

#include "widgets/common/tabletext.h"

#include <QCoreApplication>

namespace mb {
namespace {

struct UnitText {
    Q_DECLARE_TR_FUNCTIONS(UnitText)
};

constexpr double secondsPerMinute = 60.0;
constexpr double degreesPerRevolution = 360.0;

} // namespace

ShownUnit shownUnit(Quantity quantity, std::string_view unit, const DisplayUnits &units)
{
    if (units.revolutions && quantity == Quantity::Velocity && unit == "counts/s")
        return {secondsPerMinute / units.countsPerRevolution, UnitText::tr("rpm"), 1};
    if (units.revolutions && quantity == Quantity::Position && unit == "counts")
        return {degreesPerRevolution / units.countsPerRevolution, UnitText::tr("°"), 1};
    const UnitForm form = unitForm(quantity, unit);
    return {form.scale, tableText(form.text), form.decimals};
}

ShownUnit shownUnit(const Channel &row, const DisplayUnits &units)
{
    return shownUnit(row.quantity, row.unit, units);
}

ShownUnit shownUnit(Mode mode, const DisplayUnits &units)
{
    if (mode == Mode::Duty)
        return shownUnit(Quantity::Duty, "fraction", units);
    if (mode == Mode::Follow)
        return {1.0, {}, 0};
    return shownUnit(quantityOf(mode), unitOf(mode), units);
}

Quantity quantityOf(Mode mode)
{
    switch (mode) {
    case Mode::Duty: return Quantity::Duty;
    case Mode::Velocity:
    case Mode::RampVelocity: return Quantity::Velocity;
    case Mode::Position:
    case Mode::RampPosition: return Quantity::Position;
    case Mode::Current: return Quantity::Current;
    case Mode::Voltage: return Quantity::Voltage;
    case Mode::Off:
    case Mode::Follow: break;
    }
    return Quantity::Other;
}

TraceRole roleOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Position: return TraceRole::Position;
    case Quantity::Velocity: return TraceRole::Velocity;
    case Quantity::Current: return TraceRole::Current;
    case Quantity::Duty: return TraceRole::Duty;
    case Quantity::SetPoint: return TraceRole::Setpoint;
    case Quantity::Error: return TraceRole::Error;
    case Quantity::Temperature: return TraceRole::Temperature;
    case Quantity::Voltage:
    case Quantity::Other: break;
    }
    return TraceRole::Neutral;
}

int mostDecimals(Quantity quantity, const ShownUnit &unit)
{
    constexpr int whatever = 6; // of what is measured here nothing is known
    switch (quantity) {
    case Quantity::Position:
    case Quantity::Velocity:
    case Quantity::Duty:
    case Quantity::Current:
    case Quantity::Voltage: return unit.decimals;
    default: return whatever;
    }
}

} // namespace mb
