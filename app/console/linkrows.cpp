// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/linkrows.h"

#include "app/console/table.h"
#include "app/console/target.h"

namespace mb::console {

std::vector<LinkListing> allLinks(const Console &console)
{
    std::vector<LinkListing> links = listLinks();
    for (LinkListing &link : listPluginLinks())
        links.push_back(std::move(link));
    for (const LinkAddress &address : expandLink(LinkAddress{"sim", "", {}}, console.families()))
        links.push_back({address, kindOf(address), ListingState::Available,
            say("simulated devices inside this program"), true, {}, false});
    return links;
}

LinkListing listingOf(const Link &link, Instant now)
{
    const bool open = link.state() == LinkState::Open;
    const Diagnosis found = diagnose(symptomsOf(link, now), now, listLinks());
    return {link.address(), link.kind(), open ? ListingState::Open : ListingState::Lost, found.message(), open, found,
        false};
}

QJsonArray toJson(const std::vector<LinkListing> &links)
{
    QJsonArray rows;
    for (const LinkListing &link : links) {
        rows.append(QJsonObject{
            {QStringLiteral("link"), qt(link.link.text())},
            {QStringLiteral("kind"), qt(toString(link.kind))},
            {QStringLiteral("state"), qt(toString(link.state))},
            {QStringLiteral("detail"), textOrNull(link.detail.english())},
        });
    }
    return rows;
}

void print(Output &out, const std::vector<LinkListing> &links)
{
    Table table({"LINK", "KIND", "STATE", "DETAIL"});
    for (const LinkListing &link : links)
        table.add({link.link.text(), std::string(toString(link.kind)), std::string(toString(link.state)),
            link.detail.english()});
    table.print(out);
}

} // namespace mb::console
