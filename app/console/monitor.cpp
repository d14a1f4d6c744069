// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/ending.h"
#include "app/console/framelines.h"
#include "app/console/target.h"
#include "app/console/verb.h"

#include <memory>

namespace mb::console {
namespace {

struct Arguments {
    std::string link;
    std::string seconds;
};

Task<int> monitor(Console &console, Arguments arguments)
{
    const auto links = parseLinks(console, {arguments.link});
    if (!links)
        co_return fail(links.error());
    const auto time = parseSpan(arguments.seconds);
    if (!time)
        co_return fail(time.error());
    if (links->size() != 1)
        co_return fail(Fault::OutOfRange,
            "'" + arguments.link + "' stands for several links; name one, such as " + links->front().text());
    const auto link = console.session().openLink(links->front());
    if (!link)
        co_return fail(link.error());
    Ending ending(console);
    ending.watch(**link);
    ending.after(*time);
    FrameLines lines(console, {});
    const TimeOrigin base(console.clock(), (*link)->address());
    const std::string name = (*link)->address().shortName();
    const Subscription tap = (*link)->traffic().add([&](const Traffic &traffic) {
        if (!traffic.can)
            return;
        if (console.json())
            lines.print(base.of(traffic.time), name, *traffic.can);
        else
            console.out().line(toCandumpLine(base.of(traffic.time), name, *traffic.can));
    });
    co_await ending.wait();
    (*link)->recount();
    if (const std::uint64_t lost = (*link)->counters().lost; lost > 0)
        console.note(std::to_string(lost) + " frames were lost on the way from the kernel");
    if (ending.cause() == Ending::Cause::LinkLost)
        co_return fail(Fault::LinkLost, ending.reason());
    co_return exitDone;
}

} // namespace

Job declareMonitor(CLI::App &arguments)
{
    const auto a = std::make_shared<Arguments>();
    arguments.add_option("link", a->link, "Such as socketcan:can0")->required();
    arguments.add_option("--for", a->seconds, "Seconds; until a signal otherwise");
    return [a](Console &console) { return monitor(console, *a); };
}

} // namespace mb::console
