// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/guide.h"

#include "widgets/common/guarded.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/trialnotebook.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr double tame = 0.05;    ///< greatest overshoot that counts as none
constexpr double isShort = 10.0; ///< counts before its target that friction explains, and not the grain of an encoder
constexpr double arrived = 5.0;  ///< most that counts as there
constexpr const char *simulated = "sim:";

bool isOn(const DeviceView &device, std::string_view key)
{
    const auto index = findParameter(device.family->parameters, key);
    if (!index || index->value >= device.parameters->size())
        return false;
    const ParameterStore::Entry &entry = (*device.parameters)[index->value];
    return entry.raw.value_or(0) != 0;
}

} // namespace

Guide::Guide(Workbench &workbench, Selection &selection, Arming &arming, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_arming(arming)
{
    connect(&workbench, &Workbench::changed, this, &Guide::follow);
    connect(&selection, &Selection::changed, this, &Guide::follow);
    connect(&arming, &Arming::changed, this, &Guide::follow);
}

const DeviceView *Guide::deviceOf(const Story &story, const Snapshot &shot)
{
    const auto found = std::ranges::find_if(shot.devices, [&story](const DeviceView &device) {
        return isDemoUnit(*device.family, device.identity->address, story.unit) && device.link.starts_with(simulated);
    });
    return found == shot.devices.end() ? nullptr : &*found;
}

bool Guide::isBegun(const Story &story, const Snapshot &shot)
{
    const DeviceView *unit = deviceOf(story, shot);
    return unit && std::ranges::any_of(shot.operations, [unit](const OperationView &operation) {
        return operation.device == unit->id && operation.status.kind == OperationKind::Trial;
    });
}

const DeviceView *Guide::device() const
{
    return m_story ? deviceOf(*m_story, m_workbench.snapshot()) : nullptr;
}

void Guide::begin(const Story &story)
{
    m_story = &story;
    m_step = 0;
    ++m_run;
    m_asked = false;
    m_askedAfter = 0;
    m_newest.reset();
    m_overshoot.reset();
    m_lastOvershoot.reset();
    m_peakCurrent.reset();
    m_left.reset();
    m_lastLeft.reset();
    m_wrote = false;
    Q_EMIT changed();
    follow();
}

void Guide::end()
{
    m_story = nullptr;
    ++m_run;
    Q_EMIT changed();
}

QString Guide::result() const
{
    const auto percent = [](double share) { return formatNumber(share * 100.0, 0); };
    QStringList parts;
    if (m_overshoot && m_lastOvershoot)
        parts += tr("overshoot %1 % at first, %2 % now").arg(percent(*m_overshoot), percent(*m_lastOvershoot));
    else if (m_overshoot)
        parts += tr("overshoot %1 %").arg(percent(*m_overshoot));
    const auto counts = [](double left) { return formatNumber(left, 0); };
    if (m_left && m_lastLeft)
        parts += tr("%1 counts beside its target at first, %2 now").arg(counts(*m_left), counts(*m_lastLeft));
    else if (m_left)
        parts += tr("%1 counts beside its target").arg(counts(*m_left));
    if (m_peakCurrent)
        parts += tr("peak current %1 A").arg(formatNumber(*m_peakCurrent, 1));
    return parts.join(QStringLiteral(" · "));
}

void Guide::follow()
{
    const DeviceView *const unit = device();
    if (std::exchange(m_here, unit != nullptr) != m_here)
        Q_EMIT changed();
    if (!unit || isDone())
        return;
    watch(*unit);
    const std::size_t before = m_step;
    while (!isDone() && isProved(m_story->steps[m_step].proof, *unit))
        ++m_step;
    if (m_step != before)
        Q_EMIT changed();
}

void Guide::watch(const DeviceView &device)
{
    m_wrote = m_wrote || !inRam(*device.parameters).empty();
    const OperationView *operation = m_workbench.snapshot().operation(device.id);
    const bool ended = operation && operation->status.state != OperationStatus::State::Running;
    if (!m_newest || (ended && operation->id.value != m_askedAfter))
        askNotebook(device);
}

bool Guide::isProved(Proof proof, const DeviceView &device) const
{
    switch (proof) {
    case Proof::Selected: return m_selection.device() == device.id;
    case Proof::Armed: return m_arming.isArmed(device.id);
    case Proof::Stepped: return m_overshoot.has_value();
    case Proof::Tamed: return m_lastOvershoot && *m_lastOvershoot <= tame;
    case Proof::CurrentShown: return m_peakCurrent.has_value();
    case Proof::LimitOn: return isOn(device, currentSwitch(*device.family));
    case Proof::Stored: return m_wrote && inRam(*device.parameters).empty();
    case Proof::StoppedShort: return m_left.has_value();
    case Proof::Arrived: return m_lastLeft && *m_lastLeft <= arrived;
    }
    return false;
}

void Guide::askNotebook(const DeviceView &device)
{
    if (m_asked)
        return;
    m_asked = true;
    const OperationView *operation = m_workbench.snapshot().operation(device.id);
    const std::uint32_t after
        = operation && operation->status.state != OperationStatus::State::Running ? operation->id.value : m_askedAfter;
    const std::string unit = device.unit;
    m_workbench.trials().list(
        unit, guarded(this, [this, run = m_run, after](const Result<std::vector<KeptTrial>> &trials) {
            if (run != m_run)
                return;
            m_asked = false;
            m_askedAfter = after;
            take(trials.value_or(std::vector<KeptTrial>{}));
        }));
}

/// Of the way that it went: a step that is much shorter than the first proves nothing.
void Guide::takeRest(const tuning::Trial &trial)
{
    if (!trial.metrics.sse)
        return;
    const double way = std::abs(trial.stimulus.to - trial.stimulus.from);
    const double left = std::abs(*trial.metrics.sse) * way;
    if (m_left && way >= m_way / 2.0) {
        m_lastLeft = left;
    } else if (!m_left && left >= isShort) {
        m_left = left;
        m_way = way;
    }
}

void Guide::take(const std::vector<KeptTrial> &trials)
{
    if (!m_newest) { // what was there before is not of this story
        m_newest = trials.empty() ? 0 : trials.back().number;
        follow();
        return;
    }
    const QString before = result();
    for (const KeptTrial &row : trials) {
        const tuning::Trial &trial = row.trial;
        if (row.number <= *m_newest || trial.reason != tuning::EndReason::Done)
            continue;
        m_newest = row.number;
        if (trial.mode == Mode::Position)
            takeRest(trial);
        if (trial.mode != Mode::Velocity)
            continue;
        if (trial.metrics.peakCurrent)
            m_peakCurrent = trial.metrics.peakCurrent;
        if (trial.metrics.overshoot)
            (m_overshoot ? m_lastOvershoot : m_overshoot) = trial.metrics.overshoot;
    }
    if (result() != before)
        Q_EMIT changed();
    follow();
}

} // namespace mb
