// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"

#include "families/supermodified/avrdude.h"
#include "families/supermodified/channels.h"
#include "families/supermodified/controller.h"
#include "families/supermodified/decode.h"
#include "families/supermodified/firmware.h"
#include "families/supermodified/parameters.h"
#include "families/supermodified/protocol.h"
#include "families/supermodified/scan.h"
#include "families/supermodified/simulator.h"
#include "families/supermodified/states.h"

#include <QtGlobal>

#include <array>

namespace mb::supermodified {
namespace {

constexpr std::array links{LinkKind::Serial};
constexpr std::array modes{Mode::Velocity, Mode::Position, Mode::RampPosition, Mode::RampVelocity};

constexpr std::array<std::string_view, 2> bench{
    "supermodified:4,dialect=D1",
    "supermodified:5,dialect=D3",
};

constexpr std::array calibrations{
    Calibration{calibration::amperes, "A", QT_TRANSLATE_NOOP("table", "Ampere per count"),
        QT_TRANSLATE_NOOP("table", "D1 and D2: what one count of the current converter stands for; D3 tells ampere."),
        1e-6, 1e3},
};

/// As avrdude calls them. The first two speak to the serial bootloader, the others to the programming pins.
constexpr std::array programmers{
    Programmer{"arduino", QT_TRANSLATE_NOOP("table", "serial bootloader"), Programmer::Port::Serial},
    Programmer{"stk500v1", QT_TRANSLATE_NOOP("table", "serial bootloader, without reset"), Programmer::Port::Serial},
    Programmer{"usbasp", "USBasp", Programmer::Port::Usb},
    Programmer{"usbtiny", "USBtiny", Programmer::Port::Usb},
    Programmer{"avrispmkii", "AVRISP mkII", Programmer::Port::Usb},
    Programmer{"atmelice_isp", "Atmel-ICE", Programmer::Port::Usb},
    Programmer{"stk500v2", "STK500", Programmer::Port::Serial},
    Programmer{"avrisp", "AVR ISP", Programmer::Port::Serial},
};
constexpr UpdateWords programmedWords{
    .cancel = QT_TRANSLATE_NOOP("table", "Nothing is written yet; the update can be run again"),
    .written = QT_TRANSLATE_NOOP("table", "All of it is written; whether the unit runs it is not known then"),
    .critical = QT_TRANSLATE_NOOP("table", "The flash is being written: it must not be cut"),
    .cut = QT_TRANSLATE_NOOP("table",
        "A unit that is cut while it is written holds half a program. It runs again once an update has succeeded."),
};
constexpr std::array routes{
    UpdateRoute{.scheme = avrdude::scheme,
        .example = "avrdude:arduino:/dev/ttyUSB0",
        .programmers = programmers,
        .words = programmedWords},
};

constexpr std::array<ChannelRate, 3> watched{{{"velocity", 100.0}, {"position", 100.0}, {"current", 50.0}}};

constexpr Capabilities capabilities{
    .readback = true,
    .watchdog = false,
    .versionOnWire = false,
    .identify = false,
    .rename = false,
    .renumber = true,
    .relativeMoves = true,
    .bufferedMoves = true,
    .storesAtOnce = true,
    .zeroPosition = true,
    .firstAddress = lowestNode,
    .lastAddress = highestNode,
    .axes = 1,
    .gainSlots = 1,
    .scanLimit = std::chrono::seconds(30),
};

constexpr std::array<std::string_view, 3> gainNames{"p", "i", "d"};
constexpr std::array<LoopGains, 1> triedLoops{{{Mode::Position, "gain.", gainNames}}};
constexpr std::array<DeviceLimit, 1> deviceLimits{{{DeviceLimit::Bounds::Current, "limit.current", "", 1000.0}}};
constexpr TrialTraits trials{
    .loops = triedLoops,
    .limits = deviceLimits,
    .bench = {.travel = 1e6, .speed = 1e6, .current = 5.0, .duty = 1.0},
    .rate = 100.0,
    .raw = {.cycle = 1.0 / loopsPerSecond,
        .fullDuty = 256.0 * 255.0,
        .integral = 256.0,
        .dialects = "D1 D2",
        .profileRate = "profile.velocity",
        .profileAcceleration = "profile.acceleration"},
    .nudge = 20.0,
    .nudgeTravel = 60.0,
    .atBoot = "gain.p",
    .atBootDialects = "D1 D2",
};

/// Friction holds what P makes of the last counts; the integral does not reach it. Measured: 19 counts short, then 1.
constexpr std::array<std::pair<std::string_view, double>, 2> arrivingGains{{{"gain.p", 4000.0}, {"gain.d", 32000.0}}};
constexpr std::array<DemoMotor, 1> demoMotors{{
    {5, QT_TRANSLATE_NOOP("table", "N20 geared"), QT_TRANSLATE_NOOP("table", "gear 75.81:1 · 32768 counts a turn")},
}};
constexpr DemoUnits demo{
    .stoppingShort = 5, .shortStep = 200.0, .shortBy = 20.0, .arrivingGains = arrivingGains, .motors = demoMotors};

} // namespace

extern const Family family;
const Family family{
    .key = "supermodified",
    .title = "Supermodified",
    .links = links,
    .parameters = parameterTable(),
    .channels = channelTable(),
    .modes = modes,
    .capabilities = capabilities,
    .bench = bench,
    .calibrations = calibrations,
    .routes = routes,
    .states = stateTable(),
    .faults = faultTable(),
    .watched = watched,
    .demo = &demo,
    .trials = &trials,
    .scan = scan,
    .probe = probe,
    .open = open,
    .decodeBytes = decodeBytes,
    .update = update,
    .inspect = inspect,
    .simulate = simulate,
};

} // namespace mb::supermodified
