// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/linkrows.h"
#include "app/console/notebook.h"
#include "app/console/progressline.h"
#include "app/console/table.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "app/console/within.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace mb::console {
namespace {

/// As long as --timeout says: what has not answered by then is not listed. A link on which nothing answers is looked through again, as often as
/// --retries says.
Task<std::vector<Device *>> scanPatiently(Console &console, Link &link, ScanOptions options)
{
    const Patience &patience = console.options().patience;
    Result<std::vector<Device *>> found;
    for (int tries = 0; tries <= patience.retries; ++tries) {
        auto looking = within(console.clock(), console.session().scan(link, options), patience.timeout,
            {Fault::Timeout, say("not complete")});
        found = co_await std::move(looking).attempt();
        if (!found && found.error().fault == Fault::Timeout) {
            console.note(link.address().text() + ": the scan was cut off after "
                + numberText(secondsOf(*patience.timeout)) + " s");
            found = console.session().devices();
            std::erase_if(*found, [&link](const Device *device) { return &device->link() != &link; });
        }
        if (!found || !found->empty())
            break;
    }
    co_return std::move(found);
}

/// Scans several links at the same time. A signal ends it with what was found by then.
class Round {
public:
    Round(Console &console, ScanExtent extent)
        : m_console(console)
        , m_extent(extent)
        , m_progress(console)
        , m_cut(console.clock())
        , m_scope(console.clock())
        , m_signal(console.interrupted().add([this] { m_cut.startIn(Duration::zero(), [this] { cut(); }); }))
    {
    }
    void start(const std::vector<Link *> &links)
    {
        m_links = links;
        m_found.resize(links.size());
        m_running = links.size();
        for (std::size_t i = 0; i < links.size(); ++i) {
            ScanOptions options;
            options.extent = m_extent;
            options.progress
                = [this](const Message &what, int place, int total) { m_progress.step(what, place, total); };
            m_scope.spawn<std::vector<Device *>>(scanPatiently(m_console, *links[i], std::move(options)),
                [this, i](Result<std::vector<Device *>> found) { ended(i, std::move(found)); });
        }
        if (links.empty())
            done.set();
    }
    /// In the order of the links.
    [[nodiscard]] std::vector<Device *> devices() const
    {
        std::vector<Device *> all;
        for (std::size_t i = 0; i < m_found.size(); ++i) {
            if (m_isCut)
                addThoseOn(*m_links[i], all);
            else
                all.insert(all.end(), m_found[i].begin(), m_found[i].end());
        }
        return all;
    }

    /// Links that were looked through to the end.
    [[nodiscard]] std::size_t scanned() const { return m_scanned; }
    [[nodiscard]] bool isCut() const { return m_isCut; }

    Event done;
    std::optional<Error> error;

private:
    void ended(std::size_t link, Result<std::vector<Device *>> found)
    {
        if (found) {
            m_found[link] = std::move(*found);
            ++m_scanned;
        } else if (!error)
            error = found.error();
        if (--m_running == 0 && !m_isCut)
            done.set();
    }
    void cut()
    {
        if (m_running == 0 || std::exchange(m_isCut, true))
            return;
        done.set();
    }
    void addThoseOn(const Link &link, std::vector<Device *> &all) const
    {
        for (Device *const device : m_console.session().devices()) {
            if (&device->link() == &link)
                all.push_back(device);
        }
    }

