// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/session.h"
#include "service/recipematter.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Orders to the service of many units. Where nothing is served they do nothing; none but these two has an error.
namespace mb::orders {

/// Serves the units of these links, which nobody else uses meanwhile. Answered when it has begun; how it goes is in
/// Workbench::service(). Unsafe while another queue runs, Timeout when a link is not open, or busy.
struct ServeUnits {
    std::shared_ptr<const service::RecipeMatter> matter;
    std::vector<std::string> links; ///< addresses; they are open
    std::optional<int> units{};     ///< as QueueOptions::units
    /// Nothing: every unit of the family. Else these only, and those that the run has cut off; the others are left out.
    std::optional<std::vector<DeviceId>> chosen{};
    std::string run{}; ///< as QueueOptions::run
};

/// After this unit; or goes on.
struct PauseService {
    bool on = false;
};

struct SkipUnit {
    std::uint32_t row = 0;
};

/// One that failed, was refused or was left out, once more.
struct RetryUnit {
    std::uint32_t row = 0;
};

/// All that failed.
struct RetryFailedUnits { };

/// No more units; ends when those that run have ended.
struct FinishService { };

/// No more units; those that run end as soon as nothing must not be cut, and stay open in the journal.
struct CancelService { };

/// Self-tests may turn the motors of this recipe on these links, until it is stopped, fails, is left, has no unit for five minutes, or
/// this takes it back.
struct ArmService {
    bool on = false;
};

/// The window is alive: ten times a second, while a motor may turn.
struct RenewService { };

/// From now on the journal is kept under the name of `station`, and shared on `server` (`postgresql://USER@HOST/DB`; empty: not shared).
/// Empty `station`: the computer's name. Usage for another address; Unsafe while units are served.
struct KeepJournal {
    std::string server;
    std::string station;
};

} // namespace mb::orders
