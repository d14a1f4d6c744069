// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/ending.h"
#include "app/console/mqttpublisher.h"
#include "app/console/reopening.h"
#include "app/console/samplestream.h"
#include "app/console/target.h"
#include "app/console/udppublisher.h"
#include "app/console/verb.h"
#include "async/mailbox.h"
#include "async/sleep.h"
#include "transport/workerthreads.h"

#include <QSocketNotifier>

#include <cmath>
#include <memory>

namespace mb::console {
namespace {

constexpr double fastest = 10'000.0; // Hz

struct WatchArguments {
    std::string device;
    std::vector<std::string> channels;
    std::string seconds;
    std::string rate;
    std::string to;
};

struct WatchPlan {
    Target target;
    Watched watched; ///< nothing: all channels
    std::optional<Duration> time;
    double rate = 0.0; ///< 0: as it is
    std::optional<PublishAddress> to{};
};

Result<WatchPlan> check(const Console &console, const WatchArguments &arguments)
{
    MB_TRY(auto target, parseTarget(console, arguments.device));
    MB_TRY(auto watched, parseWatched(*target.family, arguments.channels));
    MB_TRY(const auto time, parseSpan(arguments.seconds));
    WatchPlan plan{std::move(target), std::move(watched), time, 0.0};
    if (!arguments.to.empty()) {
        MB_TRY(auto address, PublishAddress::parse(arguments.to));
        plan.to = std::move(address);
    }
    if (arguments.rate.empty())
        return plan;
    MB_TRY(const auto rate, parseNumber("--rate", arguments.rate, 0.01, fastest));
    plan.rate = rate;
    return plan;
}

/// Asks for a rate of every watched channel; 0 puts it back. Goes on after an error, and yields the first. A channel
/// that nobody named may have no rate: the set-point comes from the host.
Task<std::optional<Error>> setRates(Device &device, Watched watched, double rate)
{
    const std::vector<ChannelIndex> &named = watched.channels;
    std::vector<ChannelIndex> channels = named;
    for (std::size_t i = 0; named.empty() && watched.states.empty() && i < device.family().channels.size(); ++i)
        channels.push_back(ChannelIndex{static_cast<std::uint16_t>(i)});
    std::optional<Error> error;
    for (const ChannelIndex channel : channels) {
        const Result<void> set = co_await device.setRate(channel, rate).attempt();
        const bool excused = !set && named.empty() && set.error().fault == Fault::Unsupported;
        if (!set && !excused && !error)
            error = set.error();
    }
    co_return error;
}

void summarize(Console &console, const SampleStream &samples, const Publisher *publisher, double seconds)
{
    if (publisher && publisher->dropped() > 0)
        console.note(std::to_string(publisher->dropped()) + " samples could not be sent");
    if (console.json()) {
        const QJsonObject summary{
            {QStringLiteral("samples"), static_cast<qint64>(samples.count())},
            {QStringLiteral("lost"), static_cast<qint64>(samples.lost())},
            {QStringLiteral("seconds"), seconds},
        };
        console.out().json({{QStringLiteral("summary"), summary}});
    } else {
        console.note(std::to_string(samples.count()) + " samples, " + std::to_string(samples.lost()) + " lost, in "
            + numberText(seconds) + " s");
    }
}

/// A device, or its line, may have less than was asked for.
void noteRate(Console &console, double asked, std::uint64_t most, double seconds)
{
    const double wanted = asked * seconds;
    if (wanted >= 10.0 && static_cast<double>(most) < 0.9 * wanted)
        console.note("--rate " + numberText(asked) + ": " + numberText(std::round(static_cast<double>(most) / seconds))
            + " samples a second came, of a channel");
}

/// After the link came back: the device may have lost power with it.
Task<void> raiseAgain(Device &device, WatchPlan plan)
{
    if (plan.rate <= 0.0)
        co_return {};
    (void)co_await setRates(device, plan.watched, plan.rate);
    co_return {};
}

/// From the first sample to the summary.
Task<int> stream(Console &console, Device &device, WatchPlan plan, Publisher *publisher, Ending &ending)
{
    std::optional<Error> error;
    {
        const Reopening reopening(console, device.link(), [&device, plan] { return raiseAgain(device, plan); });
        SampleStream samples(console, device, plan.watched, publisher);
        const Instant start = device.clock().now();
        ending.after(plan.time);
        co_await ending.wait();
        if (publisher)
            publisher->finish();
        const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(device.clock().now() - start);
        const double seconds = static_cast<double>(took.count()) / 1000.0;
        if (plan.watched.states.empty() || !plan.watched.channels.empty())
            noteRate(console, plan.rate, samples.most(), seconds);
        summarize(console, samples, publisher, seconds);
    }
    if (ending.cause() == Ending::Cause::LinkLost)
        error = ending.loss();
    else if (device.link().state() == LinkState::Lost)
        error = lossOf(device.link());
    else if (!device.liveness().heard && device.identity().state != DeviceState::Bootloader
        && device.link().address().scheme != "replay")
        error = Error{Fault::Timeout, say("%1 is not heard any more", device.selector()), {}};
    if (plan.rate > 0.0) {
        const std::optional<Error> failed = co_await setRates(device, plan.watched, 0.0);
        const auto told
            = failed ? std::optional(failed->about(say("the device's rate was not put back"))) : std::nullopt;
        if (told && error)
            console.note(told->text());
        else if (told)
            error = told;
    }
    if (error)
        co_return fail(*error);
    co_return exitDone;
}

constexpr Duration usualLimit = std::chrono::seconds(5);

using Published = std::unique_ptr<Publisher>;

Result<Published> openNow(const PublishAddress &address, Duration limit)
{
    if (address.scheme == "udp")
        return UdpPublisher::open(address);
    return MqttPublisher::open(address, limit);
}

/// Resolves the host and, with mqtt, waits for the broker to take us: for --timeout, 5 s without it, in a thread of its own, so that a
/// signal ends the waiting. LinkLost with cause and remedy otherwise.
Task<Published> openPublisher(Console &console, PublishAddress address)
{
    const Duration limit = console.options().patience.timeout.value_or(usualLimit);
    Mailbox mail;
    QSocketNotifier arrival(mail.descriptor(), QSocketNotifier::Read);
    QObject::connect(&arrival, &QSocketNotifier::activated, &arrival, [&mail] { mail.drain(); });
    WorkerThreads worker(mail, std::chrono::milliseconds(0)); // what hangs there has nothing to lose
    auto opening = inBackground<Published>(
        worker, console.clock(), address.scheme, limit, [address, limit] { return openNow(address, limit); },
        WhenLate::Drop);
    Result<Published> opened = co_await std::move(opening).attempt();
    co_await Sleep(console.clock(), Duration::zero());
    if (!opened && opened.error().fault == Fault::Timeout)
        co_return fail(silence(address));
    if (!opened)
        co_return fail(opened.error());
    co_return std::move(*opened);
}

Task<int> watch(Console &console, WatchArguments arguments)
{
    auto plan = co_await check(console, arguments);
    std::unique_ptr<Publisher> publisher;
    if (plan.to) {
        publisher = co_await openPublisher(console, *plan.to);
    }
    Ending ending(console);
    Device *const device = co_await connect(console, plan.target);
    ending.watchPatiently(device->link(), Reopening::mayReturn);
    if (device->identity().state == DeviceState::Bootloader)
        console.note(device->selector() + " waits in its bootloader and sends no samples");
    if (plan.rate > 0.0) {
        const std::optional<Error> failed = co_await setRates(*device, plan.watched, plan.rate);
        if (failed) {
            (void)co_await setRates(*device, plan.watched, 0.0);
            co_return fail(*failed);
        }
    }
    co_return co_await stream(console, *device, plan, publisher.get(), ending);
}

} // namespace

Job declareWatch(CLI::App &arguments)
{
    const auto a = std::make_shared<WatchArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("--channel", a->channels, "Only this channel or state (of info); may be repeated")
        ->allow_extra_args(false);
    arguments.add_option("--for", a->seconds, "Seconds; until a signal otherwise");
    arguments.add_option("--rate", a->rate, "Samples per second; what the device sends otherwise");
    arguments.add_option(
        "--to", a->to, "Send the samples to mqtt://HOST/TOPIC or udp://HOST:PORT instead of printing them");
    return [a](Console &console) { return watch(console, *a); };
}

} // namespace mb::console
