// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/firmware.h"

#include "async/noncopyable.h"
#include "families/supermodified/avrdude.h"
#include "families/supermodified/controller.h"
#include "firmware/programmer.h"
#include "model/answersagain.h"

#include <QFileInfo>
#include <QTemporaryFile>

#include <memory>

namespace mb::supermodified {
namespace {

using avrdude::Stage;

constexpr std::uint32_t pageSize = 128;

/// The first instruction is a jump of an AVR.
bool hasVectors(const FirmwareImage &image)
{
    const auto low = image.at(0);
    const auto high = image.at(1);
    if (!low || !high)
        return false;
    const bool jmp = (*low & 0xFEU) == 0x0CU && *high == 0x94U;
    const bool rjmp = (*high & 0xF0U) == 0xC0U;
    return jmp || rjmp;
}

/// The port is that of the device's own line.
bool isOwn(const Device &device, const std::string &port)
{
    const QString own = QFileInfo(QString::fromStdString(device.link().address().path)).canonicalFilePath();
    return !own.isEmpty() && own == QFileInfo(QString::fromStdString(port)).canonicalFilePath();
}

/// Lets the port go while avrdude has it. What opens lost links opens it again where the update is given up, or the port cannot be
/// opened yet: an adapter may be away for a moment.
class PortLease : NonCopyable {
public:
    PortLease(Controller &device, const std::string &port)
        : m_device(device)
        , m_link(device.link())
        , m_shared(isOwn(device, port))
    {
        m_device.setAsleep(true);
        if (m_shared)
            m_link.close();
    }
    ~PortLease()
    {
        if (m_ended)
            return;
        m_device.setAsleep(false);
        if (m_shared)
            m_link.closedFor(say("avrdude had the port"));
    }

