// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/nodepresence.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;

constexpr Duration foreignMemory = 500ms;
constexpr std::int64_t jitter = 4; ///< counts of a motor that stands
constexpr std::int64_t suddenly = 4;

} // namespace

NodePresence::NodePresence(Line &line, const Node &node, Owner owner)
    : m_line(line)
    , m_node(node)
    , m_owner(std::move(owner))
    , m_foreign(line.clock())
    , m_unsolicited(line.unsolicited().add([this](const Frame &frame) { observe(frame); }))
{
}

bool NodePresence::setHeard(bool heard)
{
    return std::exchange(m_heard, heard);
}

bool NodePresence::answered()
{
    m_missed = std::exchange(m_misses, 0) > 0;
    return m_missed;
}

void NodePresence::located(std::int64_t raw, bool isAsked)
{
    if (m_missed && m_position.value_or(0) != 0 && raw == 0)
        m_supply = isAsked ? Supply::Doubted : Supply::Lost;
    else if (m_supply == Supply::Kept && isAsked && hasJumped(raw))
        m_supply = Supply::Doubted;
    m_step = raw - m_position.value_or(raw);
    m_position = raw;
}

bool NodePresence::hasJumped(std::int64_t raw) const
{
    const std::int64_t step = std::abs(raw - m_position.value_or(raw));
    return std::abs(raw) < step && step > suddenly * std::max(std::abs(m_step), jitter);
}

void NodePresence::notStarted()
{
    if (m_supply == Supply::Doubted)
        m_supply = Supply::Lost;
}

void NodePresence::moved()
{
    if (m_supply == Supply::Doubted)
        m_supply = Supply::Kept;
}

void NodePresence::observe(const Frame &frame)
{
    const CommandForm *const message = messageOf(frame.command);
    const bool forUs = frame.to == m_node.id || frame.to == broadcastId;
    if (!forUs || frame.from == m_line.roster().hostId() || message == nullptr)
        return;
    const bool undoes = (frame.is(Command::Stop) || frame.is(Command::GlobalStop)) && m_line.driven().has(m_node.id);
    if (!message->control && !undoes)
        return;
    m_owner.commanded();
    m_foreign.startIn(foreignMemory, [this] { m_owner.changed(); });
    m_owner.changed();
}

} // namespace mb::supermodified
