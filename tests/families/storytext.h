// SPDX-License-Identifier: GPL-3.0-or-later
// What stories show, as text: numbers with six digits, so that they are the same on every machine.
#pragma once

#include "model/device.h"
#include "model/family.h"
#include "model/parametertransfer.h"
#include "model/setpointstream.h"

#include <span>
#include <string>
#include <vector>

namespace mb::test {

[[nodiscard]] std::string numberOf(double value);
/// Seconds with microseconds.
[[nodiscard]] std::string secondsOf(Duration time);
[[nodiscard]] std::string textOf(const Identity &identity);
[[nodiscard]] std::string textOf(const Liveness &liveness);
/// Keys of the rows that are on, and of those that are known to be off behind a minus.
[[nodiscard]] std::string textOf(std::span<const StateRow> table, const LiveStates &states);
/// Without fields that are 0.
[[nodiscard]] std::string textOf(const DecodedFrame &frame);
[[nodiscard]] std::string textOf(const SetPoint &setPoint);
[[nodiscard]] std::string textOf(const SetPointStream &stream);
[[nodiscard]] std::string_view textOf(StopState state);
[[nodiscard]] std::string textOf(const DeviceProfile &profile);
[[nodiscard]] std::string_view textOf(PartState state);
[[nodiscard]] std::string severityText(Severity severity);

/// @name Results
/// @{
[[nodiscard]] std::string valueText(bool value);
[[nodiscard]] std::string valueText(std::int64_t value);
[[nodiscard]] std::string valueText(int value);
[[nodiscard]] std::string valueText(const std::vector<FaultRecord> &faults);
[[nodiscard]] std::string valueText(const std::vector<TransferOutcome> &outcomes);
[[nodiscard]] std::string valueText(const UpdateReport &report);
[[nodiscard]] std::string valueText(const ExperimentReport &report);
[[nodiscard]] std::string errorText(const Error &error);
template <class T> [[nodiscard]] std::string resultText(const Result<T> &result)
{
    if (!result)
        return errorText(result.error());
    if constexpr (std::is_void_v<T>)
        return "done";
    else
        return valueText(*result);
}
/// @}

} // namespace mb::test
