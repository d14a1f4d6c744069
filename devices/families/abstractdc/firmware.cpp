// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/firmware.h"

#include "families/abstractdc/controller.h"
#include "families/abstractdc/openocd.h"
#include "families/abstractdc/protocol.h"
#include "firmware/programmer.h"
#include "model/answersagain.h"
#include "wire/bytes.h"

#include <QtGlobal>

#include <QTemporaryFile>

#include <array>
#include <memory>
#include <optional>

namespace mb::abstractdc {
namespace {

using openocd::Stage;

constexpr std::uint32_t flashBegin = 0x08000000;
constexpr std::uint32_t flashEnd = 0x08200000;
constexpr std::uint32_t pageSize = 1024;

bool touchesSettings(const FirmwareImage &image)
{
    return image.hasAny(settingsAddress, settingsAddress + settingsSize - 1);
}

/// An STM32F4 erases the whole sector of 16 KiB that they are in.
bool takesSettings(const FirmwareImage &image, const std::string &target)
{
    constexpr std::uint32_t sector = 0x4000;
    constexpr std::uint32_t begin = settingsAddress / sector * sector;
    return touchesSettings(image) || (target == "f4" && image.hasAny(begin, begin + sector - 1));
}

/// One run of OpenOCD, however it ended.
struct Attempt {
    openocd::Reading reading;
    std::optional<Error> error; ///< of one that failed
};

/// From when on the drive does not hold its settings any more, and whether they are blank now; nothing while it does.
std::optional<bool> blankSettings(const openocd::Reading &reading, const openocd::Job &job, bool takesSettings)
{
    if (takesSettings && reading.stage() >= Stage::Writing)
        return false;
    if (job.eraseSettings && reading.stage() >= Stage::Erasing)
        return reading.isErased();
    return std::nullopt;
}

void mark(Progress &progress, const std::vector<int> &pages, PartState state)
{
    for (const int page : pages)
        progress.part(page, state);
}

void show(const openocd::Reading &reading, Progress &progress)
{
    progress.mayInterrupt(reading.stage() == Stage::Connecting);
    progress.step(titleOf(reading.stage()), static_cast<int>(reading.stage()), static_cast<int>(Stage::Over));
}

/// Runs OpenOCD to its end; its error is one line that names the remedy.
Task<Attempt> program(
    Controller &drive, openocd::Job job, std::vector<int> pages, bool takesSettings, Progress &progress)
{
    if (!ExternalProgram::locate("openocd"))
        co_return fail(
            Fault::LinkLost, say("openocd is not installed"), say("install it with"), "sudo apt install openocd");
    openocd::Reading reading;
    HeldDevice held(drive);
    const auto forget = [&] {
        if (const auto blank = blankSettings(reading, job, takesSettings))
            drive.settingsReplaced(*blank);
    };
    const auto take = [&](const ExternalProgram::Piece &piece) {
        const Stage before = reading.stage();
        const bool wasErased = reading.isErased();
        if (piece.complete)
            reading.take(piece.text);
        if (before == Stage::Connecting && reading.stage() > before)
            held.hold(forget);
        if (reading.stage() >= Stage::Resetting)
            held.release();
        if (reading.isErased() && !wasErased && !held.hasAnswered()) // now: it may die
            forget();
        if (reading.stage() != before && reading.stage() == Stage::Writing)
            mark(progress, pages, PartState::Active);
        if (reading.stage() != before && reading.stage() == Stage::Verifying)
            mark(progress, pages, PartState::Done);
        show(reading, progress);
    };
    mark(progress, pages, PartState::Waiting);
    show(reading, progress);
    auto running
        = runProgrammer(drive.clock(), openocd::commandOf(job), say("check the probe and try again"), take, progress);
    const Result<ExternalProgram::Exit> exit = co_await std::move(running).attempt();
    held.release();
    const bool isWritten = exit && exit->isSuccess() && reading.isVerified();
    if (isWritten && held.hasAnswered())
        co_return Attempt{std::move(reading), anotherUnit(drive)};
    if (!held.hasAnswered())
        forget();
    if (isWritten)
        co_return Attempt{std::move(reading), {}};
    Error error = exit ? reading.failure(job) : exit.error();
    if (reading.stage() >= Stage::Writing)
        error.remedy = joined(
            error.remedy, say("the drive may hold half a program, and runs again once an update has succeeded"));
    co_return Attempt{std::move(reading), std::move(error)};
}

Result<void> preflight(const FirmwareImage &image, const UpdateOptions &options)
{
    MB_TRY_VOID(inspect(image));
    if (options.eraseSettings && touchesSettings(image))
        return fail(
            Fault::OutOfRange, say("the image itself writes the settings pages"), say("leave out erasing them"));
    return {};
}

} // namespace

Result<ImageSummary> inspect(const FirmwareImage &image)
{
    const auto &segments = image.segments();
    if (segments.empty() || segments.front().first < flashBegin || segments.back().last >= flashEnd)
        return fail(Fault::OutOfRange,
            say("this is no program for the drive: it has bytes outside the flash of an STM32, 0x08000000 … "
                "0x081FFFFF"));
    std::array<std::uint8_t, 8> vectors{};
    image.overlay(flashBegin, vectors);
    const std::uint32_t stack = readU32le(vectors, 0);
    const std::uint32_t reset = readU32le(vectors, 4);
    if (image.byteCount(flashBegin, flashBegin + 7) != vectors.size() || (stack >> 24U) != 0x20U || (reset & 1U) == 0
        || !image.has(reset & ~1U))
        return fail(Fault::OutOfRange,
            say("this is no program for the drive: there are no vectors of an STM32 at 0x08000000. Make the Intel HEX "
                "file with: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf"));
    ImageSummary summary;
    for (std::uint32_t page = flashBegin; page <= segments.back().last; page += pageSize) {
        if (image.hasAny(page, page + pageSize - 1))
            summary.parts.push_back(static_cast<int>((page - flashBegin) / pageSize));
    }
    summary.notes.emplace_back(
        say("The drive tells no version: the programmer's own verify and the drive's answer prove the update."));
    if (touchesSettings(image))
        summary.notes.emplace_back(say("The image writes the settings pages: stored gains are replaced."));
    return summary;
}

Task<UpdateReport> update(Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress)
{
    auto job = co_await openocd::jobOf(options.via, options.target);
    co_await preflight(image, options);
    const auto summary = inspect(image);
    UpdateReport report;
    if (options.dryRun) {
        report.outcome = UpdateOutcome::Done;
        report.evidence = say("nothing was written; the image fits, %1 pages", summary->parts.size());
        co_return report;
    }
    const auto file = co_await hexFileFor(image, "OpenOCD");
    job.file = file->fileName().toStdString();
    job.eraseSettings = options.eraseSettings;
    if (options.eraseSettings)
        progress.log(Severity::Caution,
            say("the gains stored in the drive are erased; all its loops do nothing until they are written again"));
    if (takesSettings(image, options.target))
        progress.log(Severity::Caution, say("The image writes the settings pages: stored gains are replaced."));
    device.stop();
    auto programming = program(
        static_cast<Controller &>(device), job, summary->parts, takesSettings(image, options.target), progress);
    const Attempt attempt = co_await std::move(programming);
    if (attempt.error)
        co_return fail(*attempt.error);
    report.pages = static_cast<int>(summary->parts.size());
    progress.accepted(report.pages, 0);
    progress.mayInterrupt(true);
    progress.step(titleOf(Stage::Over), static_cast<int>(Stage::Over), static_cast<int>(Stage::Over));
    const bool answered = co_await answersAgain(device);
    report.outcome = answered ? UpdateOutcome::Done : UpdateOutcome::Failed;
    report.verified = answered;
    report.evidence = answered ? say("OpenOCD verified the flash, and the drive answers again")
                               : say("OpenOCD verified the flash, but nothing answers as %1; the new firmware may have "
                                     "another offset or bit rate: scan again",
                                   device.selector());
    if (!answered)
        report.fault = Fault::Timeout;
    co_return report;
}

} // namespace mb::abstractdc
