// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/firmware.h"

#include "families/quadquad2drv/updater.h"
#include "transport/linkcatalog.h"
#include "wire/number.h"

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <utility>

namespace mb::quadquad2drv {
namespace {

Error noWay()
{
    return {Fault::OutOfRange, say("the board is updated over its UART"),
        say("name its serial port, for example --via serial:/dev/ttyUSB0")};
}

constexpr std::array<GuidedStep, 6> steps{{
    {QT_TRANSLATE_NOOP("table", "Close the jumper"),
        QT_TRANSLATE_NOOP("table",
            "Put a jumper on AUX1 and AUX2. The serial adapter has 3.3 V levels, its TX goes to RX and its RX to TX; "
            "the board "
            "gets 3.3 V only."),
        "jumper-closed"},
    {QT_TRANSLATE_NOOP("table", "Reset the board"),
        QT_TRANSLATE_NOOP("table",
            "Press its reset, or switch it off and on. Where the reset line is wired, this program pulses it."),
        "jumper-closed"},
    {QT_TRANSLATE_NOOP("table", "The bootloader greets"),
        QT_TRANSLATE_NOOP("table", "Its greeting on the serial port holds the word \"bootloader\"."), "jumper-closed"},
    {QT_TRANSLATE_NOOP("table", "The file is sent"),
        QT_TRANSLATE_NOOP(
            "table", "Line by line, each after the confirmation of the one before. Leave the jumper where it is."),
        "jumper-closed"},
    {QT_TRANSLATE_NOOP("table", "Take the jumper out"),
        QT_TRANSLATE_NOOP("table", "Then the board starts its new firmware. If it does not, reset it once more."),
        "jumper-open"},
    {QT_TRANSLATE_NOOP("table", "The version is compared"),
        QT_TRANSLATE_NOOP("table", "The board is asked for it over SPI."), "jumper-open"},
}};

constexpr std::array<std::string_view, 3> endings{"cr", "lf", "crlf"};
constexpr std::array<std::string_view, 4> formats{"8N1", "8E1", "8O1", "8N2"};
constexpr std::array<UpdateSetting, 7> unknowns{{
    {"baud", QT_TRANSLATE_NOOP("table", "baud rate"), QT_TRANSLATE_NOOP("table", "From the data sheet."), "115200"},
    {"format", QT_TRANSLATE_NOOP("table", "format"),
        QT_TRANSLATE_NOOP("table", "Data bits, parity, stop bits. Not told."), "8N1", formats},
    {"ending", QT_TRANSLATE_NOOP("table", "line ending"),
        QT_TRANSLATE_NOOP("table", "Not told; the terminal program that the data sheet names sends cr."), "cr",
        endings},
    {"banner", QT_TRANSLATE_NOOP("table", "greeting holds"),
        QT_TRANSLATE_NOOP("table", "The data sheet tells this word, and not the whole greeting."), "bootloader"},
    {"failure", QT_TRANSLATE_NOOP("table", "refusal holds"),
        QT_TRANSLATE_NOOP("table", "Not told. Words with | between them, in whatever case."), "err|fail|bad|invalid"},
    {"pause", QT_TRANSLATE_NOOP("table", "pause"),
        QT_TRANSLATE_NOOP("table", "Least time from one line to the next in milliseconds, from the data sheet."), "50"},
    {"farewell", QT_TRANSLATE_NOOP("table", "leaves with"),
        QT_TRANSLATE_NOOP("table", "Typed at the end. \"none\" leaves it to jumper and reset."), "reset"},
}};
constexpr std::array routeTable{UpdateRoute{"serial", "serial:/dev/ttyUSB0", {}, false, steps, unknowns}};

constexpr int slowestPause = 1000;

std::vector<std::string> words(const std::string &text)
{
    std::vector<std::string> found;
    std::string word;
    for (const char c : text + '|') {
        if (c != '|')
            word += static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
        else if (!word.empty())
            found.push_back(std::exchange(word, {}));
    }
    return found;
}

Result<void> apply(BootSettings &settings, const std::string &key, const std::string &value)
{
    if (key == "banner") {
        settings.banner = value;
    } else if (key == "farewell") {
        settings.farewell = value == "none" ? std::string() : value;
    } else if (key == "failure") {
        settings.failures = words(value);
    } else if (key == "ending") {
        if (std::find(endings.begin(), endings.end(), value) == endings.end())
            return fail(Fault::OutOfRange, say("ending=%1: legal are cr, lf and crlf", value));
        settings.ending = value == "cr" ? "\r" : value == "lf" ? "\n" : "\r\n";
    } else { // pause
        int milliseconds = 0;
        if (!takeNumber(value, milliseconds) || milliseconds < 0 || milliseconds > slowestPause)
            return fail(Fault::OutOfRange, say("pause=%1: legal are 0 to 1000 milliseconds", value));
        settings.lineTime = std::chrono::milliseconds(milliseconds);
    }
    return {};
}

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

Result<BootSettings> BootSettings::take(LinkAddress &via)
{
    constexpr std::array<std::string_view, 5> ours{"ending", "banner", "failure", "pause", "farewell"};
    BootSettings taken;
    std::vector<std::pair<std::string, std::string>> rest;
    for (const auto &[key, value] : via.options) {
        if (std::find(ours.begin(), ours.end(), key) == ours.end()) {
            rest.emplace_back(key, value);
            continue;
        }
        if (auto done = apply(taken, key, value); !done)
            return fail(done.error());
    }
    via.options = std::move(rest);
    return taken;
}

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
    (*link)->setBackground(device.link().background());
    if ((*link)->kind() != LinkKind::Serial)
        co_return refused(noWay());
    Updater updater(device, static_cast<SerialLink &>(**link), image, progress, *settings);
    auto task = updater.run(options.dryRun);
    UpdateReport report = co_await std::move(task);
    co_return report;
}

} // namespace mb::quadquad2drv
