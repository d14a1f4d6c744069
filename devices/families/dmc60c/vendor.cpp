// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/vendor.h"

#include "async/sleep.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t frameSize = 8;
constexpr Duration longestBytes = 2s; ///< after the last moment for the status
constexpr Duration atOnce = 250ms;    ///< commands that may take longer write flash, or restart

CanInbox::Match replyMatch(const VendorRequest &request)
{
    return [device = request.device, also = request.alsoFrom.value_or(request.device)](const CanFrame &frame) {
        const bool reply = isMessage(frame, id::vendorStatus, 4) || decodeVendorData(frame).has_value();
        return reply && (deviceOf(frame) == device || deviceOf(frame) == also);
    };
}

/// Sends the command and its bytes.
Task<void> sendAll(CanLink &link, Clock &clock, const VendorRequest &request)
{
    co_await link.send(encodeVendorCommand(request.device, request.session, request.command));
    const std::span<const std::uint8_t> bytes(request.data);
    for (std::size_t at = 0; at < bytes.size(); at += frameSize) {
        if (request.gap > Duration::zero())
            co_await Sleep(clock, request.gap);
        const auto part = bytes.subspan(at, std::min(frameSize, bytes.size() - at));
        co_await link.send(encodeVendorData(request.device, part));
    }
    co_return {};
}

bool isRefusal(CommandStatus status)
{
    return status == CommandStatus::NotSupported || status == CommandStatus::BadParameter;
}

/// Statuses carry neither session nor command, so that a late one would be taken for the answer to the next command. What it
/// announces tells: a question has bytes of a known number, an order none (README.md#late-answers: or those that it was sent).
bool belongs(const VendorRequest &request, const VendorStatus &status)
{
    const bool good = status.status == CommandStatus::NoError;
    switch (request.command.command) {
    case Command::GetFwver: return good ? status.count == 6 : isRefusal(status.status);
    case Command::GetFlashSeqnum: return good ? status.count == 4 : isRefusal(status.status);
    case Command::GetDescriptors: return good ? status.count > 0 : isRefusal(status.status); // a product name at least
    case Command::EnterBootloader: return status.status == CommandStatus::InBootloader || isRefusal(status.status);
    case Command::SoftReset: return status.status == CommandStatus::AckReset || isRefusal(status.status);
    default: return status.count == 0 || status.count == request.data.size();
    }
}

/// One status of ours, until `timeout`, and the bytes it announces, each in that time. A newer one begins anew: the one before answered
/// an earlier try. Other hosts may hold as many conversations meanwhile as they like.
Task<VendorReply> collect(CanInbox &inbox, Clock &clock, const VendorRequest &request, Duration timeout)
{
    VendorReply reply;
    std::optional<std::size_t> expected;
    const Instant statusUntil = clock.now() + timeout;
    while (!expected || reply.data.size() < *expected) {
        const Instant now = clock.now();
        const Duration left = expected ? timeout : statusUntil - now;
        if (left <= Duration::zero() || now >= statusUntil + longestBytes)
            co_return fail(Fault::Timeout, say("no answer"));
        const Result<CanFrame> frame = co_await inbox.next(left);
        if (!frame)
            co_return fail(frame.error());
        const auto status = decodeVendorStatus(*frame);
        if (status && !belongs(request, *status)) {
            expected.reset(); // whose bytes follow
        } else if (status) {
            reply = {status->device, status->status, status->test, {}, 0};
            expected = request.data.empty() ? status->count : std::size_t{0};
        } else if (const auto bytes = decodeVendorData(*frame); bytes && expected) {
            reply.data.insert(reply.data.end(), bytes->begin(), bytes->end());
        }
    }
    if (reply.data.size() > *expected)
        co_return fail(Fault::BadReply, say("more bytes than the device announced"));
    co_return reply;
}

} // namespace

Attempts attemptsOf(Command command)
{
    switch (command) {
    case Command::SetDevNumber: return {3, 500ms};
    case Command::SetDevName:
    case Command::SetManName:
    case Command::SetProdName:
    case Command::SetManDate:
    case Command::SetHardwareVer:
    case Command::SetSN: return {3, 1s};
    case Command::FlashLEDs:
    case Command::GetDescriptors:
    case Command::GetFwver:
    case Command::GetFlashSeqnum: return {3, 250ms};
    case Command::EnterBootloader: return {3, 2s};
    case Command::SoftReset: return {1, 3s};
    case Command::EraseWriteFlashPage: return {3, 2s};
    case Command::J1ShortTest:
    case Command::J1OpenTest: return {1, 2s};
    }
    return {};
}

