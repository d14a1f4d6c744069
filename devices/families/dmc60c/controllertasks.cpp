// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: what asks and waits, without parameters.
#include "families/dmc60c/controller.h"

#include "async/sleep.h"
#include "families/dmc60c/unitidentity.h"

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr int numberTries = 3;

/// More tries than README.md#late-answers says: the longest answer is 24 frames, of which one in ten may get lost. Asking is harmless, so
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

// Vendor commands

Task<VendorReply> Controller::vendor(VendorCommand command, std::vector<std::uint8_t> data)
{
    VendorRequest request{identity().address, session(), command, std::move(data)};
    auto task = vendorExchange(m_can, clock(), std::move(request), patienceFor(command.command));
    Result<VendorReply> reply = co_await std::move(task).attempt();
    if (!reply) {
        if (reply.error().fault == Fault::Timeout)
            enumerate(); // a wrong session is answered by silence
        co_return fail(reply.error());
    }
    if (auto checked = dmc60c::check(command.command, *reply); !checked)
        co_return fail(checked.error());
    co_return std::move(*reply);
}

Task<FirmwareVersions> Controller::getVersions()
{
    auto task = vendor({Command::GetFwver}, {});
    const VendorReply reply = co_await std::move(task);
    const auto versions = decodeFirmwareVersions(reply.data);
    if (!versions)
        co_return fail(Fault::BadReply, say("GetFwver: 6 bytes were expected"));
    co_return *versions;
}

Task<DescriptorList> Controller::getDescriptors()
{
    auto task = vendor({Command::GetDescriptors}, {});
    const VendorReply reply = co_await std::move(task);
    auto list = decodeDescriptors(reply.data);
    if (!list)
        co_return fail(Fault::BadReply, say("GetDescriptors: a field ends too early"));
    co_return std::move(*list);
}

Task<std::uint32_t> Controller::flashSequence()
{
    auto task = vendor({Command::GetFlashSeqnum}, {});
    const VendorReply reply = co_await std::move(task);
    const auto sequence = decodeFlashSequence(reply.data);
    if (!sequence)
        co_return fail(Fault::BadReply, say("GetFlashSeqnum: 4 bytes were expected"));
    co_return *sequence;
}

Task<void> Controller::doRefresh()
{
    const std::optional<int> before = m_knownSession;
    auto first = getVersions();
    Result<FirmwareVersions> versions = co_await std::move(first).attempt();
    if (!versions && versions.error().fault == Fault::Timeout) {
        co_await Sleep(clock(), 2 * enumWindow); // vendor() has enumerated; time to judge what answered
        if (m_knownSession == before)
            co_return fail(versions.error());
        auto again = getVersions();
        versions = co_await std::move(again).attempt();
    }
    if (!versions)
        co_return fail(versions.error());
    auto descriptors = getDescriptors();
    const DescriptorList list = co_await std::move(descriptors);
    Identity known = identity();
    setVersions(known, *versions);
    setDescriptors(known, list);
    m_restarted = false;
    setIdentity(std::move(known));
    updateLiveness();
    co_return {};
}

Task<void> Controller::doIdentify()
{
    auto task = vendor({Command::FlashLEDs}, {});
    co_await std::move(task);
    co_return {};
}

/// A restart takes what is not in flash yet, so that is waited for.
Task<void> Controller::doRestart()
{
    NoProgress unheard;
    auto storing = doStore(unheard);
    const Result<bool> stored = co_await std::move(storing).attempt();
    if (!stored && stored.error().fault == Fault::LinkLost)
        co_return fail(stored.error());
    auto resetting = vendor({Command::SoftReset}, {});
    const Result<VendorReply> reply = co_await std::move(resetting).attempt();
    if (!reply && reply.error().fault == Fault::Timeout)
        co_return fail(Fault::Timeout, say("it did not come back"),
            say("without an application its bootloader is silent (scan shows it)"));
    if (!reply)
        co_return fail(reply.error());
    auto refreshing = doRefresh();
    co_await std::move(refreshing);
    co_return {};
}

Task<void> Controller::doRename(std::string name)
{
    auto bytes = toLatin1(name);
    if (!bytes)
        co_return fail(Fault::OutOfRange, say("a name may hold Latin-1 characters only"));
    if (bytes->empty() || bytes->size() > static_cast<std::size_t>(maxNameLength))
        co_return fail(Fault::OutOfRange, say("a name has 1 to 64 characters"));
    bytes->push_back(0); // the count of the command includes it, that of the descriptor does not (README.md#names)
    const auto count = static_cast<std::uint16_t>(bytes->size());
    auto set = vendor({Command::SetDevName, count}, std::move(*bytes));
    co_await std::move(set);
    auto get = getDescriptors();
    const DescriptorList list = co_await std::move(get);
    Identity known = identity();
    setDescriptors(known, list);
    setIdentity(known);
    if (known.name != name)
        co_return fail(Fault::BadCheck, say("the name was written, but the device answers '%1'", known.name));
    co_return {};
}

// Device number

Task<void> Controller::expectFree(int number)
{
    CanInbox inbox(m_can, clock(), [number, own = session()](const CanFrame &frame) {
        const auto response = decodeEnumResponse0(frame);
        return response && response->device == number && response->session != own;
    });
    for (int round = 0; round < 2; ++round) {
        if (auto sent = m_can.send(encodeEnumerate()); !sent)
            co_return fail(sent.error());
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
Task<FirmwareVersions> Controller::moveTo(int number)
{
    const int old = identity().address;
    Error last{Fault::Timeout, say("no answer")};
    for (int attempt = 0; attempt < numberTries; ++attempt) {
        VendorRequest request{old, session(), {Command::SetDevNumber, static_cast<std::uint16_t>(number)}, {}, number};
        auto setting
            = vendorExchange(m_can, clock(), std::move(request), {1, attemptsOf(Command::SetDevNumber).timeout});
        const Result<VendorReply> status = co_await std::move(setting).attempt();
        if (status) {
            if (auto checked = dmc60c::check(Command::SetDevNumber, *status); !checked)
                co_return fail(checked.error());
        } else if (status.error().fault != Fault::Timeout) {
            co_return fail(status.error());
        }
        VendorRequest question{number, session(), {Command::GetFwver}};
        auto asking = vendorExchange(m_can, clock(), std::move(question), patienceFor(Command::GetFwver));
        const Result<VendorReply> answer = co_await std::move(asking).attempt();
        const auto versions = answer ? decodeFirmwareVersions(answer->data) : std::nullopt;
        if (versions)
            co_return *versions;
        if (!answer)
            last = answer.error();
    }
    co_return fail(last);
}

Task<void> Controller::doRenumber(int address)
{
    if (address < 1 || address > maxDeviceNumber)
        co_return fail(Fault::OutOfRange, say("a device number is 1 … 63"));
    if (address == identity().address)
        co_return {};
    auto looking = expectFree(address);
    co_await std::move(looking);
    auto moving = moveTo(address);
    const FirmwareVersions versions = co_await std::move(moving);
    Identity known = identity();
    known.address = address;
    known.state = DeviceState::Online; // free a moment ago, so no duplicate
    setVersions(known, versions);
    setIdentity(std::move(known));
    co_return {};
}

} // namespace mb::dmc60c
