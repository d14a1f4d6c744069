// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"

#include "families/quadquad2drv/calibrations.h"
#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/controller.h"
#include "families/quadquad2drv/decode.h"
#include "families/quadquad2drv/experiments.h"
#include "families/quadquad2drv/firmware.h"
#include "families/quadquad2drv/parameters.h"
#include "families/quadquad2drv/scan.h"
#include "families/quadquad2drv/simulator.h"
#include "families/quadquad2drv/states.h"

#include <QtGlobal>

#include <array>

namespace mb::quadquad2drv {
namespace {

constexpr std::array links{LinkKind::Spi};
constexpr std::array modes{Mode::Duty, Mode::Position, Mode::Velocity, Mode::RampPosition, Mode::RampVelocity};
constexpr std::array<std::string_view, 1> bench{"quadquad2drv:0"};

constexpr Capabilities capabilities{
    .readback = true,
    .watchdog = false,
    .versionOnWire = true,
    .identify = false,
    .rename = false,
    .renumber = false,
    .restart = true,
    .keepsSettings = false,
    .lastAddress = 0,
    .commandsProfile = true,
    .firstPower = 0.25, // SettingRequests::firstPowerLimit
    .fastestProfile = fastest,
    .steepestProfile = steepest,
    .axes = axes,
    .gainSlots = 1,
    .commandPeriod = std::chrono::milliseconds(50),
    .bootloaderElsewhere = true,
};

constexpr std::array<FaultRow, 2> faultRows{{
    {"glitch", QT_TRANSLATE_NOOP("table", "encoder glitch")},
    {"overspeed", QT_TRANSLATE_NOOP("table", "overspeed")},
}};

/// One stream for all axes: the rate of any channel is that of all.
constexpr std::array<ChannelRate, 1> watched{{{"ch1.position", 500.0}}};

constexpr LoopScale controlLoop{
    .fullDuty = fullPower,
    .period = 2e-3,
    .cycle = 2e-3,
    .velocityTime = 1.0,
    .velocityEdges = "history.length",
    .velocityError = QT_TRANSLATE_NOOP("table", "count/s"),
    .currentError = {},
    .time = QT_TRANSLATE_NOOP("table", "loop"),
    .calibrated = true,
};

constexpr std::array<std::string_view, 4> positionGains{"p", "i", "d", "windup"};
constexpr std::array<std::string_view, 3> velocityGains{"p", "i", "d"};
constexpr std::array<LoopGains, 2> triedLoops{{
    {Mode::Velocity, "velocity.", velocityGains},
    {Mode::Position, "position.", positionGains},
}};
constexpr std::array<DeviceLimit, 2> deviceLimits{{
    {DeviceLimit::Bounds::Duty, "limit.power", "", 1.0},
    {DeviceLimit::Bounds::Speed, "limit.velocity", "", 1.0},
}};
constexpr TrialTraits trials{
    .loops = triedLoops,
    .limits = deviceLimits,
    .bench = {.travel = 1e6, .speed = 1e5, .current = 10.0, .duty = 1.0},
    .rate = 100.0,
    .glideBeat = capabilities.commandPeriod,
};

} // namespace

extern const Family family;
const Family family{
    .key = "quadquad2drv",
    .title = "QuadQuad2Drv",
    .links = links,
    .parameters = parameterTable(),
    .channels = channelTable(),
    .modes = modes,
    .capabilities = capabilities,
    .bench = bench,
    .calibrations = calibration::table(),
    .experiments = experiments(),
    .routes = routes(),
    .states = stateTable(),
    .faults = faultRows,
    .watched = watched,
    .loop = &controlLoop,
    .trials = &trials,
    .scan = scan,
    .open = open,
    .decodeBytes = decodeBytes,
    .update = update,
    .inspect = inspect,
    .simulate = simulate,
};

} // namespace mb::quadquad2drv
