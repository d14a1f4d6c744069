// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/updater.h"

#include "model/linkreturn.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr int mostRestarts = 3;
constexpr Duration findLimit = 5s;
constexpr auto linkPatience = 30s;
constexpr int mostLosses = 3;

Message insteadOf(std::uint16_t wanted, const Message &answer, bool bootloader)
{
    return bootloader ? say("%1 in its bootloader instead of %2", answer, versionText(wanted))
                      : say("%1 instead of %2", answer, versionText(wanted));
}

} // namespace

Updater::Updater(Device &device, const Application &application, Progress &progress)
    : m_device(device)
    , m_application(application)
    , m_progress(progress)
    , m_contact(device)
    , m_pages(m_contact, application, progress)
{
}

UpdateReport Updater::failed(const Error &error) const
{
    UpdateReport report = m_report;
    report.pages = m_pages.pages();
    report.retries = m_pages.retries();
    report.fault = error.fault;
    report.outcome = m_pages.hasTouched() ? UpdateOutcome::Failed
        : error.fault == Fault::Unsafe    ? UpdateOutcome::Refused
                                          : UpdateOutcome::Failed;
    report.evidence = error.detail;
    report.remedy = error.help();
    if (m_pages.hasTouched() && m_inBootloader)
        report.remedy = joined(report.remedy, say("the unit waits in its bootloader, run the update again"));
    else if (m_entered && m_inBootloader)
        report.remedy = joined(report.remedy, say("restart the unit: its old firmware is still there"));
    return report;
}

Task<UpdateReport> Updater::run(UpdateOptions options)
{
    const Result<void> checked = co_await preflight(options).attempt();
    if (!checked)
        co_return failed(checked.error());
    if (m_upToDate) {
        m_report.outcome = UpdateOutcome::UpToDate;
        m_report.to = m_report.from;
        m_report.verified = true;
        m_report.evidence = say("the device already runs %1", m_report.to);
        co_return m_report;
    }
    if (options.dryRun) {
        m_report.outcome = UpdateOutcome::Done;
        m_report.evidence = say("dry run: %1 pages would be written, version %2", m_application.pages.size(),
            versionText(m_application.version));
        co_return m_report;
    }
    if (m_runs) {
        if (const Result<void> kept = co_await keepParameters().attempt(); !kept)
            co_return failed(kept.error());
    }
    const Result<void> installed = co_await install().attempt();
    if (!installed) {
        (void)co_await giveBack().attempt();
        co_return failed(installed.error());
    }
    m_report.pages = m_pages.pages();
    m_report.retries = m_pages.retries();
    m_report.outcome = UpdateOutcome::Done;
    m_report.verified = true;
    m_report.evidence = say("the device answers with version %1", m_report.to);
    m_progress.log(Severity::Good, m_report.evidence);
    co_return m_report;
}

Task<void> Updater::preflight(UpdateOptions options)
{
    for (const Message &note : m_application.notes)
        m_progress.log(Severity::Info, note);
    m_progress.step(say("Preflight"), 0, 0);
    if (!options.dryRun)
        m_device.stop();
    const UpdateContact::Unit unit = co_await m_contact.findAgain(1s);
    if (unit.productId && (*unit.productId >> 20U) != productDmc60c)
        co_return fail(Fault::Unsafe,
            say("the image is for product 602, this unit is product %1%2%3", *unit.productId >> 28U,
                (*unit.productId >> 24U) & 0xFU, (*unit.productId >> 20U) & 0xFU),
            say("nothing was written"));
    const FirmwareVersions now = co_await m_contact.versions();
    m_report.from = versionText(now.application);
    m_progress.replaces(m_report.from);
    const std::string version = versionText(m_application.version);
    const std::size_t pages = m_application.pages.size();
    const std::string bootloader = versionText(now.bootloader);
    m_progress.log(Severity::Good,
        m_report.from.empty()
            ? say("image %1 of %2 pages, unit without application, bootloader %3", version, pages, bootloader)
            : say("image %1 of %2 pages, unit runs %3, bootloader %4", version, pages, m_report.from, bootloader));
    m_inBootloader = isInBootloader(now);
    m_runs = !m_inBootloader;
    m_upToDate = !options.force && !isInBootloader(now) && now.application == m_application.version;
    for (int number = lastPage; number >= firstPage; --number)
        m_progress.part(number, PartState::Absent);
    for (const Page &page : m_application.pages)
        m_progress.part(page.number, PartState::Waiting);
    co_return {};
}

/// The device writes its flash up to 15 s after a change. What this program has changed is waited for; what others have, nobody knows.
Task<void> Updater::keepParameters()
{
    const auto entries = m_device.parameters().entries();
    if (!inRam(entries).empty()) {
        const Result<bool> stored = co_await m_device.store(m_progress).attempt();
        if (!stored && stored.error().fault == Fault::LinkLost)
            co_return fail(stored.error());
        if (!stored)
            m_progress.log(
                Severity::Caution, say("parameters that were changed last may be lost: %1", stored.error().detail));
    }
    m_progress.log(Severity::Info,
        say("what another program has changed within the last 15 s is not in the flash of the unit yet, and is lost "
            "with the restart"));
    co_return {};
}

