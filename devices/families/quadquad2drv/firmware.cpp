// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/firmware.h"

#include "families/quadquad2drv/bootsettings.h"
#include "families/quadquad2drv/updater.h"
#include "firmware/updateroute.h"
#include "transport/linkcatalog.h"

#include <QtGlobal>

#include <array>
#include <utility>

namespace mb::quadquad2drv {
namespace {

Error noWay()
{
    return {Fault::OutOfRange, say("the board is updated over its UART"),
        say("name its serial port, for example --via serial:/dev/ttyUSB0")};
}

constexpr std::string_view boardLayer = R"svg(
<rect x="112" y="8" width="180" height="152" rx="6" fill="{control}" stroke="{outline}" stroke-width="1.5"/>
<text x="202" y="150" text-anchor="middle" font-size="11" fill="{dim}">QuadQuad2Drv</text>
<rect x="190" y="88" width="44" height="40" fill="{panel}" stroke="{outline}"/>
<circle cx="196" cy="94" r="2" fill="{outline}"/>
)svg";

constexpr std::string_view adapterLayer = R"svg(
<rect x="8" y="28" width="62" height="104" rx="4" fill="{panel}" stroke="{outline}" stroke-width="1.5"/>
<text x="2" y="21" font-size="11" fill="{dim}">{0}</text>
)svg";

constexpr std::string_view wireLayer = R"svg(
<g stroke-width="2" stroke-linecap="round">
<line x1="62" y1="48" x2="122" y2="48" stroke="{danger}"/>
<line x1="62" y1="70" x2="122" y2="92" stroke="{accent}"/>
<line x1="62" y1="92" x2="122" y2="70" stroke="{ok}"/>
<line x1="62" y1="114" x2="122" y2="114" stroke="{dim}"/>
</g>
<g fill="{canvas}" stroke="{outline}">
<circle cx="62" cy="48" r="4"/><circle cx="122" cy="48" r="4"/>
<circle cx="62" cy="70" r="4"/><circle cx="122" cy="92" r="4"/>
<circle cx="62" cy="92" r="4"/><circle cx="122" cy="70" r="4"/>
<circle cx="62" cy="114" r="4"/><circle cx="122" cy="114" r="4"/>
</g>
<g font-size="11" fill="{text}">
<text x="12" y="52">3V3</text><text x="130" y="52">3V3</text>
<text x="12" y="74">TX</text><text x="130" y="96">RX</text>
<text x="12" y="96">RX</text><text x="130" y="74">TX</text>
<text x="12" y="118">GND</text><text x="130" y="118">GND</text>
</g>
)svg";

constexpr std::string_view pinLayer = R"svg(
<g fill="{canvas}" stroke="{outline}"><circle cx="216" cy="52" r="4"/><circle cx="246" cy="52" r="4"/></g>
<g font-size="11" fill="{text}" text-anchor="middle"><text x="208" y="75">AUX1</text><text x="254" y="75">AUX2</text></g>
)svg";

/// A cap over both pins …
constexpr std::string_view capOn = R"svg(
<rect x="207" y="43" width="48" height="18" rx="4" fill="{accent}" stroke="{accent}" stroke-width="2"/>
<line x1="216" y1="52" x2="246" y2="52" stroke="{onfill}" stroke-width="2"/>
)svg";

/// … or beside them, with the way it went.
constexpr std::string_view capOff = R"svg(
<rect x="207" y="13" width="48" height="18" rx="4" fill="none" stroke="{accent}" stroke-width="1.5" stroke-dasharray="6,3"/>
<g stroke="{accent}" stroke-width="1.5">
<line x1="231" y1="48" x2="231" y2="34"/><line x1="231" y1="34" x2="228" y2="38"/><line x1="231" y1="34" x2="234" y2="38"/>
</g>
)svg";

constexpr std::array closedLayers{boardLayer, adapterLayer, wireLayer, pinLayer, capOn};
constexpr std::array openLayers{boardLayer, adapterLayer, wireLayer, pinLayer, capOff};
constexpr std::array<std::string_view, 1> drawingWords{QT_TRANSLATE_NOOP("table", "adapter, 3.3 V")};

