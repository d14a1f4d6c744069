// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/ending.h"
#include "app/console/framelines.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "wire/bytelog.h"

#include <memory>

namespace mb::console {
namespace {

struct MonitorArguments {
    std::string link;
    std::string seconds;
    std::string dialect;
};

std::string trafficLine(Duration time, std::string_view link, const Traffic &traffic)
{
    if (traffic.can)
        return toCandumpLine(time, link, *traffic.can);
    const auto direction = traffic.direction == Direction::Sent ? LogDirection::Sent : LogDirection::Received;
    return toByteLine(time, link, direction, traffic.bytes);
}

Task<int> monitor(Console &console, MonitorArguments arguments)
{
    const auto links = parseLinks(console, {arguments.link});
    if (!links)
        co_return fail(links.error());
    const auto time = co_await parseSpan(arguments.seconds);
    co_await checkDialect(console, arguments.dialect);
    if (links->size() != 1)
        co_return fail(Fault::Usage, say("'%1' stands for several links", arguments.link),
            say("name one, such as %1", links->front().text()));
    const auto link = co_await console.session().openLink(links->front());
    Ending ending(console);
    ending.watch(*link);
    ending.after(time);
    FrameLines lines(console, arguments.dialect, link->kind());
    const TimeOrigin base(console.session().clockOf(*link), link->address());
    const std::string name = link->address().shortName();
    bool isSilent = true;
    const Subscription tap = link->traffic().add([&](const Traffic &traffic) {
        isSilent = false;
        const Duration stamp = base.of(traffic.time);
        if (console.json() && traffic.can)
            lines.print(stamp, name, *traffic.can);
        else if (console.json())
            lines.print(stamp, name, traffic.direction, traffic.bytes);
        else
            console.out().line(trafficLine(stamp, name, traffic));
    });
    co_await ending.wait();
    link->catchUp();
    lines.finish();
    link->recount();
    if (isSilent)
        console.note("nothing was heard on " + link->address().text()
            + (link->address().isSimulated() ? "; units on a simulated link speak when this program asks them" : ""));
    if (const std::uint64_t lost = link->counters().lost; lost > 0)
        console.note(std::to_string(lost) + (link->kind() == LinkKind::Can ? " frames" : " bytes")
            + " were lost on the way from the kernel");
    if (ending.cause() == Ending::Cause::LinkLost)
        co_return fail(ending.loss());
    co_return exitDone;
}

} // namespace

Job declareMonitor(CLI::App &arguments)
{
    const auto a = std::make_shared<MonitorArguments>();
    arguments.add_option("link", a->link, "Such as socketcan:can0")->required();
    arguments.add_option("--for", a->seconds, "Seconds; until a signal otherwise");
    arguments.add_option("--dialect", a->dialect, dialectHelp());
    return [a](Console &console) { return monitor(console, *a); };
}

} // namespace mb::console
