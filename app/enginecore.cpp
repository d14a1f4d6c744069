// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/enginework.h"
#include "settings/writing.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration lookPeriod = std::chrono::seconds(1);
constexpr Duration rescanPeriod = std::chrono::seconds(5);
constexpr std::size_t keptOperations = 32;
constexpr Duration ratesAgain = std::chrono::milliseconds(100);

} // namespace

EngineCore::EngineCore(Clock &clock, std::span<const Family *const> families, bool opensByItself, MotionGuard *guard)
    : m_clock(clock)
    , m_opensByItself(opensByItself)
    , m_session(clock, families, guard)
    , m_files(clock)
    , m_sessionChanged(m_session.changed().add([this] { touch(); }))
    , m_remarked(m_session.remarked().add([this](const Link &link, const std::string &text) {
        notice(Severity::Caution, link.address().shortName(), text);
    }))
    , m_profileTrouble(
          m_session.profileTrouble().add([this](const std::string &text) { notice(Severity::Danger, {}, text); }))
    , m_memoryTrouble(
          m_session.memoryTrouble().add([this](const std::string &text) { notice(Severity::Caution, {}, text); }))
    , m_stopChanged(m_session.stopChanged().add([this](const Device &device) { followStop(device); }))
    , m_ratesAgain(clock)
    , m_look(clock)
    , m_returned(clock)
    , m_provisional(m_session, provisionalSurroundings())
{
    if (guard)
        m_guardianActed = guard->acted().add(
            [this](const std::string &name, MotionGuard::Verdict verdict) { guardianActed(name, verdict); });
    m_look.startIn(Duration::zero(), [this] { look(); });
}

EngineCore::~EngineCore()
{
    m_session.stopAll(StopCause::Program);
    m_openings.clear();
    m_files.clear();
    for (auto &[link, watched] : m_watched)
        watched.scan.reset();
    m_operations.clear();
}

Snapshot EngineCore::snapshot()
{
    Snapshot shot;
    shot.time = m_clock.now();
    for (Link *link : m_session.links()) {
        LinkView view = viewOf(*link, m_session.clockOf(*link).now());
        if (const auto watched = m_watched.find(link); watched != m_watched.end()) {
            view.scanning = watched->second.scanning;
            view.scanStep = watched->second.step;
            view.scanDone = watched->second.done;
            view.scanTotal = watched->second.total;
            view.traffic = watched->second.traffic;
            if (watched->second.recorder)
                view.recording = watched->second.recorder->state();
            view.unknown = watched->second.unknown->count();
        }
        view.diagnosis = diagnose(symptomsOf(*link, shot.time), shot.time, m_listings);
        shot.links.push_back(std::move(view));
        for (Device *device : m_session.devices()) {
            if (&device->link() == link)
                shot.devices.push_back(viewOf(m_session, *device));
        }
    }
    shot.unconfirmed = m_provisional.views();
    for (const auto &[address, diagnosis] : m_failed)
        shot.failed.push_back({address, diagnosis});
    std::stable_sort(shot.devices.begin(), shot.devices.end(), [](const DeviceView &a, const DeviceView &b) {
        return a.link == b.link
            && (a.family == b.family ? a.identity.address < b.identity.address : a.family->key < b.family->key);
    });
    for (const Running &running : m_operations)
        shot.operations.push_back({running.id, running.device, running.operation->status(), running.update});
    for (const OwedStop &owed : m_session.owedStops())
        shot.owedStops.push_back(owed.device);
    return shot;
}

void EngineCore::removeLink(Link &link)
{
    if (const auto watched = m_watched.find(&link); watched != m_watched.end())
        endScan(watched->second);
    forgetWork(link);
    endRecording(m_watched[&link]);
    m_watched.erase(&link);
    m_session.closeLink(link);
}

void EngineCore::watch(Link &link)
{
    auto [entry, isNew] = m_watched.try_emplace(&link);
    if (!isNew)
        return;
    keepTraffic(link);
    entry->second.state = link.stateChanged().add([this, &link](LinkState state) {
        if (state == LinkState::Lost) {
            m_watched[&link].wasLost = true;
            notice(Severity::Danger, link.address().shortName(), link.reason());
        } else if (state == LinkState::Open) { // whoever opened it; first all who listen have their turn
            m_returned.startIn(Duration::zero(), [this] { welcomeReturned(); });
        }
        touch();
    });
}

bool EngineCore::isQuiet() const
{
    const bool busy = std::any_of(
        m_operations.begin(), m_operations.end(), [](const Running &r) { return r.operation->isRunning(); });
    const auto all = m_session.devices();
    return !busy && std::none_of(all.begin(), all.end(), [](const Device *d) {
        return d->liveness().moving && !d->link().address().isRecording();
    });
}

void EngineCore::look()
{
    m_look.startIn(lookPeriod, [this] { look(); });
    reopenLost();
    callTheRoll();
    m_awaited.look([this](const LinkAddress &address) { openAwaited(address); });
    refreshRestarted();
    lookForOwed();
    meetUnits();
    if (!isQuiet() || m_clock.now() - m_lastScan < rescanPeriod)
        return;
    for (Link *link : m_session.links()) {
        if (link->kind() == LinkKind::Can) // looking over serial rates would disturb the devices that work
            scan(*link);
    }
}

