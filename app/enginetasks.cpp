// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs that families bring with them.
#include "app/enginecore.h"

#include "model/transcript.h"

#include <algorithm>

namespace mb {
namespace {

Task<void> rewrite(Device &device, Progress &progress)
{
    auto writing = mb::rewriteSettings(device, progress);
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

} // namespace

/// Of writes that all went well: what is known of them.
std::string EngineCore::proofOf(const std::vector<TransferOutcome> &outcomes)
{
    const auto blind = std::count_if(
        outcomes.begin(), outcomes.end(), [](const TransferOutcome &outcome) { return !outcome.verified; });
    const std::string all = std::to_string(outcomes.size());
    if (blind == 0)
        return all + " written, read back and equal";
    if (static_cast<std::size_t>(blind) == outcomes.size())
        return all + " written; they cannot be read back";
    return all + " written; " + std::to_string(blind) + " of them cannot be read back";
}

/// What was said to a bootloader and what it answered, for whoever has to find out why it failed.
void EngineCore::saveTranscript(const Running &running, const Device &device)
{
    if (m_transcripts.empty())
        return;
    const auto path = mb::saveTranscript(
        m_transcripts, device, running.operation->status(), running.update.value_or(UpdateReport{}));
    if (path)
        notice(Severity::Info, labelOf(device), "the transcript of the update is in " + *path);
    else
        notice(Severity::Caution, labelOf(device), "the transcript of the update is not kept: " + path.error().text());
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
    beginSimple(id, "Write settings again", rewrite, [this, id, finished](const Result<void> &result) {
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