Task<VendorReply> vendorExchange(CanLink &link, Clock &clock, VendorRequest request, Attempts attempts)
{
    CanInbox inbox(link, clock, replyMatch(request));
    Error last{Fault::Timeout, say("no answer")};
    const Patience &patience = link.settings().patience;
    const bool asks = attemptsOf(request.command.command).timeout <= atOnce;
    for (int i = 0; i < patience.tries(attempts.tries); ++i) {
        co_await sendAll(link, clock, request);
        auto collecting = collect(
            inbox, clock, request, asks ? patience.answer(attempts.timeout) : patience.work(attempts.timeout));
        Result<VendorReply> reply = co_await std::move(collecting).attempt();
        if (reply) {
            reply->unanswered = i;
            co_return std::move(*reply);
        }
        last = reply.error();
        if (last.fault == Fault::LinkLost)
            break;
    }
    last.detail = say("%1 to number %2: %3", toString(request.command.command), request.device, last.detail);
    co_return fail(last);
}

CommandStatus successOf(Command command)
{
    switch (command) {
    case Command::EnterBootloader: return CommandStatus::InBootloader;
    case Command::SoftReset: return CommandStatus::AckReset;
    case Command::J1ShortTest:
    case Command::J1OpenTest: return CommandStatus::TestPassed;
    default: return CommandStatus::NoError;
    }
}

Result<void> check(Command command, const VendorReply &reply)
{
    if (reply.status == successOf(command))
        return {};
    const Message detail = say("%1: the device answers '%2'", toString(command), toString(reply.status));
    switch (reply.status) {
    case CommandStatus::NotSupported: return fail(Fault::Unsupported, detail);
    case CommandStatus::DataRcvMore:
    case CommandStatus::CrcMismatch: return fail(Fault::BadCheck, detail);
    case CommandStatus::BadParameter:
    case CommandStatus::InBootloader:
    case CommandStatus::FlashWriteFailed:
    case CommandStatus::AckReset:
    case CommandStatus::TestFailed: return fail(Fault::Refused, detail);
    case CommandStatus::NoError:
    case CommandStatus::TestPassed: break;
    }
    return fail(Fault::BadReply, detail);
}

Result<DescriptorList> descriptorsIn(const VendorReply &reply)
{
    MB_TRY_VOID(check(Command::GetDescriptors, reply));
    if (auto list = decodeDescriptors(reply.data))
        return std::move(*list);
    return fail(Fault::BadReply, say("GetDescriptors: a field ends too early"));
}

std::string_view toString(CommandStatus status)
{
    switch (status) {
    case CommandStatus::NoError: return "no error";
    case CommandStatus::NotSupported: return "not supported";
    case CommandStatus::BadParameter: return "bad parameter";
    case CommandStatus::DataRcvMore: return "more data than announced";
    case CommandStatus::InBootloader: return "in the bootloader";
    case CommandStatus::CrcMismatch: return "CRC mismatch";
    case CommandStatus::FlashWriteFailed: return "flash write failed";
    case CommandStatus::AckReset: return "restarted";
    case CommandStatus::TestPassed: return "test passed";
    case CommandStatus::TestFailed: return "test failed";
    }
    return "unknown status";
}

std::string_view toString(Command command)
{
    switch (command) {
    case Command::SetDevNumber: return "SetDevNumber";
    case Command::SetDevName: return "SetDevName";
    case Command::SetManName: return "SetManName";
    case Command::SetProdName: return "SetProdName";
    case Command::SetManDate: return "SetManDate";
    case Command::SetHardwareVer: return "SetHardwareVer";
    case Command::SetSN: return "SetSN";
    case Command::FlashLEDs: return "FlashLEDs";
    case Command::GetDescriptors: return "GetDescriptors";
    case Command::GetFwver: return "GetFwver";
    case Command::GetFlashSeqnum: return "GetFlashSeqnum";
    case Command::EnterBootloader: return "EnterBootloader";
    case Command::SoftReset: return "SoftReset";
    case Command::EraseWriteFlashPage: return "EraseWriteFlashPage";
    case Command::J1ShortTest: return "J1ShortTest";
    case Command::J1OpenTest: return "J1OpenTest";
    }
    return "unknown command";
}

} // namespace mb::dmc60c
