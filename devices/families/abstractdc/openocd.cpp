// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/openocd.h"

#include "families/abstractdc/protocol.h"
#include "transport/programoutput.h"

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <cstdio>

namespace mb::abstractdc::openocd {
namespace {

constexpr std::size_t keptText = 20'000;

/// The two configurations of the firmware's repository.
struct Target {
    std::string_view key;
    std::string_view file;
    std::array<std::string_view, 2> setup;
};
constexpr std::array targets{
    Target{"f1", "target/stm32f1x.cfg", {"reset_config none separate", ""}},
    Target{"f4", "target/stm32f4x.cfg", {"adapter speed 2000", "reset_config srst_only srst_nogate"}},
};

const Target *targetOf(std::string_view key)
{
    const auto found = std::ranges::find(targets, key, &Target::key);
    return found == targets.end() ? nullptr : &*found;
}

bool isName(std::string_view text)
{
    return !text.empty() && text.front() != '/' && text.find("..") == std::string_view::npos
        && text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./")
        == std::string_view::npos;
}

std::string eraseCommand()
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "flash erase_address pad 0x%08X 0x%X", settingsAddress, settingsSize);
    return text.data();
}

/// SWD, as each probe calls it; the repository's own choice for its ST-Link.
std::string_view transportOf(std::string_view interface)
{
    if (interface == "stlink-dap")
        return "dapdirect_swd";
    const bool highLevel = interface.find("stlink") != std::string_view::npos
        || interface.find("nulink") != std::string_view::npos || interface == "ti-icdi";
    return highLevel ? "hla_swd" : "swd";
}

/// The first that is found counts.
constexpr Advice noProbe{QT_TRANSLATE_NOOP("table", "OpenOCD finds no debug probe"),
    QT_TRANSLATE_NOOP("table", "plug it in, and check that its kind is the one named after openocd:")};
constexpr std::array meanings{
    ProgramMeaning{"can't find interface/", Fault::OutOfRange,
        {QT_TRANSLATE_NOOP("table", "OpenOCD has no interface of this name"),
            QT_TRANSLATE_NOOP("table", "name one of its interface files, such as openocd:stlink")}},
    ProgramMeaning{"can't change session's transport", Fault::OutOfRange,
        {QT_TRANSLATE_NOOP("table", "this interface does not speak SWD"),
            QT_TRANSLATE_NOOP("table", "name a debug probe that does, such as openocd:stlink")}},
    ProgramMeaning{"doesn't support '", Fault::OutOfRange,
        {QT_TRANSLATE_NOOP("table", "this interface does not speak SWD"),
            QT_TRANSLATE_NOOP("table", "name a debug probe that does, such as openocd:stlink")}},
    ProgramMeaning{"** verify failed **", Fault::BadCheck,
        {QT_TRANSLATE_NOOP("table", "the microcontroller does not hold what was written"),
            QT_TRANSLATE_NOOP("table", "run it again with shorter wires or a lower speed")}},
    ProgramMeaning{"** programming failed **", Fault::Refused,
        {QT_TRANSLATE_NOOP("table", "the microcontroller refused to be written"),
            QT_TRANSLATE_NOOP("table", "it may be protected, or be another kind than --target says")}},
    ProgramMeaning{"unexpected idcode", Fault::Refused,
        {QT_TRANSLATE_NOOP("table", "the microcontroller is another kind than --target says"),
            QT_TRANSLATE_NOOP("table", "choose the other one of f1 and f4")}},
    ProgramMeaning{"unable to connect to the target", Fault::Timeout,
        {QT_TRANSLATE_NOOP("table", "the probe is there, but no microcontroller answers it"),
            QT_TRANSLATE_NOOP("table", "check SWDIO, SWCLK, ground and the power of the drive")}},
    ProgramMeaning{"cannot read idr", Fault::Timeout,
        {QT_TRANSLATE_NOOP("table", "the probe is there, but no microcontroller answers it"),
            QT_TRANSLATE_NOOP("table", "check SWDIO, SWCLK, ground and the power of the drive")}},
    ProgramMeaning{"unable to reset target", Fault::Timeout,
        {QT_TRANSLATE_NOOP("table", "the microcontroller could not be halted"),
            QT_TRANSLATE_NOOP("table", "check the reset wire and the power of the drive")}},
    ProgramMeaning{"libusb_error_access", Fault::LinkLost,
        {QT_TRANSLATE_NOOP("table", "the debug probe is there but may not be opened"),
            QT_TRANSLATE_NOOP("table", "install OpenOCD's udev rules or ask your administrator")}},
    ProgramMeaning{"open failed", Fault::LinkLost, noProbe},
    ProgramMeaning{"unable to find", Fault::LinkLost, noProbe},
    ProgramMeaning{"unable to open", Fault::LinkLost, noProbe},
    ProgramMeaning{"no j-link device found", Fault::LinkLost, noProbe},
    ProgramMeaning{"failed to open or find", Fault::LinkLost, noProbe},
    ProgramMeaning{"xds110: failed to connect", Fault::LinkLost, noProbe},
    ProgramMeaning{"no device found", Fault::LinkLost, noProbe},
};

} // namespace

