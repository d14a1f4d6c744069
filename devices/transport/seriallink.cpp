// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/seriallink.h"

#include "wire/number.h"

namespace mb {
namespace {

constexpr int usualRate = 115200;
constexpr int smoothing = 16;

std::optional<int> fixedRate(const LinkAddress &address)
{
    const auto text = address.option(address.isSimulated() ? "bitrate" : "baud");
    const auto rate = text ? wholeFrom<int>(*text) : std::nullopt;
    return rate && *rate > 0 ? rate : std::nullopt;
}

} // namespace

SerialLink::SerialLink(LinkAddress address, Clock &clock)
    : Link(std::move(address), LinkKind::Serial)
    , m_clock(clock)
    , m_fixed(fixedRate(this->address()))
    , m_baudrate(m_fixed.value_or(usualRate))
    , m_load(*this, clock)
{
}

Result<void> SerialLink::send(std::span<const std::uint8_t> bytes, Priority priority)
{
    if (state() != LinkState::Open)
        return fail(notOpen());
    if (bytes.empty())
        return fail(Fault::OutOfRange, say("nothing to send"));
    MB_TRY_VOID(doSend(bytes, priority));
    const Instant now = m_clock.now();
    m_load.count(now, bytes.size() * 10);
    passed(Traffic{now, Direction::Sent, nullptr, bytes});
    return {};
}

Result<void> SerialLink::setBaudrate(int baudrate)
{
    MB_TRY(const auto isNew, isNewRate(baudrate));
    if (isNew && state() == LinkState::Open) {
        MB_TRY_VOID(doSetBaudrate(baudrate));
    }
    m_baudrate = baudrate;
    m_isRateInDoubt = false;
    return {};
}

Task<void> SerialLink::setBaudrateSoon(int baudrate)
{
    const auto isNew = co_await isNewRate(baudrate);
    if (isNew && state() == LinkState::Open && settings().background) {
        m_isRateInDoubt = true; // whoever waits for it may go away
        co_await doSetBaudrateSoon(*settings().background, baudrate);
    } else if (auto set = setBaudrate(baudrate); !set) {
        co_return fail(set.error());
    }
    m_baudrate = baudrate;
    m_isRateInDoubt = false;
    co_return {};
}

Result<bool> SerialLink::isNewRate(int baudrate) const
{
    if (baudrate < slowest || baudrate > fastest)
        return fail(Fault::OutOfRange, say("%1 bit/s is no rate of a serial line", baudrate));
    return m_isRateInDoubt || baudrate != m_baudrate;
}

void SerialLink::noteRoundTrip(Duration time)
{
    m_roundTrip = m_roundTrip ? *m_roundTrip + (time - *m_roundTrip) / smoothing : time;
}

void SerialLink::deliver(Instant time, std::span<const std::uint8_t> bytes)
{
    m_load.count(time, bytes.size() * 10);
    passed(Traffic{time, Direction::Received, nullptr, bytes});
    m_received.notify(bytes);
}

void SerialLink::reportLineError()
{
    countError();
    m_lineErrors.notify();
}

} // namespace mb
