// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/firmware.h"

#include "families/supermodified/avrdude.h"
#include "families/supermodified/controller.h"
#include "model/programmer.h"

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

/// Lets the port go while avrdude has it. What opens lost links opens it again where the update is given up.
class PortLease {
public:
    PortLease(Controller &device, const std::string &port)
        : m_device(device)
        , m_link(device.link())
        , m_shared(isSame(device.link().address().path, port))
    {
        m_device.setAsleep(true);
        if (m_shared)
            m_link.close();
    }
    PortLease(const PortLease &) = delete;
    PortLease &operator=(const PortLease &) = delete;
    ~PortLease()
    {
        if (m_ended)
            return;
        m_device.setAsleep(false);
        if (m_shared)
            m_link.closedFor("avrdude had the port");
    }

    Task<void> end()
    {
        m_ended = true;
        m_device.setAsleep(false);
        if (m_shared) {
            auto opening = m_link.openSoon();
            co_await std::move(opening);
        }
        co_return {};
    }

private:
    static bool isSame(const std::string &path, const std::string &port)
    {
        const QString one = QFileInfo(QString::fromStdString(path)).canonicalFilePath();
        return !one.isEmpty() && one == QFileInfo(QString::fromStdString(port)).canonicalFilePath();
    }
    Controller &m_device;
    Link &m_link;
    bool m_shared;
    bool m_ended = false;
};

void show(const avrdude::Reading &reading, Progress &progress)
{
    progress.step(std::string(titleOf(reading.stage())), 100 * static_cast<int>(reading.stage()) + reading.percent(),
        100 * (static_cast<int>(Stage::Verifying) + 1));
    progress.mayInterrupt(reading.stage() == Stage::Connecting);
}

/// Runs avrdude to its end.
Task<avrdude::Reading> runOnce(Clock &clock, avrdude::Job job, Progress &progress)
{
    avrdude::Reading reading;
    const auto take = [&reading, &progress](const ExternalProgram::Piece &piece) {
        reading.take(piece.text, piece.complete);
        show(reading, progress);
    };
    show(reading, progress);
    auto running = runProgrammer(clock, avrdude::commandOf(job), "check the cables and try again", take, progress);
    const ExternalProgram::Exit exit = co_await std::move(running);
    if (exit.isSuccess() && reading.isVerified())
        co_return reading;
    Error error = reading.failure(job);
    if (reading.hasBegun())
        error.remedy += (error.remedy.empty() ? std::string() : std::string("; "))
            + "the controller may hold half a program, and runs again once an update has succeeded";
    co_return fail(error);
}

/// The bootloader is asked at both of its rates.
Task<avrdude::Reading> program(Clock &clock, avrdude::Job job, Progress &progress)
{
    if (!ExternalProgram::locate("avrdude"))
        co_return fail(Fault::LinkLost, "avrdude is not installed", "install it with: sudo apt install avrdude");
    if (!job.isBootloader()) {
        auto run = runOnce(clock, job, progress);
        co_return co_await std::move(run).attempt();
    }
    Error last{Fault::Timeout, "no bootloader answers"};
    for (const int rate : avrdude::bootloaderRates) {
        job.rate = rate;
        auto run = runOnce(clock, job, progress);
        Result<avrdude::Reading> reading = co_await std::move(run).attempt();
        if (reading)
            co_return std::move(*reading);
        last = reading.error();
        if (last.fault != Fault::Timeout || last.remedy.find("half a program") != std::string::npos)
            break;
        progress.log(Severity::Caution, "no bootloader answers at " + std::to_string(rate) + " bit/s");
    }
    co_return fail(last);
}

Result<void> preflight(const Controller &device, const FirmwareImage &image, const avrdude::Job &job)
{
    if (auto summary = inspect(image); !summary)
        return fail(summary.error());
    if (job.isBootloader() && image.hasAny(avrdude::bootloaderStart, avrdude::flashSize - 1))
        return fail(Fault::OutOfRange, "this image holds a bootloader too, which cannot write itself",
            "use a programmer on the pins");
    if (device.isLineDriving())
        return fail(Fault::Unsafe, "a motor is driven on this line", "stop it first");
    return {};
}

UpdateReport reportOf(const Device &device, const FirmwareImage &image, bool answered)
{
    UpdateReport report;
    const std::string proof
        = "avrdude read back all " + std::to_string(image.byteCount()) + " bytes and they are equal";
    report.pages = static_cast<int>(inspect(image)->parts.size());
    report.verified = answered;
    report.outcome = answered ? UpdateOutcome::Done : UpdateOutcome::Failed;
    if (answered) {
        report.evidence = proof + "; the controller answers again, dialect " + device.identity().dialect;
    } else {
        report.fault = Fault::Timeout;
        report.evidence = proof
            + ", but the controller does not answer; cut its power for a moment, and scan: a new firmware may have "
              "another rate or node id";
    }
    return report;
}

} // namespace

Result<ImageSummary> inspect(const FirmwareImage &image)
{
    if (image.segments().empty() || image.segments().back().last >= avrdude::flashSize)
        return fail(Fault::OutOfRange,
            "this is no program for the controller: it has bytes outside the 32 KiB of an ATmega328P");
    if (!hasVectors(image))
        return fail(Fault::OutOfRange,
            "this is no program for the controller: it does not begin with a jump of an AVR at address 0");
    ImageSummary summary;
    for (std::uint32_t page = 0; page < avrdude::flashSize; page += pageSize) {
        if (image.hasAny(page, page + pageSize - 1))
            summary.parts.push_back(static_cast<int>(page / pageSize));
    }
    summary.notes.emplace_back(
        "The controller tells no version: the programmer's own verify and the controller's answer prove the update.");
    summary.notes.emplace_back("A programmer on the pins erases the chip first, the stored settings and the serial "
                               "bootloader with it: save the parameters before. The bootloader keeps both.");
    summary.notes.emplace_back("The serial bootloader listens for a moment after power-up only: restart the controller "
                               "when the update begins.");
    if (image.hasAny(avrdude::bootloaderStart, avrdude::flashSize - 1))
        summary.notes.emplace_back("The image holds a bootloader too, so it needs a programmer on the pins.");
    return summary;
}

Task<UpdateReport> update(Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress)
{
    auto &controller = static_cast<Controller &>(device);
    auto job = avrdude::jobOf(options.via);
    if (!job)
        co_return fail(job.error());
    if (!options.target.empty())
        co_return fail(Fault::OutOfRange, "a Supermodified has one kind of microcontroller", "leave out --target");
    if (auto ready = preflight(controller, image, *job); !ready)
        co_return fail(ready.error());
    if (options.dryRun) {
        UpdateReport report;
        report.outcome = UpdateOutcome::Done;
        report.evidence = "dry run: " + std::to_string(inspect(image)->parts.size()) + " pages would be written";
        co_return report;
    }
    const auto file = hexFileFor(image, "avrdude");
    if (!file)
        co_return fail(file.error());
    job->file = (*file)->fileName().toStdString();
    PortLease lease(controller, job->port);
    auto programming = program(device.clock(), *job, progress);
    const auto programmed = co_await std::move(programming).attempt();
    auto ending = lease.end();
    const auto opened = co_await std::move(ending).attempt();
    if (!programmed)
        co_return fail(programmed.error());
    if (!opened)
        co_return fail(opened.error());
    progress.step("Looking for the controller", 1, 1);
    progress.mayInterrupt(true);
    auto asking = answersAgain(device);
    const bool answered = co_await std::move(asking);
    co_return reportOf(device, image, answered);
}

} // namespace mb::supermodified