Result<Job> jobOf(std::string_view via, std::string_view target)
{
    constexpr std::string_view scheme = "openocd:";
    if (via.substr(0, scheme.size()) != scheme || !isName(via.substr(scheme.size())))
        return via.empty() ? fail(Fault::OutOfRange, say("an Abstract DC Drive is written through a debug probe"),
                   say("add --via openocd:INTERFACE --target f1|f4, such as --via openocd:stlink --target f1"))
                           : fail(Fault::OutOfRange, say("--via: '%1' is no way into an Abstract DC Drive", via),
                               say("write openocd:INTERFACE, such as openocd:stlink"));
    if (!targetOf(target))
        return fail(Fault::OutOfRange,
            target.empty() ? say("--target is missing") : say("--target: '%1' is unknown", target),
            say("the microcontroller of the drive is f1 (STM32F1) or f4 (STM32F4)"));
    return Job{std::string(via.substr(scheme.size())), std::string(target), {}, false};
}

ExternalProgram::Command commandOf(const Job &job)
{
    const Target &target = *targetOf(job.target);
    std::vector<std::string> arguments{"-f", "interface/" + job.interface + ".cfg", "-c",
        "transport select " + std::string(transportOf(job.interface)), "-f", std::string(target.file)};
    const auto order = [&arguments](std::string command) {
        arguments.emplace_back("-c");
        arguments.push_back(std::move(command));
    };
    for (const std::string_view setup : target.setup) {
        if (!setup.empty())
            order(std::string(setup));
    }
    if (job.eraseSettings) {
        order("init");
        order("reset halt");
        order("echo {** Erasing Settings **}"); // it says only afterwards that it has
        order(eraseCommand());                  // before the program, which may share a sector with the settings
    }
    order("program {" + job.file + "} verify reset exit");
    return {"openocd", std::move(arguments)};
}

Message titleOf(Stage stage)
{
    switch (stage) {
    case Stage::Connecting: return say("Connecting through OpenOCD");
    case Stage::Erasing: return say("Erasing the stored settings");
    case Stage::Writing: return say("Writing flash");
    case Stage::Verifying: return say("Verifying flash");
    case Stage::Resetting: return say("Restarting the drive");
    case Stage::Over: return say("Looking for the drive");
    }
    return Message();
}

void Reading::take(std::string_view line)
{
    const std::string low = lowered(line);
    if (m_all.size() < keptText)
        m_all += low + '\n';
    const auto error = low.find("error:");
    if (error != std::string::npos && m_firstError.empty())
        m_firstError = line.substr(std::min(line.size(), error + 7));
    if (low.find("erased address") != std::string::npos || low.find("erased sectors") != std::string::npos) {
        m_erased = true;
        m_stage = Stage::Erasing;
    }
    if (low.find("** erasing settings **") != std::string::npos)
        m_stage = Stage::Erasing;
    if (low.find("** programming started **") != std::string::npos)
        m_stage = Stage::Writing;
    if (low.find("** verify started **") != std::string::npos)
        m_stage = Stage::Verifying;
    if (low.find("** verified ok **") != std::string::npos)
        m_verified = true;
    if (low.find("** resetting target **") != std::string::npos)
        m_stage = Stage::Resetting;
}

Error Reading::failure(const Job &job) const
{
    if (const auto meaning = meaningOf(meanings, m_all))
        return *meaning;
    if (m_firstError.empty())
        return {Fault::BadReply, say("OpenOCD ended without saying why"),
            say("run it by hand with interface %1", job.interface)};
    return {Fault::BadReply, say("OpenOCD: %1", m_firstError), say("run it by hand to see all it says")};
}

} // namespace mb::abstractdc::openocd