    Console &m_console;
    ScanExtent m_extent;
    ProgressLine m_progress;
    std::vector<std::vector<Device *>> m_found;
    std::size_t m_running = 0;
    std::size_t m_scanned = 0;
    std::vector<Link *> m_links;
    bool m_isCut = false;
    Timer m_cut; ///< from the clock: whoever waits for the end is not called from within a signal
    Scope m_scope;
    Subscription m_signal;
};

struct Opened {
    std::vector<Link *> links;
    std::vector<LinkListing> listings;
    std::optional<Error> error; ///< of the first that cannot be opened, while others can
};

/// The links that were named. One that cannot be opened takes nothing from the others.
Result<Opened> openNamed(Console &console, const std::vector<std::string> &names)
{
    MB_TRY(const auto addresses, parseLinks(console, names));
    Opened opened;
    for (const LinkAddress &address : addresses) {
        auto link = console.session().openLink(address);
        if (link) {
            opened.links.push_back(*link);
            continue;
        }
        if (link.error().fault == Fault::OutOfRange) // the words are wrong, not the link
            return fail(link.error());
        opened.listings.push_back(
            {address, kindOf(address), ListingState::Absent, link.error().message(), false, {}, false});
        if (!opened.error)
            opened.error = link.error();
    }
    if (opened.links.empty() && opened.error)
        return fail(*opened.error);
    return opened;
}

/// Everything is listed, CAN interfaces that are up are opened: opening a serial port could reset hardware.
Opened openListed(Console &console)
{
    Opened opened;
    opened.listings = allLinks(console);
    for (LinkListing &listing : opened.listings) {
        if (listing.link.scheme != "socketcan" || !listing.openable)
            continue;
        auto link = console.session().openLink(listing.link);
        if (link) {
            opened.links.push_back(*link);
            continue;
        }
        listing.state = ListingState::Absent;
        listing.detail = link.error().message();
        if (!opened.error)
            opened.error = link.error();
    }
    return opened;
}

void print(Console &console, const std::vector<Device *> &devices, UnitNames &names)
{
    Table table({"DEVICE", "STATE", "NAME", "SERIAL", "FIRMWARE", "BOOTLOADER", "DIALECT", "DETAIL"});
    for (const Device *device : devices) {
        const Identity &identity = device->identity();
        table.add({device->selector(), std::string(toString(identity.state)), names.of(*device), identity.serial,
            identity.firmware, identity.bootloader, identity.dialect, identity.detail.english()});
    }
    if (devices.empty())
        console.note("no devices found");
    else
        table.print(console.out());
}

/// What became of the links while they were scanned.
void refreshListings(Console &console, Opened &opened)
{
    for (const Link *link : opened.links) {
        const auto same = [link](const LinkListing &listing) { return listing.link == link->address(); };
        const auto known = std::ranges::find_if(opened.listings, same);
        const LinkListing now = listingOf(*link, console.clock().now());
        if (known == opened.listings.end())
            opened.listings.push_back(now);
        else if (!now.diagnosis.isHealthy())
            *known = now;
        if (!now.diagnosis.isHealthy() && !console.json())
            console.note(link->address().text() + ": " + now.detail.english());
    }
}

Task<int> scan(Console &console, std::vector<std::string> names, bool everything)
{
    Opened opened;
    if (names.empty()) {
        opened = openListed(console);
        if (opened.links.empty() && !opened.error)
            console.note("no CAN interface is up; 'motorbenchctl links' lists what there is, 'motorbenchctl scan sim:' "
                         "finds simulated devices");
    } else {
        opened = co_await openNamed(console, names);
    }
    auto round = std::make_unique<Round>(console, everything ? ScanExtent::Everything : ScanExtent::Quick);
    round->start(opened.links);
    co_await round->done.wait();
    const std::vector<Device *> devices = round->devices();
    const std::optional<Error> error = round->error ? round->error : opened.error;
    const bool anyScanned = round->scanned() > 0;
    const bool isCut = round->isCut();
    round.reset(); // nothing is drawn any more
    for (Link *const link : opened.links)
        noteRemark(console, *link);
    if (error && !anyScanned)
        co_return fail(*error);
    refreshListings(console, opened);
    UnitNames units(console);
    if (console.json()) {
        QJsonArray rows;
        for (const Device *device : devices)
            rows.append(scanRow(*device, units.of(*device)));
        console.out().json({{QStringLiteral("devices"), rows}, {QStringLiteral("links"), toJson(opened.listings)}});
    } else {
        print(console, devices, units);
    }
    if (isCut)
        co_return fail(Fault::Cancelled, say("interrupted before it was done"));
    co_return error ? console.fails(*error) : exitDone;
}

} // namespace

Job declareScan(CLI::App &arguments)
{
    const auto links = std::make_shared<std::vector<std::string>>();
    arguments.add_option("link", *links, "Where to look, such as sim: or socketcan:can0");
    const auto everything = std::make_shared<bool>(false);
    arguments.add_flag(
        "--everything", *everything, "Every rate and every address; takes minutes on serial lines, Ctrl+C ends it");
    return [links, everything](Console &console) { return scan(console, *links, *everything); };
}

} // namespace mb::console