/// The board from above with its serial adapter, not to scale: how TX and RX cross, and the jumper between AUX1 and AUX2 …
const Drawing jumperClosed{
    .width = 300,
    .height = 168,
    .layers = closedLayers,
    .words = drawingWords,
    .description = QT_TRANSLATE_NOOP(
        "table", "Drawing: the jumper connects AUX1 and AUX2; adapter TX to board RX, RX to TX, 3.3 V, GND"),
};
/// … taken out.
const Drawing jumperOpen{
    .width = 300,
    .height = 168,
    .layers = openLayers,
    .words = drawingWords,
    .description = QT_TRANSLATE_NOOP("table", "Drawing: the jumper between AUX1 and AUX2 is taken out"),
};

constexpr std::array<GuidedStep, 6> guidedSteps{{
    {QT_TRANSLATE_NOOP("table", "Close the jumper"),
        QT_TRANSLATE_NOOP("table",
            "Put a jumper on AUX1 and AUX2. The serial adapter has 3.3 V levels, its TX goes to RX and its RX to TX; "
            "the board "
            "gets 3.3 V only."),
        &jumperClosed},
    {QT_TRANSLATE_NOOP("table", "Reset the board"),
        QT_TRANSLATE_NOOP("table",
            "Press its reset, or switch it off and on. Where the reset line is wired, this program pulses it."),
        &jumperClosed},
    {QT_TRANSLATE_NOOP("table", "The bootloader greets"),
        QT_TRANSLATE_NOOP("table", "Its greeting on the serial port holds the word \"bootloader\"."), &jumperClosed},
    {QT_TRANSLATE_NOOP("table", "The file is sent"),
        QT_TRANSLATE_NOOP(
            "table", "Line by line, each after the confirmation of the one before. Leave the jumper where it is."),
        &jumperClosed},
    {QT_TRANSLATE_NOOP("table", "Take the jumper out"),
        QT_TRANSLATE_NOOP("table", "Then the board starts its new firmware. If it does not, reset it once more."),
        &jumperOpen},
    {QT_TRANSLATE_NOOP("table", "The version is compared"),
        QT_TRANSLATE_NOOP("table", "The board is asked for it over SPI."), &jumperOpen},
}};

constexpr UpdateWords updateWords{
    .cancel = QT_TRANSLATE_NOOP("table", "The unit then waits in its bootloader; the update can be run again"),
    .critical = QT_TRANSLATE_NOOP("table", "The flash is being written: it must not be cut"),
    .cut = QT_TRANSLATE_NOOP(
        "table", "A board that is cut stays in its bootloader. Leave the jumper in and run the update again."),
    .silent = QT_TRANSLATE_NOOP("table", "reset it without the jumper of its bootloader"),
};
const std::array routeTable{UpdateRoute{.scheme = "serial",
    .example = "serial:/dev/ttyUSB0",
    .steps = guidedSteps,
    .settings = bootUnknowns(),
    .words = updateWords}};

UpdateReport refused(const Error &error)
{
    UpdateReport report;
    report.outcome = UpdateOutcome::Refused;
    report.evidence = error.detail;
    report.remedy = error.help();
    report.fault = error.fault;
    return report;
}

} // namespace

std::span<const UpdateRoute> routes()
{
    return routeTable;
}

Result<ImageSummary> inspect(const FirmwareImage &image)
{
    if (image.lines().empty())
        return fail(Fault::OutOfRange, say("the file has no lines to send"));
    ImageSummary summary;
    summary.notes.push_back(
        say("%1 lines, %2 bytes; the file does not name its version", image.lines().size(), image.byteCount()));
    return summary;
}

Task<UpdateReport> update(Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress)
{
    if (!options.target.empty())
        co_return fail(Fault::Unsupported, say("a QuadQuad2Drv has one kind of chip"), say("leave the target out"));
    if (options.via.empty())
        co_return refused(noWay());
    auto address = LinkAddress::parse(options.via);
    if (!address)
        co_return refused(address.error());
    const auto settings = BootSettings::take(*address);
    if (!settings)
        co_return refused(settings.error());
    auto link = createLink(*address, device.clock());
    if (!link)
        co_return refused(link.error());
    (*link)->settings().background = device.link().settings().background;
    if ((*link)->kind() != LinkKind::Serial)
        co_return refused(noWay());
    Updater updater(device, static_cast<SerialLink &>(**link), image, progress, *settings);
    UpdateReport report = co_await updater.run(options.dryRun);
    co_return report;
}

} // namespace mb::quadquad2drv
