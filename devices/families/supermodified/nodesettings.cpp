// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/nodesettings.h"

#include "families/supermodified/parameters.h"

#include <span>
#include <string>

namespace mb::supermodified {
namespace {

constexpr const char *owedLimitKey = "limit.current.owed";
constexpr const char *owedDurationKey = "limit.current.owed.duration";

/// No scan looks at another rate, so a node that had it would not be found again.
Result<void> checkRate(std::int64_t rate)
{
    std::string legal;
    for (const std::span<const int> rates : {std::span<const int>(searchRates), std::span<const int>(rareRates)}) {
        for (const int known : rates) {
            if (known == rate)
                return {};
            legal += (legal.empty() ? "" : ", ") + std::to_string(known);
        }
    }
    return fail(Fault::OutOfRange, say("legal is %1", legal));
}

} // namespace

NodeSettings::NodeSettings(
    Line &line, const Node &node, const ParameterStore &known, DeviceKnowledge &kept, CodeSink codes)
    : m_line(line)
    , m_node(node)
    , m_known(known)
    , m_kept(kept)
    , m_codes(std::move(codes))
{
}

bool NodeSettings::offers(ParameterIndex index) const
{
    return isOffered(m_known.parameter(index), m_node.dialect);
}

Task<Frame> NodeSettings::talk(Line::Request request)
{
    return converse(m_line, request, m_codes);
}

Task<std::int64_t> NodeSettings::readNumber(Command command)
{
    if (!m_node.dialect)
        co_return fail(Fault::Unsupported, say("its dialect is not known"));
    const Format format = formatOf(command, *m_node.dialect);
    const Frame reply = co_await talk(asking(m_node, command));
    const auto value = valueOf(reply.payload(), format);
    if (!value)
        co_return fail(Fault::BadReply, say("an answer of %1 bytes", reply.size));
    co_return *value;
}

Task<std::int64_t> NodeSettings::read(ParameterIndex index)
{
    const Parameter &row = m_known.parameter(index);
    if (row.id == id::nodeId)
        co_return m_node.id;
    if (row.id == id::baudrate)
        co_return m_node.baudrate;
    const auto getter = getterOf(row);
    if (!getter || !offers(index))
        co_return fail(Fault::Unsupported, say("%1 does not exist in this device's dialect", row.key));
    const Result<std::int64_t> raw = co_await readNumber(*getter).attempt();
    if (!raw)
        co_return fail(raw.error().about(row.key));
    noteRead(row, *raw);
    co_return *raw;
}

Result<Line::Request> NodeSettings::request(Command command, std::int64_t raw) const
{
    if (command == Command::Baudrate)
        MB_TRY_VOID(checkRate(raw));
    Node node = m_node;
    if (!node.dialect && command == Command::ErrorLevel)
        node.dialect = Dialect::D1; // the way out of level 1; D3 refuses the short form
    return setting(node, command, raw);
}

Task<void> NodeSettings::writeNumber(Command command, std::int64_t raw)
{
    auto order = co_await request(command, raw);
    m_line.roster().noteSent(m_node.id, command, raw);
    (void)co_await talk(order);
    co_return {};
}

NodeSettings::OwedLimit NodeSettings::owedLimit() const
{
    const auto kept = [&counters = m_kept.profile().counters](const char *key) {
        const auto found = counters.find(key);
        return found == counters.end() ? 0 : found->second;
    };
    return {kept(owedLimitKey), kept(owedDurationKey)};
}

void NodeSettings::owe(const OwedLimit &owed)
{
    if (owed != owedLimit())
        m_kept.setCounters({{owedLimitKey, owed.limit}, {owedDurationKey, owed.duration}});
}

/// D1 and D2 take the duration for the limit until they restart (README.md#settings), so the limit is put back.
Task<void> NodeSettings::writeDuration(std::int64_t raw)
{
    if (m_node.dialect == Dialect::D3) {
        co_await writeNumber(Command::CurrentLimitDuration, raw);
        co_return {};
    }
    std::int64_t limit = co_await readNumber(Command::GetCurrentLimit);
    if (const OwedLimit owed = owedLimit(); owed.limit != 0 && owed.duration == limit) {
        limit = owed.limit;
        co_await writeNumber(Command::CurrentLimit, limit); // before another duration takes its place
    }
    owe({limit, raw});
    co_await writeNumber(Command::CurrentLimitDuration, raw);
    const Result<void> restored = co_await writeNumber(Command::CurrentLimit, limit).attempt();
    if (restored)
        owe({});
    else
        co_return fail(restored.error().fault,
            say("written, but the current limit, which this firmware overwrites with it, could not be put back to %1 "
                "mA: %2",
                limit, restored.error().message()));
    co_return {};
}

/// Nobody may have looked for who has it: it is asked for its position. Two of one id cannot be told apart any more.
Task<void> NodeSettings::mayTake(int id)
{
    if (id == m_node.id)
        co_return {};
    const Error taken{
        Fault::OutOfRange, say("node id %1 is used by another node of this line", id), say("choose a free one")};
    if (m_line.roster().isClaimed(id, m_node.id))
        co_return fail(taken);
    auto looking = converse(m_line, asking({id, m_node.baudrate, {}}, Command::GetPosition), {});
    const Result<Frame> reply = co_await std::move(looking).attempt();
    if (!reply && reply.error().fault == Fault::LinkLost)
        co_return fail(reply.error());
    if (reply || reply.error().fault != Fault::Timeout)
        co_return fail(taken);
    co_return {};
}

Task<void> NodeSettings::mayWrite(ParameterIndex index, std::int64_t raw)
{
    const Parameter &row = m_known.parameter(index);
    if (auto legal = request(setterOf(row), raw); !legal)
        co_return fail(legal.error().about(row.key));
    if (row.id == id::nodeId)
        co_await mayTake(static_cast<int>(raw));
    co_return {};
}

Task<std::int64_t> NodeSettings::write(ParameterIndex index, std::int64_t raw)
{
    const Parameter &row = m_known.parameter(index);
    auto writing = row.id == id::currentLimitDuration ? writeDuration(raw) : writeNumber(setterOf(row), raw);
    const Result<void> written = co_await std::move(writing).attempt();
    if (!written)
        co_return fail(written.error().about(row.key));
    noteWritten(row, raw);
    co_return raw;
}

void NodeSettings::noteRead(const Parameter &row, std::int64_t raw)
{
    if (row.id == id::nodeMask)
        m_line.roster().noteMask(m_node.id, static_cast<std::uint8_t>(raw));
    else
        m_line.roster().noteSetting(m_node.id, setterOf(row), raw);
}

/// What is in force after a restart only counts from now on, because nobody says when that comes.
void NodeSettings::noteWritten(const Parameter &row, std::int64_t raw)
{
    switch (row.id) {
    case id::nodeMask: m_line.roster().noteNextMask(m_node.id, static_cast<std::uint8_t>(raw)); break;
    case id::nodeId: m_line.roster().noteNextId(m_node.id, static_cast<int>(raw)); break;
    case id::currentLimit: owe({}); break;
    default: noteRead(row, raw); break;
    }
}

} // namespace mb::supermodified
