// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/protocol.h"
#include "families/abstractdc/whereabouts.h"
#include "model/deviceprofile.h"
#include "model/parameterstore.h"
#include "model/setpoint.h"

#include "async/clock.h"

#include <optional>
#include <span>

namespace mb::abstractdc {

namespace calibration {
constexpr std::string_view amperes = "amperes_per_count";
constexpr std::string_view degrees = "degrees_per_count";
} // namespace calibration

constexpr double usualRamp = 4.0; ///< of the duty, where no other is given: duty per second

/// What the wire is to say in the end.
struct Command {
    Loop loop = Loop::None;
    std::int32_t target = 0;
};
/// Unsupported: the drive has no such mode or option; OutOfRange with the legal range.
[[nodiscard]] Result<Command> commandOf(const SetPoint &setPoint, const DeviceProfile &profile);
[[nodiscard]] Mode modeOf(Loop loop);

/// P, D and divisor of the loop were written, by us or by somebody we heard.
[[nodiscard]] bool knowsGains(const ParameterStore &known, Loop loop);
/// The greatest error with which what P and D make of it stays where the drive's 16 bits do not wrap (README.md#wraps), from what was last
/// written and the changes after it, whether or not the last of them came; `unknown` where nobody knows that (LeadProbe). 0: none does. `hasPassed`: the loop's
/// first pass, which may be short, is over.
[[nodiscard]] double greatestError(const ParameterStore &known, Loop loop, bool hasPassed, double unknown,
    std::span<const ParameterChange> changes = {});
/// Unsafe where the loop, so far from its target, would wrap with the last of the changes, the others having come; a weaker one never
/// would. `unknown` as in greatestError().
[[nodiscard]] Result<void> mayChange(
    const ParameterStore &known, std::span<const ParameterChange> changes, double error, double unknown);

/// There is a target from which neither the speed of now nor the one that the first pass measures is too far (README.md#first-pass); else
/// Unsafe. `unknown` as in greatestError().
[[nodiscard]] Result<void> mayEnterVelocity(
    const Whereabouts::SpeedRange &entry, const ParameterStore &known, double unknown);

/// Leads the target from where the motor is to where it shall be: duty by usualRamp, or as the
/// set-point's ramp says; loops never further ahead of the feedback than is safe.
class TargetLead {
public:
    void reset() { m_value.reset(); }
    /// `feedback` in the unit of the target; nothing when it is not known: then the lead is from the last target, of a current from 0,
    /// where its error is greatest.
    [[nodiscard]] std::int32_t next(
        const Command &command, double ramp, std::optional<double> feedback, double greatestError, Instant now);

private:
    std::optional<double> m_value;
    Loop m_loop = Loop::None;
    Instant m_at{};
};

} // namespace mb::abstractdc
