// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/linkchoices.h"

#include "model/family.h"
#include "model/registry.h"
#include "widgets/common/devicetext.h"

#include <QCoreApplication>

#include <algorithm>

namespace mb {
namespace {

struct LinkChoices {
    Q_DECLARE_TR_FUNCTIONS(LinkChoices)
};

LinkChoice::Kind kindOfListing(const LinkListing &listing)
{
    switch (listing.kind) {
    case LinkKind::Serial: return LinkChoice::Kind::Serial;
    case LinkKind::Spi: return LinkChoice::Kind::Spi;
    case LinkKind::Can: break;
    }
    return LinkChoice::Kind::Can;
}

/// Of what is not there: it has no name of its own.
QString kindWord(LinkChoice::Kind kind)
{
    switch (kind) {
    case LinkChoice::Kind::Serial: return LinkChoices::tr("Serial port");
    case LinkChoice::Kind::Spi: return LinkChoices::tr("SPI device");
    default: return LinkChoices::tr("CAN interface");
    }
}

QString stateWord(ListingState state)
{
    switch (state) {
    case ListingState::Up: return LinkChoices::tr("up");
    case ListingState::Down: return LinkChoices::tr("switched off");
    case ListingState::BusOff: return LinkChoices::tr("bus-off");
    case ListingState::NoPermission: return LinkChoices::tr("no permission");
    case ListingState::Absent: return LinkChoices::tr("not there");
    default: return LinkChoices::tr("ready");
    }
}

LinkChoice choiceOf(const LinkListing &listing)
{
    LinkChoice choice;
    choice.kind = kindOfListing(listing);
    choice.address = listing.link.path.empty() ? std::string() : listing.link.text();
    const QString path = listing.link.path.empty() ? kindWord(choice.kind) : qt(listing.link.shortName());
    const bool told = listing.openable && choice.kind == LinkChoice::Kind::Serial && !listing.detail.empty();
    choice.name = told ? LinkChoices::tr("%1 · %2").arg(path, messageText(listing.detail)) : path;
    choice.state = stateWord(listing.state);
    choice.words = messageText(listing.detail);
    choice.command = qt(listing.diagnosis.command);
    choice.openable = listing.openable;
    return choice;
}

/// Of the bench behind it.
QString familiesOn(LinkKind kind)
{
    QStringList titles;
    for (const Family *family : families()) {
        if (!family->bench.empty() && std::ranges::find(family->links, kind) != family->links.end())
            titles += qt(family->title);
    }
    return LinkChoices::tr("%1, at the real speed of their link.").arg(titles.join(QStringLiteral(", ")));
}

LinkChoice simulated(const char *path, const QString &name, const QString &words)
{
    LinkChoice choice;
    choice.kind = LinkChoice::Kind::Simulated;
    choice.address = std::string("sim:") + path;
    choice.name = name;
    choice.state = LinkChoices::tr("ready");
    choice.words = words;
    return choice;
}

} // namespace

std::vector<LinkChoice> linkChoices(const std::vector<LinkListing> &listings, const std::vector<std::string> &open)
{
    std::vector<LinkChoice> choices;
    for (const LinkListing &listing : listings)
        choices.push_back(choiceOf(listing));
    LinkChoice recording;
    recording.kind = LinkChoice::Kind::Recording;
    recording.name = LinkChoices::tr("A recording of frames…");
    recording.state = LinkChoices::tr("file");
    recording.words
        = LinkChoices::tr("Plays a candump or Vector ASC log as if its bus were here. Nothing can be sent.");
    choices.push_back(recording);
    choices.push_back(simulated("", LinkChoices::tr("The whole simulated bench"),
        LinkChoices::tr("Controllers of every family with real bus timing; nothing real can move.")));
    choices.push_back(simulated("can", LinkChoices::tr("Simulated CAN bus"), familiesOn(LinkKind::Can)));
    choices.push_back(simulated("serial", LinkChoices::tr("Simulated serial line"), familiesOn(LinkKind::Serial)));
    choices.push_back(simulated("spi", LinkChoices::tr("Simulated SPI board"), familiesOn(LinkKind::Spi)));
    for (LinkChoice &choice : choices)
        choice.isOpen = !choice.address.empty() && std::ranges::find(open, choice.address) != open.end();
    std::ranges::stable_sort(choices,
        [](const LinkChoice &a, const LinkChoice &b) { return static_cast<int>(a.kind) < static_cast<int>(b.kind); });
    return choices;
}

QString kindTitle(LinkChoice::Kind kind)
{
    switch (kind) {
    case LinkChoice::Kind::Can: return LinkChoices::tr("CAN interfaces");
    case LinkChoice::Kind::Serial: return LinkChoices::tr("Serial ports");
    case LinkChoice::Kind::Spi: return LinkChoices::tr("SPI devices");
    case LinkChoice::Kind::Recording: return LinkChoices::tr("Recordings");
    case LinkChoice::Kind::Simulated: return LinkChoices::tr("Without hardware");
    }
    return {};
}

} // namespace mb
