// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"

#include "tinker/codec.h"
#include "tinker/controller.h"
#include "tinker/firmware.h"
#include "tinker/simulator.h"
#include "tinker/tables.h"

#include <QtGlobal>

#include <array>

namespace mb::tinker {
namespace {

constexpr std::array links{LinkKind::Can};
constexpr std::array modes{Mode::Duty, Mode::Position};
constexpr std::array<std::string_view, 2> bench{"tinker:3", "tinker:4,motor=n20"};

constexpr Capabilities capabilities{
    .watchdog = true,
    .freeRates = false,
    .commandLimit = driveLimit,
    .watchdogLimit = 2 * driveLimit,
};
constexpr std::array<ModeRange, 1> ranges{{{Mode::Position, 5000.0}}};
constexpr std::array<ChannelRate, 1> watched{{{"position", 100.0}}};

constexpr std::array<std::string_view, 2> gains{"damping", "stiffness"};
constexpr std::array<LoopGains, 1> loops{{{Mode::Position, "loop.", gains}}};
constexpr std::array<DeviceLimit, 1> limits{{{DeviceLimit::Bounds::Duty, "limit.duty", "", 1.0}}};
constexpr TrialTraits trials{
    .loops = loops,
    .limits = limits,
    .bench = {.travel = 1e6, .speed = 1e5, .current = 10.0, .duty = 1.0},
};

/// It stores when it is told to, and has no limit of its current: nothing of either is told in its stories.
constexpr std::array<DemoMotor, 1> demoMotors{{
    {4, QT_TRANSLATE_NOOP("table", "Tinkered motor"), QT_TRANSLATE_NOOP("table", "tinkered gear")},
}};
constexpr DemoUnits demo{.tuned = 3, .overshooting = 4, .motors = demoMotors};

} // namespace

extern const Family family;
const Family family{
    .key = "tinker",
    .title = "Tinker One",
    .links = links,
    .parameters = parameterTable(),
    .channels = channelTable(),
    .modes = modes,
    .capabilities = capabilities,
    .bench = bench,
    .routes = routes(),
    .states = stateTable(),
    .faults = faultTable(),
    .ranges = ranges,
    .watched = watched,
    .demo = &demo,
    .trials = &trials,
    .scan = scan,
    .open = open,
    .decodeCan = decode,
    .update = update,
    .inspect = inspect,
    .simulate = simulate,
};

} // namespace mb::tinker
