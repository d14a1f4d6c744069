// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/boardlayout.h"

#include <algorithm>
#include <cmath>

namespace mb::quadquad2drv {

BoardLayout::BoardLayout(SpiLink &link, PacketPort &port, Clock &clock, Owner owner)
    : m_link(link)
    , m_port(port)
    , m_owner(std::move(owner))
    , m_rateTurns(clock)
{
}

Task<void> BoardLayout::read()
{
    const Packet masksReply = co_await m_port.request(getRequest(PacketId::GetDataMask));
    const Packet configReply = co_await m_port.request(getRequest(PacketId::GetStreamConfig));
    const Packet periodReply = co_await m_port.request(getRequest(PacketId::GetStreamPeriod));
    const auto masks = parseDataMasks(masksReply);
    const auto config = parseStreamConfig(configReply);
    const auto period = parseStreamPeriod(periodReply);
    if (!masks || !config || !period)
        co_return fail(Fault::BadReply, say("the stream settings have an unexpected length"));
    detectReset(*masks);
    m_port.setLayout(*masks, *config);
    m_streamPeriod = *period;
    m_link.watchReady(streamUnit * m_streamPeriod / 4); // whoever began it
    m_owner.streamChanged();
    co_return {};
}

Task<void> BoardLayout::expectNoReset()
{
    if (m_resetKnown)
        co_return {};
    co_await check();
    if (m_restarted)
        co_return fail(
            Fault::Unsafe, say("the board was reset since its settings were written"), say("look at it again"));
    co_return {};
}

Task<void> BoardLayout::tellEverything()
{
    co_await expectNoReset();
    co_await m_port.request(setDataMask(allAxes, datamask::everything));
    m_changed = true;
    co_await read();
    co_return {};
}

bool BoardLayout::tellsEverything() const
{
    const DataMasks &masks = m_port.masks();
    return std::ranges::all_of(masks, [](std::uint8_t mask) { return mask == datamask::everything; });
}

/// A board that was reset has its start-up data masks again. At the first look that tells of a reset since the settings in its
/// profile were written, by this run of the program or another one: all that write set other masks first.
Task<void> BoardLayout::check(int tries)
{
    const Packet reply = co_await m_port.request(getRequest(PacketId::GetDataMask), tries);
    const auto masks = parseDataMasks(reply);
    if (!masks)
        co_return fail(Fault::BadReply, say("the data masks have an unexpected length"));
    detectReset(*masks);
    if (*masks != m_port.masks()) // another program has changed what the board sends
        m_port.setLayout(*masks, m_port.streamConfig());
    co_return {};
}

/// Wherever the masks are seen: what is understood with the new ones must not hide what they mean.
void BoardLayout::detectReset(const DataMasks &masks)
{
    const bool startUp = std::ranges::all_of(masks, [](std::uint8_t mask) { return mask == datamask::startUp; });
    const bool told = m_changed && masks != m_port.masks();
    const bool before = !m_resetKnown && m_owner.holdsSettings();
    m_resetKnown = true;
    if (startUp && (told || before))
        forget();
}

void BoardLayout::forget()
{
    m_changed = m_holds = false;
    m_before.reset();
    m_rateOwed = m_wishes.highest() > 0.0;
    m_restarted = true;
    ++m_resets;
    m_streamPeriod = 0;
    m_port.setLayout({datamask::startUp, datamask::startUp, datamask::startUp, datamask::startUp}, 0);
    m_owner.reset();
}

Task<bool> BoardLayout::setRate(ChannelIndex channel, double hertz)
{
    m_wishes.set(channel, hertz);
    const bool another = co_await resumeRate();
    co_return another;
}

Task<bool> BoardLayout::resumeRate()
{
    const Turns::Turn turn = co_await m_rateTurns.take();
    const Result<bool> another = co_await followWishes().attempt();
    m_rateOwed = !another && (another.error().fault == Fault::Timeout || another.error().fault == Fault::LinkLost);
    co_return another;
}

void BoardLayout::chosen(ParameterIndex index, std::int64_t raw)
{
    if (m_before && index == indexOf(BoardParameter::StreamPeriod))
        m_before->period = static_cast<std::uint16_t>(raw);
    else if (m_before && index == indexOf(BoardParameter::StreamConfig))
        m_before->config = static_cast<std::uint8_t>(raw);
}

Task<bool> BoardLayout::followWishes()
{
    const double wished = m_wishes.highest();
    if (wished <= 0.0) {
        if (!m_before)
            co_return false;
        const Result<void> put = co_await putBack().attempt();
        if (!put) {
            m_owner.streamChanged(); // it may have ended all the same: then it is polled
            co_return fail(put.error());
        }
        co_return true;
    }
    const double units = 1e9 / wished / static_cast<double>(streamUnit.count());
    const auto period = static_cast<std::uint16_t>(std::clamp(std::round(units), 1.0 * fastestStream, 65535.0));
    if (period == m_streamPeriod && m_before) // another channel wishes the same, or more
        co_return false;
    if (!m_link.ready().has_value())
        co_return fail(
            Fault::Unsupported, say("without a ready line the board is asked 100 times a second, and cannot stream"));
    co_await begin(period);
    co_return true;
}

Task<void> BoardLayout::begin(std::uint16_t period)
{
    if (!m_before) {
        co_await expectNoReset();
        co_await read();
        m_before = Stream{m_port.masks(), m_port.streamConfig(), m_streamPeriod};
    }
    co_await tellEverything();
    co_await m_port.request(setStreamConfig(streamconfig::elapsed));
    co_await m_port.request(setStreamPeriod(period));
    co_await read();
    co_return {};
}

Task<void> BoardLayout::putBack()
{
    const Stream before = *m_before;
    co_await m_port.request(setStreamPeriod(0));
    m_streamPeriod = 0;
    co_await putMasksBack(before.masks);
    co_await m_port.request(setStreamConfig(before.config));
    if (before.period > 0)
        co_await m_port.request(setStreamPeriod(before.period));
    m_before.reset();
    co_await read();
    co_return {};
}

/// Not while they tell of a reset that would undo more.
Task<void> BoardLayout::putMasksBack(DataMasks before)
{
    if (m_holds || m_owner.holdsSettings())
        co_return {};
    m_changed = false;
    DataMasks masks = m_port.masks();
    for (std::size_t axis = 0; axis < axes && !m_holds; ++axis) {
        auto setting = m_port.request(setDataMask(static_cast<std::uint8_t>(1U << axis), before[axis]));
        co_await std::move(setting);
        masks[axis] = before[axis];
        m_port.setLayout(masks, m_port.streamConfig());
    }
    if (m_holds) { // somebody drives or writes since
        co_await tellEverything();
    }
    co_return {};
}

} // namespace mb::quadquad2drv
