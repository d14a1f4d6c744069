// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/interview.h"

#include "wire/number.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

constexpr std::string_view baudKey = "baud";
constexpr std::string_view maskKey = "mask"; ///< where it is not exact
constexpr std::string_view unread = "unknown";

/// The dialect by the lengths of three replies; nothing when the node refuses, or they contradict each other.
Task<std::optional<Dialect>> detect(Line &line, Node node, CodeSink codes)
{
    const Frame position = co_await converse(line, asking(node, Command::GetPosition), codes);
    const auto third = isThirdGeneration(position);
    if (!third)
        co_return std::optional<Dialect>();
    const Frame velocity = co_await converse(line, asking(node, Command::GetVelocity), codes);
    const auto dialect = *third ? std::optional(Dialect::D3) : dialectByVelocity(velocity);
    const Frame acceleration = co_await converse(line, asking(node, Command::GetProfileAcceleration), codes);
    const bool agrees = dialect && acceleration.size == sizeOf(formatOf(Command::GetProfileAcceleration, *dialect));
    co_return agrees ? dialect : std::nullopt;
}

/// Nothing when the node refuses.
Task<std::optional<std::int64_t>> numberOf(Line &line, Node node, Command command, Format format)
{
    auto asked = converse(line, asking(node, command), {});
    const Result<Frame> reply = co_await std::move(asked).attempt();
    if (!reply && reply.error().fault != Fault::Refused)
        co_return fail(reply.error());
    co_return reply ? valueOf(reply->payload(), format) : std::nullopt;
}

/// What bounds the moves of a node whose dialect is known.
Task<void> readBounds(Line &line, Node node, Interview &said)
{
    const auto formatIn = [&node](Command command) { return formatOf(command, *node.dialect); };
    said.gainP = co_await numberOf(line, node, Command::GetP, formatIn(Command::GetP));
    auto second = numberOf(line, node, Command::GetProfileVelocity, formatIn(Command::GetProfileVelocity));
    said.profileVelocity = co_await std::move(second);
    auto third = numberOf(line, node, Command::GetProfileAcceleration, formatIn(Command::GetProfileAcceleration));
    said.profileAcceleration = co_await std::move(third);
    co_return {};
}

void keep(Roster &roster, const Node &node, const Interview &said)
{
    roster.note(node.id, node.baudrate);
    if (said.mask)
        roster.noteMask(node.id, *said.mask);
    else
        roster.noteUnreadMask(node.id);
    if (said.gainP)
        roster.noteSetting(node.id, Command::P, said.gainP);
    if (said.profileVelocity)
        roster.noteSetting(node.id, Command::ProfileVelocity, said.profileVelocity);
    if (said.profileAcceleration)
        roster.noteSetting(node.id, Command::ProfileAcceleration, said.profileAcceleration);
}

} // namespace

Task<Interview> interview(Line &line, Node node)
{
    Interview said;
    std::uint8_t last = 0;
    CodeSink note = [&last](std::span<const std::uint8_t> codes) { last = codes.back(); };
    const auto dialect = co_await detect(line, node, note).attempt();
    if (!dialect && dialect.error().fault != Fault::Refused)
        co_return fail(dialect.error());
    said.levelOne = !dialect && last == code::invalidGetCount;
    said.dialect = dialect.value_or(std::nullopt);
    if (!said.levelOne) { // one byte in every dialect
        if (const auto mask = co_await numberOf(line, node, Command::GetNodeMask, Format::U8); mask)
            said.mask = static_cast<std::uint8_t>(*mask);
    }
    if (said.dialect) {
        node.dialect = said.dialect;
        co_await readBounds(line, node, said);
    }
    keep(line.roster(), node, said);
    co_return said;
}

Identity identityOf(const Roster &roster, const Node &node, const Interview &interview)
{
    Identity identity;
    identity.family = "supermodified";
    identity.address = node.id;
    identity.state = DeviceState::Online;
    if (interview.dialect)
        identity.dialect = toString(*interview.dialect);
    identity.descriptors.emplace_back(baudKey, std::to_string(node.baudrate));
    if (interview.mask != exactMask)
        identity.descriptors.emplace_back(
            maskKey, interview.mask ? std::to_string(*interview.mask) : std::string(unread));
    if (interview.levelOne)
        identity.detail = say("Its error level is 1, so every reading fails. Set error.level to 0.");
    else if (!interview.dialect)
        identity.detail = say("Its answers fit no known dialect.");
    else if (const auto lock = roster.lockOf(node.id); !lock.empty())
        identity.detail = say("It is not driven: %1.", lock);
    return identity;
}

namespace {

/// Leaves `number` as it is when the identity has no such descriptor.
void takeDescriptor(const Identity &identity, std::string_view key, int &number)
{
    const auto found
        = std::ranges::find_if(identity.descriptors, [key](const auto &descriptor) { return descriptor.first == key; });
    if (found != identity.descriptors.end())
        (void)takeNumber(found->second, number);
}

} // namespace

std::optional<std::uint8_t> maskOf(const Identity &identity)
{
    if (std::ranges::find(identity.descriptors, std::pair{std::string(maskKey), std::string(unread)})
        != identity.descriptors.end())
        return std::nullopt;
    int mask = exactMask;
    takeDescriptor(identity, maskKey, mask);
    return static_cast<std::uint8_t>(mask);
}

Node nodeOf(const Identity &identity, const SerialLink &link)
{
    Node node;
    node.id = identity.address;
    node.baudrate = link.fixedBaudrate().value_or(link.baudrate());
    node.dialect = dialectFrom(identity.dialect);
    takeDescriptor(identity, baudKey, node.baudrate);
    return node;
}

} // namespace mb::supermodified
