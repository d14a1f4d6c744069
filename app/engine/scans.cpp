// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/scans.h"

#include "model/family.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration rescanPeriod = std::chrono::seconds(5);

/// It was taken for mute, and its application runs: a look tells so, also where its motor turns.
bool isBack(const Device &device)
{
    return device.identity().state == DeviceState::Bootloader && !device.family().routes.empty()
        && device.liveness().heard;
}

Message takenHere()
{
    return say("firmware is written here, or units are served; nothing was searched");
}

} // namespace

Scans::Scans(const EngineContext &context, Recordings &recordings)
    : m_context(context)
    , m_recordings(recordings)
{
}

Scans::~Scans()
{
    for (auto &[link, round] : m_rounds)
        round.task.reset();
}

Link *Scans::linkUnder(const std::string &address) const
{
    const auto parsed = LinkAddress::parse(address);
    return parsed ? m_context.session.linkBook().find(*parsed) : nullptr;
}

Result<Link *> Scans::freeLink(const std::string &address) const
{
    Link *const link = linkUnder(address);
    if (!link)
        return fail(Fault::LinkLost, say("the link is not open"));
    if (isTaken(*link))
        return fail(Fault::Unsafe, takenHere(), say("wait until it is done"));
    return link;
}

/// A question would reach a unit between two pages of its firmware.
bool Scans::isTaken(const Link &link) const
{
    return m_context.operations.runsOn(link, OperationKind::UpdateFirmware) || m_context.operations.isLent(link);
}

void Scans::scan(Link &link, ScanExtent extent)
{
    Round &round = m_rounds[&link];
    if (round.running || link.state() != LinkState::Open || isTaken(link))
        return;
    round.running = true;
    round.isDue = false;
    round.isAsked = extent != ScanExtent::Quick;
    m_last = m_context.clock.now();
    ScanOptions options;
    options.extent = extent;
    options.progress = [&round](const Message &step, int done, int total) {
        round.step = step;
        round.done = done;
        round.total = total;
    };
    round.task = std::make_unique<Scope>(m_context.clock);
    round.task->spawn<std::vector<Device *>>(m_context.session.scan(link, std::move(options)),
        [this, &link](const Result<std::vector<Device *>> &devices) { ended(link, devices); });
}

void Scans::ended(Link &link, const Result<std::vector<Device *>> &devices)
{
    end(m_rounds[&link]);
    m_last = m_context.clock.now();
    if (!devices)
        m_context.log.tell(Severity::Caution, link.address().shortName(), devices.error().message());
    probeSilent(link);
    m_recordings.playWhenKnown(link);
}

/// Its scope stays until the next scan: this may be called from what it has just finished.
void Scans::end(Round &round)
{
    if (round.task)
        round.task->clear();
    round.running = false;
    round.step = {};
    round.done = 0;
    round.total = 0;
}

/// A unit whose bootloader is heard elsewhere (Capabilities) is silent in it; where it is the only one that there can be, it must not
/// vanish from the list for that.
void Scans::probeSilent(Link &link)
{
    const auto all = m_context.session.devices();
    const bool known = std::ranges::any_of(all, [&link](const Device *device) { return &device->link() == &link; });
    if (known || link.state() != LinkState::Open)
        return;
    for (const Family *family : m_context.session.families()) {
        const Capabilities &can = family->capabilities;
        if (!can.bootloaderElsewhere || can.firstAddress != can.lastAddress
            || std::ranges::find(family->links, link.kind()) == family->links.end())
            continue;
        m_rounds[&link].task->spawn<Device *>(
            m_context.session.connect({link.address(), std::string(family->key), can.firstAddress, std::nullopt}, true),
            [](const Result<Device *> &) {});
    }
}

bool Scans::isQuiet() const
{
    const auto all = m_context.session.devices();
    return !m_context.operations.isAnyRunning() && std::ranges::none_of(all, [](const Device *device) {
        return device->liveness().moving && !isBack(*device) && !device->link().address().isRecording();
    });
}

void Scans::look()
{
    if (!isQuiet() || m_context.clock.now() - m_last < rescanPeriod)
        return;
    for (const Device *device : m_context.session.devices())
        m_rounds[&device->link()].isDue |= isBack(*device);
    for (Link *link : m_context.session.links()) {
        if (link->kind() == LinkKind::Can
            || m_rounds[link].isDue) // looking over serial rates would disturb the devices that work
            scan(*link);
    }
}

void Scans::giveWay(const Link &link)
{
    const auto round = m_rounds.find(&link);
    if (round != m_rounds.end() && round->second.running && round->second.isAsked)
        m_context.log.tell(Severity::Caution, link.address().shortName(),
            say("the search ends here, because firmware is written or units are served; what it found stays"));
    forget(link);
}

void Scans::describe(const Link &link, LinkView &view) const
{
    const auto round = m_rounds.find(&link);
    if (round == m_rounds.end())
        return;
    view.scanning = round->second.running;
    view.scanStep = round->second.step;
    view.scanDone = round->second.done;
    view.scanTotal = round->second.total;
}

void Scans::carryOut(const orders::ScanLinks &, const Finished &finished)
{
    for (Link *link : m_context.session.links()) {
        if (isTaken(*link))
            m_context.log.tell(Severity::Caution, link->address().shortName(), takenHere());
        scan(*link, ScanExtent::Usual);
    }
    finished({});
}

void Scans::carryOut(const orders::ScanEverything &order, const Finished &finished)
{
    const auto link = freeLink(order.link);
    if (!link)
        return finished(fail(link.error()));
    end(m_rounds[*link]);
    scan(**link, ScanExtent::Everything);
    finished({});
}

void Scans::carryOut(const orders::FindMute &order, const std::function<void(Result<DeviceId>)> &finished)
{
    const auto link = freeLink(order.link);
    if (!link)
        return finished(fail(link.error()));
    Round &round = m_rounds[*link];
    if (round.running && round.isAsked)
        return finished(fail(Fault::Unsafe, say("somebody searches here already"), say("wait until it is done")));
    round.isDue |= round.running;
    end(round);
    round.running = true;
    round.isAsked = true;
    round.task = std::make_unique<Scope>(m_context.clock);
    round.task->spawn<Device *>(
        m_context.session.connect({(*link)->address(), order.family, order.address, std::nullopt}, true),
        [this, &round, finished](const Result<Device *> &unit) {
            end(round);
            finished(unit ? Result<DeviceId>(m_context.session.idOf(**unit)) : fail(unit.error()));
        });
}

void Scans::carryOut(const orders::CancelScan &order, const Finished &finished)
{
    if (Link *link = linkUnder(order.link); link && m_rounds[link].running) {
        end(m_rounds[link]);
        m_context.log.tell(
            Severity::Info, link->address().shortName(), say("the search was cancelled; what it found stays"));
    }
    finished({});
}

} // namespace mb
