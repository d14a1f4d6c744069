// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/servicedesk.h"

#include "app/console/notebook.h"
#include "app/folders/account.h"
#include "app/folders/userfolders.h"
#include "async/sleep.h"

namespace mb::console {
namespace {

using namespace std::chrono_literals;

constexpr Duration warning = 3s;

std::string envelopeText(const Envelope &limits)
{
    std::string text;
    for (const EnvelopeBound &bound : envelopeBounds) {
        if (const auto value = limits.*bound.value)
            text += ", " + std::string(bound.key) + " up to " + numberText(*value);
    }
    return text;
}

} // namespace

ServiceDesk::ServiceDesk(Console &console, std::unique_ptr<Database> database, const std::string &station)
    : m_console(console)
    , m_database(std::move(database))
    , m_book(*m_database, console.clock(), station, accountName())
    , m_settings(*m_database, console.clock(), accountName())
    , m_trials(*m_database, console.clock())
{
}

Result<std::unique_ptr<ServiceDesk>> ServiceDesk::open(
    Console &console, const std::string &station, const std::string &url)
{
    std::optional<JournalServer> server;
    if (!url.empty()) {
        MB_TRY(auto parsed, JournalServer::parse(url));
        server = std::move(parsed);
    }
    MB_TRY(auto opened, openNotebook());
    if (opened->isReadOnly())
        return fail(Fault::OutOfRange, say("%1 cannot be written, so nothing would be in the journal", databaseFile()),
            say("check the rights of the file and its folder"));
    std::unique_ptr<ServiceDesk> desk(new ServiceDesk(console, std::move(opened), station));
    if (server)
        desk->share(std::move(*server));
    return desk;
}

void ServiceDesk::share(JournalServer server)
{
    m_workers = std::make_unique<WorkerThreads>(m_mailbox);
    m_mail = std::make_unique<QSocketNotifier>(m_mailbox.descriptor(), QSocketNotifier::Read);
    QObject::connect(m_mail.get(), &QSocketNotifier::activated, m_mail.get(), [this] { m_mailbox.drain(); });
    m_shared = std::make_unique<SharedJournal>(m_book, std::move(server), m_console.clock(), m_workers.get());
}

service::ServiceJournal &ServiceDesk::journal()
{
    if (m_shared)
        return *m_shared;
    return m_book;
}

Task<void> ServiceDesk::handOver()
{
    if (!m_shared)
        co_return {};
    const Result<void> delivered = co_await m_shared->deliver().attempt();
    if (!delivered)
        m_console.note(
            std::to_string(m_shared->waiting()) + " entries wait on this computer: " + delivered.error().text());
    co_return {};
}

Task<void> SpokenPermit::beforeMotion(const Device &device, const service::SelfTest &test, Progress &)
{
    m_console.note(device.selector() + ": the motor turns" + (device.link().address().isSimulated() ? "" : " in 3 s")
        + ": " + std::string(toString(test.loop)) + " to " + numberText(test.to) + ' ' + std::string(unitOf(test.loop))
        + envelopeText(test.limits));
    if (!device.link().address().isSimulated())
        co_await Sleep(device.clock(), warning);
    co_return {};
}

} // namespace mb::console