void EngineCore::refreshRestarted()
{
    for (Device *device : m_session.devices()) {
        const DeviceId id = m_session.idOf(*device);
        if (!device->liveness().restarted || !device->liveness().heard || hasOperation(id)
            || device->link().address().isRecording())
            continue;
        notice(Severity::Caution, labelOf(*device),
            "the unit restarted: what is volatile was lost, its parameters are read again");
        device->parameters().forgetAll();
        m_met.erase(id);
        beginSimple(
            id, "Look at the restarted unit", [](Device &unit, Progress &) { return unit.refresh(); },
            [this, id](const Result<void> &result) {
                if (result)
                    readParameters(id);
            });
    }
}

bool EngineCore::hasOperation(DeviceId id) const
{
    return std::any_of(m_operations.begin(), m_operations.end(),
        [id](const Running &r) { return r.device == id && r.operation->isRunning(); });
}

void EngineCore::prune()
{
    for (auto running = m_operations.begin(); running != m_operations.end() && m_operations.size() > keptOperations;)
        running = running->operation->isRunning() ? std::next(running) : m_operations.erase(running);
}

EngineCore::Running *EngineCore::beginSimple(
    DeviceId id, const char *title, const std::function<Task<void>(Device &, Progress &)> &make, Finished finished)
{
    return begin<void>(
        id, title, make,
        [this, id, title = std::string(title), finished](Running &, const Result<void> &result) {
            if (const Device *device = m_session.find(id); device && !result)
                notice(Severity::Danger, labelOf(*device), title + ": " + result.error().text());
            answer(finished, result);
        },
        finished);
}

void EngineCore::readParameters(DeviceId id)
{
    begin<std::vector<TransferOutcome>>(
        id, "Read parameters",
        [](Device &device, Progress &progress) { return mb::readParameters(device, readable(device), progress); },
        [this, id](Running &running, const Result<std::vector<TransferOutcome>> &outcomes) {
            const Device *device = m_session.find(id);
            if (!device || !outcomes)
                return;
            const auto failed
                = std::count_if(outcomes->begin(), outcomes->end(), [](const TransferOutcome &o) { return !o.raw; });
            const auto missing = readable(*device).size() - outcomes->size() + static_cast<std::size_t>(failed);
            if (missing > 0)
                notice(Severity::Caution, labelOf(*device), std::to_string(missing) + " parameters gave no answer");
            else
                running.operation->log(Severity::Good, "all " + std::to_string(outcomes->size()) + " read");
        },
        {});
}

void EngineCore::storeParameters(DeviceId id, Finished finished)
{
    begin<bool>(
        id, "Store to flash", [](Device &device, Progress &progress) { return device.store(progress); },
        [this, id, finished](Running &, const Result<bool> &proved) {
            const Device *device = m_session.find(id);
            if (device && proved)
                notice(*proved ? Severity::Good : Severity::Caution, labelOf(*device),
                    *proved ? "stored, the flash sequence number advanced" : "stored, not verifiable");
            else if (device)
                notice(Severity::Danger, labelOf(*device), proved.error().text());
            answer(finished, proved ? Result<void>() : Result<void>(fail(proved.error())));
        },
        finished);
}

void EngineCore::identify(DeviceId id, Finished finished)
{
    beginSimple(
        id, "Identify", [](Device &device, Progress &) { return device.identify(); }, std::move(finished));
}

void EngineCore::rename(DeviceId id, const std::string &name, Finished finished)
{
    beginSimple(
        id, "Rename", [name](Device &device, Progress &) { return device.rename(name); }, std::move(finished));
}

void EngineCore::renumber(DeviceId id, int address, Finished finished)
{
    beginSimple(
        id, "Assign number",
        [this, address](Device &device, Progress &progress) {
            return settings::renumberKept(device, address, settings::Origin::Window, m_settingsLog, progress);
        },
        std::move(finished));
}

void EngineCore::clearFaults(DeviceId id, Finished finished)
{
    begin<std::vector<FaultRecord>>(
        id, "Read and clear faults", [](Device &device, Progress &) { return device.clearFaults(); },
        [finished](Running &, const Result<std::vector<FaultRecord>> &faults) {
            answer(finished, faults ? Result<void>() : Result<void>(fail(faults.error())));
        },
        finished);
}

void EngineCore::calibrate(DeviceId id, const std::string &key, std::optional<double> value, const Finished &finished)
{
    Device *device = m_session.find(id);
    answer(finished, device ? device->calibrate(key, value) : fail(Fault::Timeout, "the device is gone"));
}

void EngineCore::setDialect(DeviceId id, const std::string &key, const Finished &finished)
{
    Device *device = m_session.find(id);
    if (device && m_session.stream(*device).isRunning())
        answer(finished, fail(Fault::Unsafe, "stop the motor before its dialect is changed"));
    else
        answer(finished, device ? device->setDialect(key) : fail(Fault::Timeout, "the device is gone"));
}

