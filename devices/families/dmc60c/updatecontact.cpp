// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/updatecontact.h"

#include "families/dmc60c/unitidentity.h"

#include <algorithm>
#include <utility>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr Duration lateness = 500ms; ///< of an answer after its time-out
constexpr int mostLate = 100;        ///< frames of late answers
constexpr Attempts serialAttempts{8, 100ms};

/// Asked again, it changes nothing, and its answer is told from those to orders.
bool isQuestion(Command command)
{
    return command == Command::GetFwver || command == Command::GetDescriptors || command == Command::GetFlashSeqnum;
}

} // namespace

UpdateContact::UpdateContact(Device &device)
    : m_device(device)
    , m_link(static_cast<CanLink &>(device.link()))
    , m_clock(device.clock())
    , m_serial(device.identity().serial)
    , m_session(static_cast<std::uint16_t>(device.identity().session.value_or(0)))
{
    if (m_serial.empty() && device.identity().session)
        m_known = m_session;
}

void UpdateContact::takeSession(std::uint16_t session)
{
    if (std::exchange(m_session, session) == session)
        return;
    Identity identity = m_device.identity();
    identity.session = session;
    m_device.setIdentity(std::move(identity));
}

Task<VendorReply> UpdateContact::send(
    VendorCommand command, std::vector<std::uint8_t> data, Attempts attempts, Duration gap)
{
    if (m_answerOwed && !isQuestion(command.command))
        co_await settle();
    m_sentAt = m_clock.now();
    VendorRequest request;
    request.device = m_device.identity().address;
    request.session = m_session;
    request.command = command;
    request.data = std::move(data);
    request.gap = gap;
    Result<VendorReply> reply = co_await vendorExchange(m_link, m_clock, std::move(request), attempts).attempt();
    m_answerOwed = m_answerOwed || !reply || reply->unanswered > 0;
    co_return reply;
}

Task<void> UpdateContact::settle()
{
    CanInbox inbox(m_link, m_clock, [number = m_device.identity().address](const CanFrame &frame) {
        return (decodeVendorStatus(frame) || decodeVendorData(frame)) && deviceOf(frame) == number;
    });
    for (int i = 0; i < mostLate; ++i) {
        const Result<CanFrame> late = co_await inbox.next(lateness);
        if (late)
            continue;
        if (late.error().fault != Fault::Timeout)
            co_return fail(late.error());
        break;
    }
    m_answerOwed = false;
    co_return {};
}

Task<FirmwareVersions> UpdateContact::versions()
{
    const VendorReply reply = co_await order(Command::GetFwver);
    co_await check(Command::GetFwver, reply);
    const auto decoded = decodeFirmwareVersions(reply.data);
    if (!decoded)
        co_return fail(Fault::BadReply, say("GetFwver answered with %1 bytes", reply.data.size()));
    co_return *decoded;
}

Task<std::vector<UpdateContact::Unit>> UpdateContact::enumerate(Duration window)
{
    const int number = m_device.identity().address;
    CanInbox inbox(m_link, m_clock, [number](const CanFrame &frame) {
        return (frame.id & id::messageMask) == id::enumResponse && deviceOf(frame) == number;
    });
    co_await m_link.send(encodeEnumerate());
    std::vector<Unit> units;
    const auto unitOf = [&units](std::uint16_t session) -> Unit & {
        const auto known = std::ranges::find(units, session, &Unit::session);
        return known != units.end() ? *known : units.emplace_back(Unit{session, {}, {}});
    };
    const Instant end = m_clock.now() + window;
    while (m_clock.now() < end) {
        const Result<CanFrame> frame = co_await inbox.next(end - m_clock.now());
        if (!frame && frame.error().fault == Fault::LinkLost)
            co_return fail(frame.error());
        if (!frame)
            break;
        if (const auto first = decodeEnumResponse0(*frame))
            unitOf(first->session).productId = first->productId;
        else if (const auto second = decodeEnumResponse1(*frame))
            unitOf(second->session).versions = FirmwareVersions{second->image, second->application, second->bootloader};
    }
    std::erase_if(units, [](const Unit &u) { return !u.versions || !u.productId; });
    co_return units;
}

Task<UpdateContact::Unit> UpdateContact::findAgain(Duration limit)
{
    const Instant end = m_clock.now() + limit;
    while (m_clock.now() < end) {
        const std::vector<Unit> units = co_await enumerate(enumWindow);
        if (units.size() > 1)
            co_return fail(Fault::Unsafe, say("several units answer as number %1", m_device.identity().address));
        if (units.size() == 1) {
            co_await expectSame(units.front().session);
            takeSession(units.front().session);
            co_return units.front();
        }
    }
    co_return fail(Fault::Timeout, say("the unit does not answer an enumeration"));
}

/// A unit has another session once it lost its supply, and so has the one that was put in its place.
Task<void> UpdateContact::expectSame(std::uint16_t session)
{
    if (m_known == session)
        co_return {};
    const int number = m_device.identity().address;
    if (m_serial.empty() && m_known)
        co_return fail(Fault::Unsafe,
            say("the unit with number %1 has another session than before, and may be another unit: its serial number "
                "was "
                "not known",
                number),
            say("scan again, and update it if it is the one that is meant"));
    if (!m_serial.empty()) {
        const std::string serial = co_await serialOf(session);
        if (serial != m_serial)
            co_return fail(Fault::Unsafe,
                say("another unit answers as number %1: serial number '%2' instead of '%3'", number, serial, m_serial),
                say("scan again, and update it if it is the one that is meant"));
    }
    m_known = session;
    co_return {};
}

Task<std::string> UpdateContact::serialOf(std::uint16_t session)
{
    VendorRequest request{m_device.identity().address, session, {Command::GetDescriptors}};
    auto exchange = vendorExchange(m_link, m_clock, std::move(request), serialAttempts);
    const Result<VendorReply> reply = co_await std::move(exchange).attempt();
    m_answerOwed = m_answerOwed || !reply || reply->unanswered > 0;
    if (!reply)
        co_return fail(reply.error());
    const auto list = co_await descriptorsIn(*reply);
    Identity told;
    setDescriptors(told, list);
    co_return told.serial;
}

Task<VendorReply> UpdateContact::order(Command command)
{
    return send({command}, {}, attemptsOf(command), {});
}

} // namespace mb::dmc60c
