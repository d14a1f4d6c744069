// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/serviceview.h"
#include "widgets/service/verdictview.h"

#include <set>
#include <string>
#include <tuple>

namespace mb {

/// Rows whose verdict somebody has seen, each with its visit and how often it had been begun by then: what comes of the next time, or in
/// another queue, is seen again.
using SetAside = std::set<std::tuple<std::uint32_t, std::string, int>>;

/// What the bench shows large: the unit that is being served, else the one that ended last or was cut off, else that it is ready.
/// `page`: whose keys are named; `hasRecipe`: what another page began cannot be begun here again without one.
[[nodiscard]] Verdict verdictOf(const ServiceView &view, const SetAside &setAside, const QWidget &page, bool hasRecipe);
/// The row that ended last, or was cut off since, and nobody has set aside; nullptr without one, and while another unit is being served.
[[nodiscard]] const service::QueueRow *lastEnded(const ServiceView &view, const SetAside &setAside);
/// Adds every row that has ended, or was cut off.
void setAllAside(const ServiceView &view, SetAside &setAside);
/// It has all but its self-test, which waits until the station is armed.
[[nodiscard]] bool isWaitingForArm(const ServiceView &view, const service::QueueRow &row);
/// Power may be cut now: nothing is written that must be whole, and no self-test turns its motor or waits to.
[[nodiscard]] bool mayUnplug(const service::QueueRow &row);
/// "passed", "failed", "refused", … of a row.
[[nodiscard]] QString wordOf(const service::QueueRow &row);
/// What stands beside that word: "1.23 → 1.25", or why not.
[[nodiscard]] QString lineOf(const service::QueueRow &row);
/// Serial number, or where it stands.
[[nodiscard]] QString nameOf(const service::QueueRow &row);
/// Mean seconds of the units that passed; nothing without one. One that had everything already is no work, here and below.
[[nodiscard]] std::optional<double> meanSeconds(const ServiceView &view);
/// From the first that began to the last that ended; nothing before the second has ended.
[[nodiscard]] std::optional<double> unitsAnHour(const ServiceView &view);
/// "velocity 0 → 1500 counts/s, at most 0.3 duty, 2000 counts/s, 500 counts": what a self-test makes a motor do.
[[nodiscard]] QString motionOf(const service::SelfTest &test);

} // namespace mb