void EngineCore::setRate(DeviceId id, ChannelIndex channel, double hertz)
{
    m_wished[{id, channel}] = hertz;
    if (hasOperation(id)) { // it began after the window had seen that the device is free
        m_rates[{id, channel}] = hertz;
        m_ratesAgain.startIn(ratesAgain, [this] {
            for (const auto &[place, wished] : std::exchange(m_rates, {}))
                setRate(place.first, place.second, wished);
        });
        return;
    }
    begin<void>(
        id, "Set telemetry rate",
        [channel, hertz](Device &device, Progress &) { return device.setRate(channel, hertz); },
        [this, id](Running &, const Result<void> &result) {
            const Device *device = m_session.find(id);
            if (device && !result && result.error().fault != Fault::Unsupported) // then it stays as it is
                notice(Severity::Caution, labelOf(*device), "Set telemetry rate: " + result.error().text());
        },
        {});
}

void EngineCore::startMotion(
    DeviceId id, const SetPoint &setPoint, Duration lease, const Finished &finished, const Glide &glide)
{
    Device *device = m_session.find(id);
    if (!device) {
        answer(finished, fail(Fault::Timeout, "the device is gone"));
        return;
    }
    SetPointStream &stream = m_session.stream(*device);
    m_streams[id] = stream.changed().add([this, id] { streamChanged(id); });
    if (const std::string caution = device->caution(setPoint); !caution.empty())
        notice(Severity::Caution, labelOf(*device), caution);
    answer(finished, stream.start(setPoint, lease, glide));
    touch();
}

void EngineCore::streamChanged(DeviceId id)
{
    touch();
    Device *device = m_session.find(id);
    if (!device)
        return;
    const SetPointStream &stream = m_session.stream(*device);
    if (!stream.isRunning() && stream.end() != SetPointStream::End::Stopped)
        notice(Severity::Danger, labelOf(*device),
            "stopped: "
                + (stream.end() == SetPointStream::End::LeaseExpired ? "the window did not respond in time"
                                                                     : stream.reason()));
}

void EngineCore::updateMotion(DeviceId id, const SetPoint &setPoint, const Finished &finished, const Glide &glide)
{
    if (Device *device = m_session.find(id))
        answer(finished, m_session.stream(*device).update(setPoint, glide));
    else
        answer(finished, fail(Fault::Timeout, "the device is gone"));
}

void EngineCore::renewMotion(DeviceId id)
{
    if (Device *device = m_session.find(id))
        m_session.stream(*device).renew();
}

void EngineCore::stopMotion(DeviceId id)
{
    if (Device *device = m_session.find(id))
        m_session.stream(*device).stop();
    interruptTrials(id);
    touch();
}

/// A set-point that goes on would start it again.
void EngineCore::zeroPosition(DeviceId id, Finished finished)
{
    if (Device *device = m_session.find(id))
        m_session.stream(*device).stop();
    beginSimple(
        id, "Count from 0", [](Device &device, Progress &) { return device.zeroPosition(); }, std::move(finished));
}

void EngineCore::update(DeviceId id, std::shared_ptr<const FirmwareImage> image, const UpdateOptions &options)
{
    if (const Device *other = updatedBeside(id)) {
        notice(Severity::Caution, labelOf(*m_session.find(id)),
            "one update a bus: " + labelOf(*other) + " is being written; nothing was sent");
        return;
    }
    begin<UpdateReport>(
        id, updateTitle,
        [this, image, options](Device &device, Progress &progress) {
            device.setBusy("firmware update");
            return after<UpdateReport>(keptBefore(device, settings::Occasion::Update, progress),
                device.family().update(device, *image, options, progress));
        },
        [this, id, image](Running &running, Result<UpdateReport> report) {
            Device *device = m_session.find(id);
            if (!report)
                report = UpdateReport{
                    report.error().fault == Fault::Cancelled ? UpdateOutcome::Cancelled : UpdateOutcome::Failed, {}, {},
                    0, 0, false, report.error().text(), report.error().fault};
            running.update = *report;
            if (!device)
                return;
            device->setBusy({});
            saveTranscript(running, *device);
            const bool good = report->outcome == UpdateOutcome::Done || report->outcome == UpdateOutcome::UpToDate;
            notice(good ? Severity::Good : Severity::Danger, labelOf(*device), "firmware: " + report->evidence);
            scan(device->link());
        },
        [this, id](const Result<void> &result) {
            if (const Device *device = m_session.find(id))
                notice(Severity::Caution, labelOf(*device), result.error().text());
        });
}

void EngineCore::cancel(OperationId id)
{
    for (Running &running : m_operations) {
        if (running.id == id && running.interruption)
            running.interruption->interrupt();
        else if (running.id == id)
            (void)running.operation->cancel();
    }
}

void EngineCore::sendFrame(const std::string &link, const CanFrame &frame, const Finished &finished)
{
    for (Link *open : m_session.links()) {
        if (open->address().text() != link || open->kind() != LinkKind::Can)
            continue;
        answer(finished, static_cast<CanLink *>(open)->send(frame));
        return;
    }
    answer(finished, fail(Fault::LinkLost, "the link is not open"));
}

} // namespace mb
