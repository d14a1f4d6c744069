// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: what asks and waits.
#include "families/supermodified/controller.h"

#include "async/sleep.h"
#include "families/supermodified/channels.h"
#include "families/supermodified/parameters.h"

#include <algorithm>
#include <cmath>

namespace mb::supermodified {
namespace {

constexpr Duration stopLimit = std::chrono::seconds(2);
constexpr Duration lookAgain = std::chrono::milliseconds(5);

} // namespace

Task<Frame> Controller::talk(Line::Request request)
{
    CodeSink sink = [this](std::span<const std::uint8_t> codes) { onCodes(codes); };
    return converse(*m_line, std::move(request), std::move(sink));
}

Task<void> Controller::doRefresh()
{
    auto asking = interview(*m_line, m_node);
    const Interview said = co_await std::move(asking);
    m_restarted = false;
    m_owedLimit.reset();
    Identity known = identityOf(*m_line, m_node, said);
    known.name = identity().name;
    setIdentity(std::move(known));
    updateLiveness();
    co_return {};
}

// Parameters

Error Controller::about(const Parameter &parameter, const Error &error) const
{
    return error.about(parameter.key);
}

Task<std::int64_t> Controller::readNumber(Command command)
{
    if (!m_node.dialect)
        co_return fail(Fault::Unsupported, "its dialect is not known");
    const Format format = formatOf(command, *m_node.dialect);
    auto task = talk(asking(m_node, command));
    const Frame reply = co_await std::move(task);
    const auto value = valueOf(reply.payload(), format);
    if (!value)
        co_return fail(Fault::BadReply, "an answer of " + std::to_string(reply.size) + " bytes");
    co_return *value;
}

Task<std::int64_t> Controller::doRead(ParameterIndex index)
{
    const Parameter &row = parameters().parameter(index);
    if (row.id == id::nodeId)
        co_return m_node.id;
    if (row.id == id::baudrate)
        co_return m_node.baudrate;
    const auto getter = getterOf(row);
    if (!getter || !doOffers(index))
        co_return fail(Fault::Unsupported, std::string(row.key) + " does not exist in this device's dialect");
    auto reading = readNumber(*getter);
    const Result<std::int64_t> raw = co_await std::move(reading).attempt();
    if (!raw)
        co_return fail(about(row, raw.error()));
    noteRead(row, *raw);
    co_return *raw;
}

Task<void> Controller::writeNumber(Command command, std::int64_t raw)
{
    Node node = m_node;
    if (!node.dialect && command == Command::ErrorLevel)
        node.dialect = Dialect::D1; // the way out of level 1; D3 refuses the short form
    auto request = setting(node, command, raw);
    if (!request)
        co_return fail(request.error());
    auto task = talk(std::move(*request));
    (void)co_await std::move(task);
    co_return {};
}

/// D1 and D2 take the duration for the limit until they restart (README.md#settings), so the limit is put back.
Task<void> Controller::writeDuration(std::int64_t raw)
{
    if (m_node.dialect == Dialect::D3) {
        auto writing = writeNumber(Command::CurrentLimitDuration, raw);
        co_await std::move(writing);
        co_return {};
    }
    if (!m_owedLimit) { // else what it reports is the last duration
        auto reading = readNumber(Command::GetCurrentLimit);
        m_owedLimit = co_await std::move(reading);
    }
    const std::int64_t limit = *m_owedLimit;
    auto writing = writeNumber(Command::CurrentLimitDuration, raw);
    co_await std::move(writing);
    auto again = writeNumber(Command::CurrentLimit, limit);
    const Result<void> restored = co_await std::move(again).attempt();
    if (restored)
        m_owedLimit.reset();
    else
        co_return fail(restored.error().fault,
            "written, but the current limit, which this firmware overwrites with it, could not be put back to "
                + std::to_string(limit) + " mA: " + restored.error().text());
    co_return {};
}

Task<std::int64_t> Controller::doWrite(ParameterIndex index, std::int64_t raw)
{
    const Parameter &row = parameters().parameter(index);
    if (!doOffers(index))
        co_return fail(Fault::Unsupported, std::string(row.key) + " does not exist in this device's dialect");
    if (row.id == id::nodeId && raw != m_node.id && m_line->roster().nodes().contains(static_cast<int>(raw)))
        co_return fail(Fault::Refused, "node id " + std::to_string(raw) + " is used by another node of this line");
    auto writing = row.id == id::currentLimitDuration ? writeDuration(raw) : writeNumber(setterOf(row), raw);
    const Result<void> written = co_await std::move(writing).attempt();
    if (!written)
        co_return fail(about(row, written.error()));
    noteWritten(row, raw);
    co_return raw;
}

void Controller::noteRead(const Parameter &row, std::int64_t raw)
{
    Roster &roster = m_line->roster();
    switch (row.id) {
    case id::gainP: roster.noteGain(m_node.id, raw); break;
    case id::profileVelocity: roster.noteProfileVelocity(m_node.id, raw); break;
    case id::profileAcceleration: roster.noteProfileAcceleration(m_node.id, raw); break;
    case id::nodeMask: roster.noteMask(m_node.id, static_cast<std::uint8_t>(raw)); break;
    default: break;
    }
}

/// What is in force after a restart only counts from now on, because nobody says when that comes.
void Controller::noteWritten(const Parameter &row, std::int64_t raw)
{
    switch (row.id) {
    case id::nodeMask: m_line->roster().noteNextMask(m_node.id, static_cast<std::uint8_t>(raw)); break;
    case id::nodeId: m_line->roster().noteNextId(m_node.id, static_cast<int>(raw)); break;
    case id::currentLimit: m_owedLimit.reset(); break;
    default: noteRead(row, raw); break;
    }
}

/// A set is answered after its EEPROM was written (README.md#time-outs), so there is nothing left to prove.
Task<bool> Controller::doStore(Progress &)
{
    parameters().setAllStored();
    co_return true;
}

// Errors

std::vector<FaultRecord> Controller::faultRecords() const
{
    std::vector<FaultRecord> records;
    for (const CodeName &name : codeNames()) {
        const auto reported = m_codes.find(name.code);
        const bool any = reported != m_codes.end();
        records.push_back(
            {std::string(name.key), any && reported->second.active, any, any ? reported->second.count : 0});
    }
    return records;
}

/// Errors come by themselves, in place of answers; a reading makes sure that none waits.
Task<std::vector<FaultRecord>> Controller::doReadFaults()
{
    auto task = talk(asking(m_node, Command::GetPosition));
    (void)co_await std::move(task);
    co_return faultRecords();
}

Task<std::vector<FaultRecord>> Controller::doClearFaults()
{
    if (m_node.dialect == Dialect::D3) {
        auto resetting = talk(asking(m_node, Command::ResetErrors));
        (void)co_await std::move(resetting);
    } else {
        auto task = talk(asking(m_node, Command::GetPosition));
        (void)co_await std::move(task);
    }
    const std::vector<FaultRecord> were = faultRecords();
    m_codes.clear();
    updateLiveness();
    co_return were;
}

// Position

/// README.md#start: a motor that runs would jump to where its old set-point is now. One that stands does not, and Start takes 0 for its
/// set-point afterwards.
Task<void> Controller::doZeroPosition()
{
    stop();
    const Instant limit = clock().now() + stopLimit;
    while (!doIsSeenStopped()) {
        if (clock().now() >= limit || m_serial.state() != LinkState::Open)
            co_return fail(Fault::Unsafe,
                "the stop was not acknowledged, so the position was not reset: a motor that runs would jump");
        Sleep nap(clock(), lookAgain);
        co_await nap;
    }
    if (const std::string lock = m_line->roster().lockOf(m_node.id); !lock.empty())
        co_return fail(Fault::Unsafe, "the position was not reset: " + lock);
    if (!m_motion.isKnownOff()) // README.md#hang
        co_return fail(Fault::Unsafe, "somebody may have started it again, so the position was not reset");
    auto resetting = talk(asking(m_node, Command::ResetPosition));
    (void)co_await std::move(resetting);
    m_position = 0;
    m_motion.zeroed();
    m_polls.zeroed();
    co_return {};
}

// Identity and rates

Task<void> Controller::doIdentify()
{
    co_return fail(Fault::Unsupported, "a Supermodified cannot blink");
}

Task<void> Controller::doRename(std::string)
{
    co_return fail(Fault::Unsupported, "a Supermodified has no name");
}

Task<void> Controller::doRenumber(int address)
{
    if (address < lowestNode || address > highestNode)
        co_return fail(Fault::OutOfRange, "a node id is 1 … 127");
    auto writing = write(*parameterWithId(id::nodeId), address);
    (void)co_await std::move(writing);
    co_return {};
}

Task<void> Controller::doSetRate(ChannelIndex channel, double hertz)
{
    if (!std::isfinite(hertz) || hertz < 0.0)
        co_return fail(Fault::OutOfRange, "a rate is a positive number, or 0 for the usual one");
    if (!m_polls.setRate(channel, hertz))
        co_return fail(Fault::Unsupported, "the set-point comes from here, not from the device");
    co_return {};
}

} // namespace mb::supermodified
