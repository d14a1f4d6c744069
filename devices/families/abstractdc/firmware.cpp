// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/firmware.h"

#include "async/sleep.h"
#include "families/abstractdc/controller.h"
#include "families/abstractdc/openocd.h"
#include "families/abstractdc/protocol.h"
#include "wire/bytes.h"

#include <QtGlobal>

#include <QDir>
#include <QTemporaryFile>

#include <array>
#include <cstdio>
#include <memory>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;
using openocd::Stage;

constexpr std::uint32_t flashBegin = 0x08000000;
constexpr std::uint32_t flashEnd = 0x08200000;
constexpr std::uint32_t pageSize = 1024;
constexpr Duration patience = 60s; ///< between two lines; a whole flash is erased and written in less
constexpr Duration answerEvery = 500ms;
constexpr int answerTries = 10;

bool touchesSettings(const FirmwareImage &image)
{
    return image.hasAny(settingsAddress, settingsAddress + settingsSize - 1);
}

std::string hexLine(std::uint32_t address, int type, std::span<const std::uint8_t> data)
{
    std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(data.size()), static_cast<std::uint8_t>(address >> 8U),
        static_cast<std::uint8_t>(address & 0xFFU), static_cast<std::uint8_t>(type)};
    bytes.insert(bytes.end(), data.begin(), data.end());
    unsigned sum = 0;
    for (const std::uint8_t byte : bytes)
        sum += byte;
    bytes.push_back(static_cast<std::uint8_t>(0U - sum));
    std::string line = ":";
    for (const std::uint8_t byte : bytes) {
        std::array<char, 4> text{};
        std::snprintf(text.data(), text.size(), "%02X", unsigned{byte});
        line += text.data();
    }
    return line + '\n';
}

Result<std::unique_ptr<QTemporaryFile>> written(const FirmwareImage &image)
{
    auto file = std::make_unique<QTemporaryFile>(QDir::tempPath() + QStringLiteral("/motorbench-XXXXXX.hex"));
    const std::string text = toIntelHex(image);
    if (!file->open() || file->write(text.data(), static_cast<qint64>(text.size())) != static_cast<qint64>(text.size())
        || !file->flush())
        return fail(Fault::LinkLost,
            say("a temporary file for OpenOCD cannot be written: %1", file->errorString().toStdString()),
            say("make room in %1", QDir::tempPath().toStdString()));
    return file;
}

/// Runs OpenOCD to its end; fails with one line that names the remedy.
Task<openocd::Reading> program(Clock &clock, openocd::Job job, std::vector<int> pages, Progress &progress)
{
    const auto mark = [&pages, &progress](PartState state) {
        for (const int page : pages)
            progress.part(page, state);
    };
    mark(PartState::Waiting);
    ExternalProgram openocd(clock);
    if (!ExternalProgram::locate("openocd"))
        co_return fail(
            Fault::LinkLost, say("openocd is not installed"), say("install it with"), "sudo apt install openocd");
    if (auto started = openocd.start(openocd::commandOf(job)); !started)
        co_return fail(started.error());
    openocd::Reading reading;
    const int total = static_cast<int>(Stage::Over);
    for (;;) {
        progress.step(titleOf(reading.stage()), static_cast<int>(reading.stage()), total);
        const auto piece = co_await openocd.next(patience);
        if (!piece)
            co_return fail(piece.error().fault, say("OpenOCD said nothing for a minute and was ended"),
                say("check the probe and try again"));
        if (!*piece)
            break;
        if (!(*piece)->complete)
            continue;
        const Stage before = reading.stage();
        reading.take((*piece)->text);
        if (reading.stage() != before && reading.stage() == Stage::Writing)
            mark(PartState::Active);
        if (reading.stage() != before && reading.stage() == Stage::Verifying)
            mark(PartState::Done);
        progress.log(Severity::Info, Message::verbatim((*piece)->text));
    }
    if (!openocd.exit().isSuccess() || !reading.isVerified())
        co_return fail(reading.failure(job));
    co_return reading;
}

/// The drive starts again with the power stage off; its answer is the second half of the proof.
Task<bool> answers(Device &device)
{
    for (int attempt = 0; attempt < answerTries; ++attempt) {
        co_await Sleep(device.clock(), answerEvery);
        auto asking = device.refresh();
        const Result<void> answer = co_await std::move(asking).attempt();
        if (answer)
            co_return true;
        if (answer.error().fault == Fault::LinkLost)
            co_return fail(answer.error());
    }
    co_return false;
}

Result<void> preflight(const Device &device, const FirmwareImage &image, const UpdateOptions &options)
{
    if (auto summary = inspect(image); !summary)
        return fail(summary.error());
    if (device.liveness().moving)
        return fail(Fault::Unsafe, say("its motor moves"), say("stop it first"));
    if (options.eraseSettings && touchesSettings(image))
        return fail(
            Fault::OutOfRange, say("the image itself writes the settings pages"), say("leave out erasing them"));
    return {};
}

} // namespace

std::string toIntelHex(const FirmwareImage &image)
{
    std::string text;
    for (const FirmwareImage::Segment &segment : image.segments()) {
        std::span<const std::uint8_t> rest = image.bytes(segment);
        std::uint32_t address = segment.first;
        while (!rest.empty()) {
            const std::size_t size = std::min<std::size_t>({rest.size(), 16, 0x10000U - (address & 0xFFFFU)});
            const std::array upper{
                static_cast<std::uint8_t>(address >> 24U), static_cast<std::uint8_t>((address >> 16U) & 0xFFU)};
            if (address == segment.first || (address & 0xFFFFU) == 0)
                text += hexLine(0, 4, upper);
            text += hexLine(address & 0xFFFFU, 0, rest.first(size));
            rest = rest.subspan(size);
            address += static_cast<std::uint32_t>(size);
        }
    }
    return text + ":00000001FF\n";
}

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
    auto job = openocd::jobOf(options.via, options.target);
    if (!job)
        co_return fail(job.error());
    if (auto ready = preflight(device, image, options); !ready)
        co_return fail(ready.error());
    const auto summary = inspect(image);
    UpdateReport report;
    if (options.dryRun) {
        report.outcome = UpdateOutcome::Done;
        report.evidence = say("nothing was written; the image fits, %1 pages", summary->parts.size());
        co_return report;
    }
    const auto file = written(image);
    if (!file)
        co_return fail(file.error());
    job->file = (*file)->fileName().toStdString();
    job->eraseSettings = options.eraseSettings;
    if (options.eraseSettings)
        progress.log(Severity::Caution,
            say("the gains stored in the drive are erased; all its loops do nothing until they are written again"));
    device.stop();
    auto programming = program(device.clock(), *job, summary->parts, progress);
    const openocd::Reading reading = co_await std::move(programming);
    progress.step(titleOf(Stage::Over), static_cast<int>(Stage::Over), static_cast<int>(Stage::Over));
    if (reading.isErased())
        static_cast<Controller &>(device).settingsErased();
    auto asking = answers(device);
    const bool answered = co_await std::move(asking);
    report.pages = static_cast<int>(summary->parts.size());
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
