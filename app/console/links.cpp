// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/linkrows.h"
#include "app/console/verb.h"

namespace mb::console {
namespace {

Task<int> list(Console &console)
{
    const std::vector<LinkListing> links = allLinks(console);
    if (console.json())
        console.out().json({{QStringLiteral("links"), toJson(links)}});
    else
        print(console.out(), links);
    co_return exitDone;
}

} // namespace

Job declareLinks(CLI::App &)
{
    return list;
}

} // namespace mb::console
