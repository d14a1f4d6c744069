// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/unitstates.h"

#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::size_t mostFetched = 60; ///< newest snapshots that are compared by themselves

Symbol symbolOf(settings::Occasion occasion)
{
    switch (occasion) {
    case settings::Occasion::Hand: return Symbol::Star;
    case settings::Occasion::Found: return Symbol::Pin;
    case settings::Occasion::Tuning: return Symbol::Wand;
    case settings::Occasion::Import: return Symbol::Import;
    case settings::Occasion::Restore:
    case settings::Occasion::Update: return Symbol::Camera;
    }
    return Symbol::Camera;
}

} // namespace

void UnitStates::begin(const Family &family)
{
    m_family = &family;
    m_files.clear();
    m_timeline = {};
}

void UnitStates::addFile(const settings::ParameterSnapshot &snapshot)
{
    if (auto side = settings::sideOf(QByteArray::fromStdString(snapshot.file), *m_family))
        m_files.insert_or_assign(snapshot.number, std::move(*side));
}

std::vector<std::int64_t> UnitStates::missing() const
{
    std::vector<std::int64_t> numbers;
    const auto &all = m_timeline.snapshots;
    for (std::size_t i = all.size() > mostFetched ? all.size() - mostFetched : 0; i < all.size(); ++i) {
        if (!m_files.contains(all[i].number))
            numbers.push_back(all[i].number);
    }
    return numbers;
}

void UnitStates::rebuild()
{
    m_states.clear();
    m_states.push_back({UnitState::Kind::Now, present, tr("Device, now"), {}, m_now, tr("live"), Symbol::Chip});
    for (auto snapshot = m_timeline.snapshots.rbegin(); snapshot != m_timeline.snapshots.rend(); ++snapshot) {
        const auto file = m_files.find(snapshot->number);
        if (file == m_files.end())
            continue;
        const bool byHand = snapshot->occasion == settings::Occasion::Hand;
        const QString many = tr("%n values", nullptr, snapshot->count);
        m_states.push_back({UnitState::Kind::Snapshot, snapshot->number, tableText(snapshot->name),
            clockText(momentOf(snapshot->time)), file->second,
            byHand ? tr("by hand, %1").arg(many) : tr("automatic, %1").arg(many), symbolOf(snapshot->occasion)});
    }
    m_states.push_back({UnitState::Kind::Defaults, defaults, tr("factory defaults"), {},
        settings::defaultsOf(*m_family), tr("from the device description"), Symbol::Document});
}

std::int64_t UnitStates::newestUnlike() const
{
    const auto found = std::ranges::find_if(m_states, [this](const UnitState &state) {
        return state.kind == UnitState::Kind::Snapshot && !settings::compare(m_now, state.side).empty();
    });
    return found == m_states.end() ? defaults : found->number;
}

} // namespace mb