    Task<void> end()
    {
        Result<void> opened;
        if (m_shared) {
            opened = co_await m_link.openSoon().attempt();
        }
        m_ended = true;
        m_device.setAsleep(false);
        if (!opened && opened.error().fault != Fault::Cancelled)
            m_link.closedFor(opened.error().detail);
        co_return opened;
    }

private:
    Controller &m_device;
    Link &m_link;
    bool m_shared;
    bool m_ended = false;
};

void show(const avrdude::Reading &reading, Progress &progress)
{
    progress.step(titleOf(reading.stage()), 100 * static_cast<int>(reading.stage()) + reading.percent(),
        100 * (static_cast<int>(Stage::Verifying) + 1));
    progress.mayInterrupt(reading.stage() == Stage::Connecting);
}

/// One run of avrdude that came to its end.
struct Attempt {
    avrdude::Reading reading;
    std::optional<Error> error; ///< of one that failed
    bool hasBegun = false;      ///< to write, so that it is not simply tried again
};

/// What was read of the controller is not known any more once its memory is written, however that ends.
Task<Attempt> runOnce(Controller &device, avrdude::Job job, Progress &progress)
{
    avrdude::Reading reading;
    HeldDevice held(device);
    const auto take = [&](const ExternalProgram::Piece &piece) {
        const bool had = reading.hasBegun();
        reading.take(piece.text, piece.complete);
        if (reading.hasBegun() && !had) {
            device.parameters().forgetAll();
            if (device.link().state() == LinkState::Open) // else avrdude has it
                held.hold([] {});
        }
        if (reading.isVerified())
            held.release();
        show(reading, progress);
    };
    show(reading, progress);
    auto running
        = runProgrammer(device.clock(), avrdude::commandOf(job), say("check the cables and try again"), take, progress);
    const Result<ExternalProgram::Exit> exit = co_await std::move(running).attempt();
    held.release();
    if (exit && exit->isSuccess() && reading.isVerified())
        co_return Attempt{
            std::move(reading), held.hasAnswered() ? std::optional(anotherUnit(device)) : std::nullopt, true};
    Error error = exit ? reading.failure(job) : exit.error();
    if (reading.hasBegun())
        error.remedy = joined(
            error.remedy, say("the controller may hold half a program, and runs again once an update has succeeded"));
    const bool hasBegun = reading.hasBegun();
    co_return Attempt{{}, std::move(error), hasBegun};
}

/// The bootloader is asked at both of its rates.
Task<avrdude::Reading> program(Controller &device, avrdude::Job job, Progress &progress)
{
    if (!ExternalProgram::locate("avrdude"))
        co_return fail(
            Fault::LinkLost, say("avrdude is not installed"), say("install it with"), "sudo apt install avrdude");
    if (!job.isBootloader()) {
        Attempt attempt = co_await runOnce(device, job, progress);
        if (attempt.error)
            co_return fail(*attempt.error);
        co_return std::move(attempt.reading);
    }
    Error last{Fault::Timeout, say("no bootloader answers")};
    for (const int rate : avrdude::bootloaderRates) {
        job.rate = rate;
        Attempt attempt = co_await runOnce(device, job, progress);
        if (!attempt.error)
            co_return std::move(attempt.reading);
        last = *attempt.error;
        if (last.fault != Fault::Timeout || attempt.hasBegun)
            break;
        progress.log(Severity::Caution, say("no bootloader answers at %1 bit/s", rate));
    }
    co_return fail(last);
}

Result<void> preflight(const Controller &device, const FirmwareImage &image, const avrdude::Job &job)
{
    MB_TRY_VOID(inspect(image));
    if (job.isBootloader() && image.hasAny(avrdude::bootloaderStart, avrdude::flashSize - 1))
        return fail(Fault::OutOfRange, say("this image holds a bootloader too, which cannot write itself"),
            say("use a programmer on the pins"));
    if (const auto other = device.neighbour(); other && job.isBootloader() && isOwn(device, job.port))
        return fail(Fault::Unsafe,
            say("node %1 is on this line, too: it hears what the bootloader is told, and may be the one that is "
                "written",
                *other),
            say("take all others off the line and scan it, or use a programmer on the pins"));
    if (device.isLineDriving())
        return fail(Fault::Unsafe, say("a motor is driven on this line"), say("stop it first"));
    return {};
}

UpdateReport reportOf(const Device &device, const FirmwareImage &image, bool answered)
{
    UpdateReport report;
    report.pages = static_cast<int>(inspect(image)->parts.size());
    report.verified = answered;
    report.outcome = answered ? UpdateOutcome::Done : UpdateOutcome::Failed;
    if (answered) {
        report.evidence
            = say("avrdude read back all %1 bytes and they are equal; the controller answers again, dialect %2",
                image.byteCount(), device.identity().dialect);
    } else {
        report.fault = Fault::Timeout;
        report.evidence
            = say("avrdude read back all %1 bytes and they are equal, but the controller does not answer; cut its "
                  "power for a moment, and scan: a new firmware may have another rate or node id",
                image.byteCount());
    }
    return report;
}

} // namespace

Result<ImageSummary> inspect(const FirmwareImage &image)
{
    if (image.segments().empty() || image.segments().back().last >= avrdude::flashSize)
        return fail(Fault::OutOfRange,
            say("this is no program for the controller: it has bytes outside the 32 KiB of an ATmega328P"));
    if (!hasVectors(image))
        return fail(Fault::OutOfRange,
            say("this is no program for the controller: it does not begin with a jump of an AVR at address 0"));
    ImageSummary summary;
    for (std::uint32_t page = 0; page < avrdude::flashSize; page += pageSize) {
        if (image.hasAny(page, page + pageSize - 1))
            summary.parts.push_back(static_cast<int>(page / pageSize));
    }
    summary.notes.emplace_back(say(
        "The controller tells no version: the programmer's own verify and the controller's answer prove the update."));
    summary.notes.emplace_back(say("A programmer on the pins erases the chip first, the stored settings and the serial "
                                   "bootloader with it: save the parameters before. The bootloader keeps both."));
    summary.notes.emplace_back(say("The serial bootloader listens for a moment after power-up only: restart the "
                                   "controller when the update begins."));
    if (image.hasAny(avrdude::bootloaderStart, avrdude::flashSize - 1))
        summary.notes.emplace_back(say("The image holds a bootloader too, so it needs a programmer on the pins."));
    return summary;
}

Task<UpdateReport> update(Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress)
{
    auto &controller = static_cast<Controller &>(device);
    auto job = co_await avrdude::jobOf(options.via);
    if (!options.target.empty())
        co_return fail(
            Fault::OutOfRange, say("a Supermodified has one kind of microcontroller"), say("leave out --target"));
    co_await preflight(controller, image, job);
    if (options.dryRun) {
        UpdateReport report;
        report.outcome = UpdateOutcome::Done;
        report.evidence = say("dry run: %1 pages would be written", inspect(image)->parts.size());
        co_return report;
    }
    const auto file = co_await hexFileFor(image, "avrdude");
    job.file = file->fileName().toStdString();
    PortLease lease(controller, job.port);
    const auto programmed = co_await program(controller, job, progress).attempt();
    const auto opened = co_await lease.end().attempt();
    if (!programmed)
        co_return fail(programmed.error());
    progress.accepted(static_cast<int>(inspect(image)->parts.size()), 0);
    if (!opened)
        co_return fail(opened.error().about(
            say("avrdude read back all %1 bytes and they are equal, but the port is away", image.byteCount())));
    progress.step(say("Looking for the controller"), 1, 1);
    progress.mayInterrupt(true);
    const bool answered = co_await answersAgain(device);
    co_return reportOf(device, image, answered);
}

} // namespace mb::supermodified
