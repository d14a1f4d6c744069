// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/firmware.h"

#include "families/quadquad2drv/bootsettings.h"
#include "families/quadquad2drv/drawings.h"
#include "families/quadquad2drv/updater.h"
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