Task<void> Updater::enterBootloader()
{
    m_progress.step(say("Enter bootloader"), 0, static_cast<int>(m_application.pages.size()));
    const VendorReply reply = co_await m_contact.order(Command::EnterBootloader);
    co_await check(Command::EnterBootloader, reply);
    m_entered = m_entered || !m_inBootloader;
    m_inBootloader = true;
    const FirmwareVersions now = co_await m_contact.versions();
    if (!isInBootloader(now))
        co_return fail(Fault::BadReply, say("the unit said it is in its bootloader, but its application answers"));
    m_progress.log(Severity::Good, say("in bootloader %1, session kept", versionText(now.bootloader)));
    co_return {};
}

Task<void> Updater::install()
{
    for (;;) {
        const Result<void> done = co_await installOnce().attempt();
        if (done || done.error().fault != Fault::LinkLost || m_losses >= mostLosses)
            co_return done;
        ++m_losses;
        co_await awaitLink(done.error());
    }
}

Task<void> Updater::installOnce()
{
    if (m_losses > 0)
        co_await lookAgain();
    if (!m_isWritten) {
        co_await writeAll();
        m_isWritten = true;
    }
    if (!m_isLeft)
        co_await leaveBootloader();
    co_await verify();
    co_return {};
}

Task<void> Updater::awaitLink(Error lost)
{
    const std::string name = m_contact.link().address().shortName();
    const std::string limit = std::to_string(linkPatience.count()) + " s";
    m_progress.log(
        Severity::Caution, say("%1 is lost: %2; waiting up to %3 for it to come back", name, lost.message(), limit));
    m_progress.step(say("Wait for %1", name), m_pages.pages(), static_cast<int>(m_application.pages.size()));
    const Result<void> back = co_await linkReturn(m_contact.link(), m_contact.clock(), linkPatience).attempt();
    if (!back)
        co_return fail(back.error().about(say("%1 did not come back within %2", name, limit)));
    m_progress.log(Severity::Info, say("%1 is back", name));
    co_return {};
}

/// Page 30 erased the version and page 0 brings it, so that a unit that has it has all pages.
Task<void> Updater::lookAgain()
{
    co_await m_contact.findAgain(findLimit);
    const FirmwareVersions now = co_await m_contact.versions();
    m_isWritten = m_pages.hasSentLast() && now.application == m_application.version;
    m_inBootloader = isInBootloader(now);
    m_isLeft = m_isWritten && !m_inBootloader;
    if (m_isWritten) {
        m_progress.log(Severity::Info, say("all pages are in the unit"));
        co_return {};
    }
    m_progress.log(Severity::Caution, say("the unit may have restarted meanwhile: once more from page %1", lastPage));
    for (const Page &page : m_application.pages)
        m_progress.part(page.number, PartState::Waiting);
    co_return {};
}

Task<void> Updater::writeAll()
{
    for (;;) {
        co_await enterBootloader();
        const PageWriter::End end = co_await m_pages.writeAll();
        if (end == PageWriter::End::Written)
            co_return {};
        if (++m_restarts > mostRestarts)
            co_return fail(Fault::Refused, say("the device restarted %1 times during the update", m_restarts));
        m_progress.log(Severity::Caution, say("the device may have restarted: once more from page %1", lastPage));
        co_await m_contact.findAgain(findLimit);
    }
}

Task<void> Updater::leaveBootloader()
{
    const int total = static_cast<int>(m_application.pages.size());
    m_progress.step(say("Restart"), total, total);
    auto resetting = m_contact.send({Command::SoftReset}, {}, Attempts{1, 3s}, {});
    const Result<VendorReply> reply = co_await std::move(resetting).attempt();
    if (reply) {
        co_await check(Command::SoftReset, *reply);
        m_inBootloader = false;
        m_progress.log(Severity::Good, say("restarted, the application answers"));
        co_return {};
    }
    if (reply.error().fault != Fault::Timeout)
        co_return fail(reply.error());
    const UpdateContact::Unit unit = co_await m_contact.findAgain(findLimit);
    m_inBootloader = !unit.versions || isInBootloader(*unit.versions);
    m_progress.log(Severity::Caution, say("the answer to the reset was lost; found again by enumeration"));
    co_return {};
}

Task<void> Updater::giveBack()
{
    if (!m_entered || !m_inBootloader || m_pages.hasTouched())
        co_return {};
    co_await leaveBootloader();
    co_return {};
}

Task<void> Updater::verify()
{
    FirmwareVersions now = co_await m_contact.versions();
    if (isInBootloader(now) && now.application == m_application.version) {
        auto leaving = leaveBootloader(); // the reset itself was lost
        co_await std::move(leaving);
        now = co_await m_contact.versions();
    }
    m_inBootloader = isInBootloader(now);
    if (m_inBootloader || now.application != m_application.version)
        co_return fail(Fault::BadCheck,
            insteadOf(m_application.version,
                now.application == noApplication
                    ? say("the device answers with no application")
                    : say("the device answers with version %1", versionText(now.application)),
                isInBootloader(now)));
    m_report.to = versionText(now.application);
    Identity identity = m_device.identity();
    identity.state = identity.address == 0 ? DeviceState::Unassigned : DeviceState::Online;
    identity.firmware = m_report.to;
    identity.bootloader = versionText(now.bootloader);
    identity.detail = {};
    m_device.setIdentity(std::move(identity));
    co_return {};
}

} // namespace mb::dmc60c
