// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/commandline.h"
#include "app/console/target.h"
#include "app/console/verb.h"

#include <memory>

namespace mb::console {
namespace {

Task<int> help(Console &console, std::string verb)
{
    const auto text = co_await helpText(verb);
    if (console.json())
        console.out().json({{QStringLiteral("help"), qt(text)}});
    else
        console.out().line(std::string_view(text).substr(0, text.find_last_not_of('\n') + 1));
    co_return exitDone;
}

} // namespace

Job declareHelp(CLI::App &arguments)
{
    const auto verb = std::make_shared<std::string>();
    arguments.add_option("verb", *verb, "Such as scan; the whole program otherwise");
    return [verb](Console &console) { return help(console, *verb); };
}

} // namespace mb::console
