// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"

#include "families/dmc60c/channels.h"
#include "families/dmc60c/controller.h"
#include "families/dmc60c/decode.h"
#include "families/dmc60c/firmware.h"
#include "families/dmc60c/flashproof.h"
#include "families/dmc60c/parameters.h"
#include "families/dmc60c/protocol.h"
#include "families/dmc60c/scan.h"
#include "families/dmc60c/simulator.h"
#include "families/dmc60c/states.h"
#include "families/dmc60c/unitidentity.h"

#include <QtGlobal>

#include <array>

namespace mb::dmc60c {
namespace {

constexpr std::array links{LinkKind::Can};
constexpr std::array modes{Mode::Duty, Mode::Velocity, Mode::Position, Mode::Current, Mode::Voltage, Mode::Follow};

/// 5 is a CIM with a heavy load, 7 overshoots with its stored gains, 9 has no application.
constexpr std::array<std::string_view, 3> bench{
    "dmc60c:5,motor=cim,load=9",
    "dmc60c:7,motor=775pro,gains=overshoot",
    "dmc60c:9,state=bootloader",
};

constexpr LoopScale loop{
    .fullDuty = fullDuty,
    .period = 500e-6,
    .cycle = 500e-6,
    .velocityTime = 0.1,
    .velocityError = QT_TRANSLATE_NOOP("table", "count/100\u00A0ms"),
    .currentError = QT_TRANSLATE_NOOP("table", "A"),
    .time = QT_TRANSLATE_NOOP("table", "loop"),
    .divided = false,
    .derivativeInverted = false,
};

constexpr std::array ramped{Mode::Duty, Mode::Voltage}; // a loop has the ramp of its slot
constexpr Capabilities capabilities{
    .readback = true,
    .watchdog = true,
    .versionOnWire = true,
    .identify = true,
    .rename = true,
    .renumber = true,
    .restart = true,
    .output = {.ramp = ramped, .brake = true, .directions = true, .limits = true},
    .freeRates = false, // how often it sends its status is for everybody on the bus
    .lowestSupply = 11.0,
    .axes = 1,
    .gainSlots = 2,
    .commandPeriod = controlPeriod,
    .commandLimit = controlLimit,
    .watchdogLimit = std::chrono::milliseconds(250), // 104 with a margin
    .storesAfter = std::chrono::seconds(15),
    .storeLimit = std::chrono::duration_cast<std::chrono::seconds>(FlashProof::limit),
};

constexpr std::array<FaultRow, 5> faultRows{{
    {"over_current", QT_TRANSLATE_NOOP("table", "over-current")},
    {"over_temperature", QT_TRANSLATE_NOOP("table", "over-temperature")},
    {"under_voltage", QT_TRANSLATE_NOOP("table", "under-voltage")},
    {"gate_driver", QT_TRANSLATE_NOOP("table", "gate driver")},
    {"communication", QT_TRANSLATE_NOOP("table", "communication")},
}};

constexpr UpdateWords updateWords{
    .cancel = QT_TRANSLATE_NOOP("table", "The unit then waits in its bootloader; the update can be run again"),
    .critical = QT_TRANSLATE_NOOP("table", "Page 0 is being written: it must not be cut"),
    .cut = QT_TRANSLATE_NOOP("table",
        "A unit that is cut stays in its bootloader and can be updated again. Only page 0, the last, must not be "
        "interrupted."),
    .fatalCut = QT_TRANSLATE_NOOP("table", "Page 0 holds the reset vector. A cut now cannot be repaired over the bus."),
};

/// What a step needs of its status frames.
constexpr std::array<ChannelRate, 3> watched{{{"velocity", 100.0}, {"position", 100.0}, {"current", 50.0}}};

constexpr std::array<std::string_view, 2> livelyGains{"slot0.p", "slot0.i"};
constexpr std::array<std::string_view, 2> versionEntries{"application_version", "bootloader_version"};
constexpr std::array<DemoMotor, 2> demoMotors{{
    {5, "CIM", QT_TRANSLATE_NOOP("table", "load 9 × rotor inertia · 4096 counts a turn")},
    {7, "775pro", QT_TRANSLATE_NOOP("table", "4096 counts a turn")},
}};
constexpr DemoUnits demo{
    .tuned = 5,
    .livelierLimit = "current_limit.peak",
    .overshooting = 7,
    .livelyGains = livelyGains,
    .inBootloader = 9,
    .image = "dmc60c-demo.hex",
    .motors = demoMotors,
};

constexpr std::array<std::string_view, 11> slotNames{"p", "i", "d", "i_zone", "f", "allowable_error", "ramp",
    "max_forward", "max_reverse", "nominal_forward", "nominal_reverse"};
constexpr std::array<LoopGains, 3> triedLoops{{
    {Mode::Velocity, "slot#.", slotNames},
    {Mode::Position, "slot#.", slotNames},
    {Mode::Current, "slot#.", slotNames},
}};
constexpr std::array<DeviceLimit, 4> deviceLimits{{
    {DeviceLimit::Bounds::Position, "limit.forward.soft.threshold", "limit.forward.soft.enabled", 1.0},
    {DeviceLimit::Bounds::Position, "limit.reverse.soft.threshold", "limit.reverse.soft.enabled", 1.0},
    {DeviceLimit::Bounds::Current, "current_limit.continuous", "current_limit.enabled", 1.0},
    {DeviceLimit::Bounds::Duty, "slot#.max_forward", "", fullDuty},
}};
constexpr TrialTraits trials{
    .loops = triedLoops,
    .limits = deviceLimits,
    .bench = {.travel = 20e6, .speed = 1.5e6, .current = 150.0, .duty = 1.0},
    .rate = 200.0,
    .currentRate = 1000.0,
    .glideBeat = glideBeat,
    .hottest = 85.0,
    .lowestBus = 6.0,
    .highestBus = 28.0,
};

} // namespace

extern const Family family;
const Family family{
    .key = "dmc60c",
    .title = "DMC60C",
    .links = links,
    .parameters = parameterTable(),
    .channels = channelTable(),
    .modes = modes,
    .capabilities = capabilities,
    .bench = bench,
    .updateWords = updateWords,
    .states = stateTable(),
    .faults = faultRows,
    .watched = watched,
    .versionEntries = versionEntries,
    .demo = &demo,
    .loop = &loop,
    .trials = &trials,
    .scan = scan,
    .open = open,
    .recogniser = [] { return Recogniser(recognise); },
    .decodeCan = decodeCan,
    .update = update,
    .inspect = inspect,
    .simulate = simulate,
};

} // namespace mb::dmc60c
