// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"

#include "families/abstractdc/channels.h"
#include "families/abstractdc/controller.h"
#include "families/abstractdc/decode.h"
#include "families/abstractdc/firmware.h"
#include "families/abstractdc/parameters.h"
#include "families/abstractdc/protocol.h"
#include "families/abstractdc/recognition.h"
#include "families/abstractdc/scan.h"
#include "families/abstractdc/setpoints.h"
#include "families/abstractdc/simulator.h"

#include <QtGlobal>

#include <array>

namespace mb::abstractdc {
namespace {

constexpr std::array links{LinkKind::Can};
constexpr std::array modes{Mode::Duty, Mode::Velocity, Mode::Position, Mode::Current};

/// One of each dialect that can be driven.
constexpr std::array<std::string_view, 3> bench{
    "abstractdc:3,dialect=F,motor=25d",
    "abstractdc:4,dialect=L,motor=n20",
    "abstractdc:5,dialect=D,motor=25dlp",
};

constexpr std::array<DialectChoice, 4> dialectChoices{{
    {"F", QT_TRANSLATE_NOOP("table", "F: the firmware's codes"),
        QT_TRANSLATE_NOOP("table",
            "A unit that speaks the document's codes would take position for current and current for position.")},
    {"L", QT_TRANSLATE_NOOP("table", "L: legacy frames of 8 bytes"),
        QT_TRANSLATE_NOOP(
            "table", "A unit with today's firmware ignores these frames, the stop excepted, which is sent both ways.")},
    {"LL", QT_TRANSLATE_NOOP("table", "LL: older, cannot be stopped"),
        QT_TRANSLATE_NOOP("table", "It is only watched: there is no code that stops it.")},
    {"D", QT_TRANSLATE_NOOP("table", "D: the document's codes"),
        QT_TRANSLATE_NOOP("table",
            "A unit that speaks the firmware's codes runs at full power when it is told a position, and loses its "
            "divisor when D is written.")},
}};

constexpr std::array<Calibration, 3> calibrations{{
    {countsPerRevolutionKey, "counts", QT_TRANSLATE_NOOP("table", "Counts per revolution"),
        QT_TRANSLATE_NOOP("table", "Encoder edges in one turn: four times its lines."), 1.0, 1e9},
    {calibration::amperes, "A", QT_TRANSLATE_NOOP("table", "Ampere per count"),
        QT_TRANSLATE_NOOP("table", "What one count of the current converter stands for; it depends on the board."),
        1e-6, 1e3},
    {calibration::degrees, "°C", QT_TRANSLATE_NOOP("table", "Degrees per count"),
        QT_TRANSLATE_NOOP("table", "What one count of the temperature converter stands for; it depends on the board."),
        1e-6, 1e3},
}};

constexpr std::array<std::string_view, 2> targets{"f1", "f4"};
/// Interface files of OpenOCD for probes that speak SWD.
constexpr std::array programmers{
    Programmer{"stlink", "ST-Link"},
    Programmer{"cmsis-dap", "CMSIS-DAP"},
    Programmer{"jlink", "J-Link"},
};
constexpr UpdateWords programmed{
    .cancel = QT_TRANSLATE_NOOP("table",
        "Nothing is written yet. Where OpenOCD has halted the drive already it stands still: switch it off and on"),
    .written = QT_TRANSLATE_NOOP("table", "All of it is written; whether the unit runs it is not known then"),
    .critical = QT_TRANSLATE_NOOP("table", "The flash is being written: it must not be cut"),
    .cut = QT_TRANSLATE_NOOP("table",
        "A unit that is cut while it is written holds half a program. It runs again once an update has succeeded."),
};
constexpr std::array routes{UpdateRoute{.scheme = "openocd",
    .example = "openocd:stlink",
    .targets = targets,
    .erasesSettings = true,
    .programmers = programmers,
    .words = programmed}};

constexpr std::array<FaultRow, 3> faultRows{{
    {"output_saturated", QT_TRANSLATE_NOOP("table", "output saturated")},
    {"output_wrapped", QT_TRANSLATE_NOOP("table", "output wrapped around")},
    {PowerCycleDebt::fault, QT_TRANSLATE_NOOP("table", "averaging changed: it may overwrite its memory")},
}};

constexpr std::array<ChannelRate, 3> watched{{{"velocity", 100.0}, {"position", 100.0}, {"current", 50.0}}};

/// README.md#control-law: time in milliseconds, the change taken the wrong way round.
constexpr LoopScale controlLoop{
    .fullDuty = fullPwm,
    .period = 1e-3,
    .cycle = 20.04e-3,
    .integralStep = 1.0,
    .clock = 1e-3,
    .velocityTime = 1.0,
    .velocityWindow = 20.04e-3, // from pass to pass; its log is of the last velocity loop, not of now
    .velocityError = QT_TRANSLATE_NOOP("table", "count/s"),
    .currentError = QT_TRANSLATE_NOOP("table", "ADC count"),
    .time = QT_TRANSLATE_NOOP("table", "ms"),
    .divided = true,
    .derivativeInverted = true,
    .dutyAtOnce = true,
};

constexpr std::array ramped{Mode::Duty}; // by this program, TargetLead
constexpr Capabilities capabilities{
    .readback = false,
    .watchdog = false,
    .versionOnWire = false,
    .identify = false,
    .rename = false,
    .renumber = false,
    .output = {.ramp = ramped, .usualRamp = usualRamp},
    .lastAddress = maxOffset,
    .axes = 1,
    .gainSlots = 1,
    .commandPeriod = std::chrono::milliseconds(20),
};

constexpr std::array<std::string_view, 4> gainNames{"p", "i", "d", "divisor"};
constexpr std::array<LoopGains, 3> triedLoops{{
    {Mode::Velocity, "velocity.", gainNames},
    {Mode::Position, "position.", gainNames},
    {Mode::Current, "current.", gainNames, true},
}};
constexpr TrialTraits trials{
    .loops = triedLoops,
    .bench = {.travel = 5e6, .speed = 5e5, .current = 150.0, .duty = 1.0},
    .rate = 100.0,
    .never = "current.averaging",
};

} // namespace

extern const Family family;
const Family family{
    .key = "abstractdc",
    .title = "Abstract DC",
    .links = links,
    .parameters = parameterTable(),
    .channels = channelTable(),
    .modes = modes,
    .capabilities = capabilities,
    .bench = bench,
    .dialects = dialectChoices,
    .calibrations = calibrations,
    .routes = routes,
    .faults = faultRows,
    .watched = watched,
    .loop = &controlLoop,
    .trials = &trials,
    .arrange = arrange,
    .scan = scan,
    .open = open,
    .recogniser
    = [] { return Recogniser([heard = Recognition()](const CanFrame &frame) mutable { return heard.take(frame); }); },
    .decodeCan = decodeCan,
    .followCan = followCan,
    .update = update,
    .inspect = inspect,
    .simulate = simulate,
};

} // namespace mb::abstractdc
