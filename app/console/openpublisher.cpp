// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/openpublisher.h"

#include "app/console/mqttpublisher.h"
#include "app/console/udppublisher.h"
#include "async/mailbox.h"
#include "async/sleep.h"
#include "transport/workerthreads.h"

#include <QSocketNotifier>

namespace mb::console {
namespace {

constexpr Duration usualLimit = std::chrono::seconds(5);

using Opened = std::unique_ptr<Publisher>;

Result<Opened> open(const PublishAddress &address, Duration limit)
{
    if (address.scheme == "udp")
        return UdpPublisher::open(address);
    return MqttPublisher::open(address, limit);
}

} // namespace

Task<Opened> openPublisher(Console &console, PublishAddress address)
{
    const Duration limit = console.options().patience.timeout.value_or(usualLimit);
    Mailbox mail;
    QSocketNotifier arrival(mail.descriptor(), QSocketNotifier::Read);
    QObject::connect(&arrival, &QSocketNotifier::activated, &arrival, [&mail] { mail.drain(); });
    WorkerThreads worker(mail, std::chrono::milliseconds(0)); // what hangs there has nothing to lose
    auto opening = inBackground<Opened>(
        worker, console.clock(), address.scheme, limit, [address, limit] { return open(address, limit); },
        WhenLate::Drop);
    Result<Opened> opened = co_await std::move(opening).attempt();
    co_await Sleep(console.clock(), Duration::zero());
    if (!opened && opened.error().fault == Fault::Timeout)
        co_return fail(silence(address));
    if (!opened)
        co_return fail(opened.error());
    co_return std::move(*opened);
}

} // namespace mb::console
