// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/vendororders.h"

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr int numberTries = 3;
constexpr int freeRounds = 3; ///< answers may get lost

/// More tries than the maker says: the longest answer is 24 frames, of which one in ten may get lost. Asking is harmless, so
/// those tries are short; 54 ms is the longest that a device stands still.
Attempts patienceFor(Command command)
{
    switch (command) {
    case Command::GetDescriptors:
    case Command::GetFwver:
    case Command::GetFlashSeqnum: return {8, 100ms};
    case Command::SetDevName: return {5, 1s};
    default: return attemptsOf(command);
    }
}

} // namespace

Task<VendorReply> VendorOrders::ask(VendorCommand command, std::vector<std::uint8_t> data)
{
    const auto [device, session] = m_contact.target();
    VendorRequest request{device, session, command, std::move(data)};
    auto task = vendorExchange(m_contact.link, m_contact.clock, std::move(request), patienceFor(command.command));
    Result<VendorReply> reply = co_await std::move(task).attempt();
    if (!reply) {
        if (reply.error().fault == Fault::Timeout)
            m_contact.unanswered();
        co_return fail(reply.error());
    }
    co_await dmc60c::check(command.command, *reply);
    co_return std::move(*reply);
}

Task<FirmwareVersions> VendorOrders::versions()
{
    auto task = ask({Command::GetFwver});
    const VendorReply reply = co_await std::move(task);
    const auto versions = decodeFirmwareVersions(reply.data);
    if (!versions)
        co_return fail(Fault::BadReply, say("GetFwver: 6 bytes were expected"));
    co_return *versions;
}

Task<DescriptorList> VendorOrders::descriptors()
{
    auto task = ask({Command::GetDescriptors});
    const VendorReply reply = co_await std::move(task);
    co_return descriptorsIn(reply);
}

Task<std::uint32_t> VendorOrders::flashSequence()
{
    auto task = ask({Command::GetFlashSeqnum});
    const VendorReply reply = co_await std::move(task);
    const auto sequence = decodeFlashSequence(reply.data);
    if (!sequence)
        co_return fail(Fault::BadReply, say("GetFlashSeqnum: 4 bytes were expected"));
    co_return *sequence;
}

Task<void> VendorOrders::expectFree(int number)
{
    CanInbox inbox(m_contact.link, m_contact.clock, [number, own = m_contact.target().session](const CanFrame &frame) {
        const auto response = decodeEnumResponse0(frame);
        const bool answers = response && response->session != own;
        const bool tells = decodeStatusGeneral(frame) || decodeStatusEncoder(frame) || decodeStatusAnalog(frame);
        return (answers || tells) && deviceOf(frame) == number;
    });
    for (int round = 0; round < freeRounds; ++round) {
        co_await m_contact.link.send(encodeEnumerate());
        const Result<CanFrame> answer = co_await inbox.next(enumWindow);
        if (answer)
            co_return fail(Fault::Refused, say("number %1 is used by another unit", number));
        if (answer.error().fault != Fault::Timeout)
            co_return fail(answer.error());
    }
    co_return {};
}

/// Success comes from the new number, refusal from the old one. When the status is lost, the unit may already be at the
/// new number: it is asked there before the command is repeated.
Task<FirmwareVersions> VendorOrders::moveTo(int number)
{
    const auto [old, session] = m_contact.target();
    Error last{Fault::Timeout, say("no answer")};
    for (int attempt = 0; attempt < numberTries; ++attempt) {
        VendorRequest request{old, session, {Command::SetDevNumber, static_cast<std::uint16_t>(number)}, {}, number};
        auto setting = vendorExchange(
            m_contact.link, m_contact.clock, std::move(request), {1, attemptsOf(Command::SetDevNumber).timeout});
        const Result<VendorReply> status = co_await std::move(setting).attempt();
        if (status) {
            co_await dmc60c::check(Command::SetDevNumber, *status);
        } else if (status.error().fault != Fault::Timeout) {
            co_return fail(status.error());
        }
        VendorRequest question{number, session, {Command::GetFwver}};
        auto asking
            = vendorExchange(m_contact.link, m_contact.clock, std::move(question), patienceFor(Command::GetFwver));
        const Result<VendorReply> answer = co_await std::move(asking).attempt();
        const auto versions = answer ? decodeFirmwareVersions(answer->data) : std::nullopt;
        if (versions)
            co_return *versions;
        if (!answer)
            last = answer.error();
    }
    co_return fail(last);
}

} // namespace mb::dmc60c
