// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs that families bring with them.
#include "app/enginecore.h"
#include "settings/writing.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace mb {
namespace {

Task<void> rewrite(Device &device, settings::SettingsLog *log, Progress &progress)
{
    auto writing = settings::rewriteKept(device, settings::Origin::Window, log, progress);
    co_await std::move(writing);
    co_return {};
}

Task<void> tryOut(
    Device &device, SetPointStream &stream, const Experiment &experiment, ExperimentOptions options, Progress &progress)
{
    auto running = experiment.run(device, stream, options, progress);
    const ExperimentReport report = co_await std::move(running);
    progress.log(Severity::Good, report.sentence);
    co_return {};
}

constexpr Duration transcriptLimit = std::chrono::seconds(30);

} // namespace

/// What was said to a bootloader and what it answered, for whoever has to find out why it failed.
void EngineCore::saveTranscript(const Running &running, const Device &device)
{
    if (m_transcripts.empty())
        return;
    Transcript transcript
        = transcriptOf(m_transcripts, device, running.operation->status(), running.update.value_or(UpdateReport{}));
    m_files.spawn<std::string>(
        keepTranscript(std::move(transcript)), [this, label = labelOf(device)](const Result<std::string> &path) {
            if (path)
                notice(Severity::Info, label, "the transcript of the update is in " + *path);
            else
                notice(Severity::Caution, label, "the transcript of the update is not kept: " + path.error().text());
        });
}

Task<std::string> EngineCore::keepTranscript(Transcript transcript)
{
    if (!m_background)
        co_return save(transcript);
    const std::string path = transcript.path;
    auto saving = inBackground<std::string>(
        *m_background, m_clock, m_transcripts, transcriptLimit,
        [transcript = std::move(transcript)] { return save(transcript); }, WhenLate::Finish);
    const Result<std::string> saved = co_await std::move(saving).attempt();
    if (!saved && saved.error().fault == Fault::Timeout)
        co_return fail(Fault::Timeout, "the disk has not taken " + path + " for 30 s");
    co_return saved;
}

/// A board on SPI that waits in its bootloader is silent; it must not vanish from the list for that.
void EngineCore::probeSilent(Link &link)
{
    const auto all = m_session.devices();
    const bool known
        = std::any_of(all.begin(), all.end(), [&link](const Device *device) { return &device->link() == &link; });
    if (known || link.kind() != LinkKind::Spi || link.state() != LinkState::Open)
        return;
    for (const Family *family : m_session.families()) {
        if (!family->probe
            || std::find(family->links.begin(), family->links.end(), LinkKind::Spi) == family->links.end())
            continue;
        m_watched[&link].scan->spawn<Device *>(
            m_session.connect({link.address(), std::string(family->key), 0, std::nullopt}),
            [this](const Result<Device *> &) { touch(); });
    }
}

void EngineCore::rewriteSettings(DeviceId id, const Finished &finished)
{
    const auto again = [this](Device &device, Progress &progress) { return rewrite(device, m_settingsLog, progress); };
    beginSimple(id, "Write settings again", again, [this, id, finished](const Result<void> &result) {
        if (const Device *device = m_session.find(id); device && result)
            notice(Severity::Good, labelOf(*device), "the settings that the reset took are written again");
        if (finished)
            finished(result);
    });
}

void EngineCore::experiment(
    DeviceId id, const std::string &key, const ExperimentOptions &options, const Finished &finished)
{
    Device *device = m_session.find(id);
    const std::span<const Experiment> known = device ? device->family().experiments : std::span<const Experiment>();
    const auto found = std::find_if(
        known.begin(), known.end(), [&key](const Experiment &candidate) { return candidate.key == key; });
    if (found == known.end()) {
        if (finished)
            finished(device ? fail(Fault::Unsupported, "this device has no experiment '" + key + "'")
                            : fail(Fault::Timeout, "the device is gone"));
        return;
    }
    SetPointStream &stream = m_session.stream(*device);
    if (stream.isRunning()) {
        if (finished)
            finished(fail(Fault::Unsafe, "stop the motor before an experiment begins"));
        return;
    }
    Running *const running = beginSimple(
        id, found->title.data(),
        [&stream, &experiment = *found, options](
            Device &unit, Progress &progress) { return tryOut(unit, stream, experiment, options, progress); },
        finished);
    if (running)
        running->isExperiment = true;
}

std::string EngineCore::labelOf(const Device &device) const
{
    const std::string label = std::string(device.family().title) + " #" + std::to_string(device.identity().address);
    const auto all = m_session.devices();
    const bool isTwofold = std::any_of(all.begin(), all.end(), [&device](const Device *other) {
        return &other->family() == &device.family() && other->identity().address == device.identity().address
            && &other->link() != &device.link();
    });
    return isTwofold ? label + " on " + device.link().address().shortName() : label;
}

/// Who came and who fell silent since the last look. Silence of a unit that is busy, such as during an update, is no news.
void EngineCore::callTheRoll()
{
    std::set<DeviceId> present;
    for (Device *device : m_session.devices()) {
        const DeviceId id = m_session.idOf(*device);
        present.insert(id);
        const bool isNew = m_roll.count(id) == 0;
        Presence &presence = m_roll[id];
        presence.name = labelOf(*device);
        if (isNew)
            notice(Severity::Info, presence.name, "found on " + device->link().address().shortName());
        if (device->liveness().heard) {
            if (presence.lost)
                notice(Severity::Good, presence.name, "answers again");
            presence.heard = true;
            presence.lost = false;
        } else if (presence.heard && device->busy().empty() && !hasOperation(id)) {
            notice(Severity::Caution, presence.name, "does not answer any more");
            m_directions.forget(device->selector()); // it may come back with other wires
            presence.heard = false;
            presence.lost = true;
        }
    }
    for (auto entry = m_roll.begin(); entry != m_roll.end();) {
        const bool gone = present.count(entry->first) == 0;
        if (gone)
            notice(Severity::Caution, entry->second.name, "is gone");
        entry = gone ? m_roll.erase(entry) : std::next(entry);
    }
}

/// Pages of one image between those of another, on one bus: neither would end, and no log could tell why.
const Device *EngineCore::updatedBeside(DeviceId id) const
{
    const Device *device = m_session.find(id);
    for (const Running &running : m_operations) {
        const Device *other = m_session.find(running.device);
        if (device && other && other != device && &other->link() == &device->link() && running.operation->isRunning()
            && running.operation->status().title == updateTitle)
            return other;
    }
    return nullptr;
}

} // namespace mb
