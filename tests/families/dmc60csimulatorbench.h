// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/virtualclock.h"
#include "families/dmc60c/protocol.h"
#include "families/dmc60c/simulator.h"
#include "transport/backends/virtualcan.h"
#include "wire/bytes.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace mb::test::dmc60csim {

/// A host, a bus and one simulated DMC60C in virtual time; everything the host hears and every event is kept. Frames
/// are written as candump does: `0206FC05#3412610000000000`.
class Dmc60cBench {
public:
    explicit Dmc60cBench(const std::string &unit = "dmc60c:5,session=0x1234", std::uint64_t seed = 1)
        : m_bus(m_clock, dmc60c::bitrate, 1)
        , m_host(*LinkAddress::parse("sim:can"), m_bus)
        , m_port(*LinkAddress::parse("sim:can"), m_bus)
    {
        EXPECT_TRUE(m_host.open());
        EXPECT_TRUE(m_port.open());
        m_received = m_host.received().add([this](const CanFrame &frame) { m_heard.push_back(frame); });
        m_device = make(unit, seed, m_port);
        m_events = m_device->events().add([this](const SimulatorEvent &event) { m_log.push_back(event); });
    }

    std::unique_ptr<Simulator> make(const std::string &text, std::uint64_t seed, CanLink &link)
    {
        auto unit = SimulatedUnit::parse(text);
        EXPECT_TRUE(unit) << text;
        unit->seed = seed;
        auto made = dmc60c::simulate(link, m_clock, *unit);
        EXPECT_TRUE(made) << text;
        return std::move(*made);
    }

    void send(std::string_view text) { send(*canFrameFromText(text)); }
    void send(const CanFrame &frame) { EXPECT_TRUE(m_host.send(frame)); }
    void advance(Duration time) { m_clock.advance(time); }

    /// Waits for this frame among those heard after `since`; false when it did not come in time.
    bool hears(std::string_view text, Duration limit = std::chrono::milliseconds(300))
    {
        const CanFrame wanted = *canFrameFromText(text);
        return waitFor([&](const CanFrame &frame) { return sameContent(frame, wanted); }, limit) != nullptr;
    }
    /// The next frame of this message (identifier without the number) that was not looked at yet.
    const CanFrame *next(std::uint32_t message, Duration limit = std::chrono::milliseconds(300))
    {
        return waitFor([&](const CanFrame &frame) { return (frame.id & dmc60c::id::messageMask) == message; }, limit);
    }
    /// Frames not looked at yet that are no status frames.
    std::vector<std::string> answers()
    {
        std::vector<std::string> texts;
        for (; m_seen < m_heard.size(); ++m_seen) {
            if ((m_heard[m_seen].id & 0x1FFFFF00U) != dmc60c::id::statusGeneral)
                texts.push_back(toText(m_heard[m_seen]));
        }
        return texts;
    }
    std::size_t count(std::uint32_t message) const
    {
        return static_cast<std::size_t>(std::count_if(m_heard.begin(), m_heard.end(),
            [message](const CanFrame &frame) { return (frame.id & dmc60c::id::messageMask) == message; }));
    }
    const CanFrame *last(std::uint32_t message) const
    {
        const auto found = std::find_if(m_heard.rbegin(), m_heard.rend(),
            [message](const CanFrame &frame) { return (frame.id & dmc60c::id::messageMask) == message; });
        return found == m_heard.rend() ? nullptr : &*found;
    }
    void forget()
    {
        m_heard.clear();
        m_seen = 0;
        m_log.clear();
    }
    /// Sends `text` every 20 ms for `time`, the first at once.
    void drive(std::string_view text, Duration time)
    {
        const Instant end = m_clock.now() + time;
        while (m_clock.now() < end) {
            send(text);
            advance(std::min<Duration>(dmc60c::controlPeriod, end - m_clock.now()));
        }
    }
    /// The device has heard its first frame and sends status.
    void wake()
    {
        send("00000240#");
        advance(std::chrono::milliseconds(150));
        forget();
    }
    const SimulatorEvent *event(std::string_view what) const
    {
        const auto found
            = std::find_if(m_log.begin(), m_log.end(), [what](const SimulatorEvent &e) { return e.what == what; });
        return found == m_log.end() ? nullptr : &*found;
    }
    std::string eventNames() const
    {
        std::string names;
        for (const SimulatorEvent &e : m_log)
            names += (names.empty() ? "" : " ") + e.what;
        return names;
    }

    VirtualClock &clock() { return m_clock; }
    VirtualCanBus &bus() { return m_bus; }
    CanLink &host() { return m_host; }
    VirtualCanLink &port() { return m_port; }
    Simulator &device() { return *m_device; }
    void removeDevice() { m_device.reset(); }
    const std::vector<CanFrame> &heard() const { return m_heard; }

    /// What general status says now.
    std::int32_t duty() const { return signExtend(readU16le(last(dmc60c::id::statusGeneral)->bytes(), 0), 16); }
    int mode() const { return last(dmc60c::id::statusGeneral)->data[4] >> 3 & 15; }
    std::int32_t velocity() const { return signExtend(readU16be(last(dmc60c::id::statusEncoder)->bytes(), 3), 16); }
    std::int32_t position() const
    {
        const auto &d = last(dmc60c::id::statusEncoder)->data;
        return signExtend(static_cast<std::uint32_t>(d[0] << 16 | d[1] << 8 | d[2]), 24);
    }

private:
    template <class Match> const CanFrame *waitFor(Match match, Duration limit)
    {
        const Instant end = m_clock.now() + limit;
        while (true) {
            for (; m_seen < m_heard.size(); ++m_seen) {
                if (match(m_heard[m_seen]))
                    return &m_heard[m_seen++];
            }
            if (m_clock.now() >= end)
                return nullptr;
            const std::size_t known = m_heard.size();
            m_clock.runUntil([&] { return m_heard.size() > known; }, end - m_clock.now());
            if (m_heard.size() == known)
                m_clock.advance(std::max<Duration>(Duration::zero(), end - m_clock.now()));
        }
    }

    VirtualClock m_clock;
    VirtualCanBus m_bus;
    VirtualCanLink m_host;
    VirtualCanLink m_port;
    std::vector<CanFrame> m_heard;
    std::size_t m_seen = 0;
    std::vector<SimulatorEvent> m_log;
    std::unique_ptr<Simulator> m_device;
    Subscription m_received;
    Subscription m_events;
};

/// `0206FC05#3412…` from parts: session 0x1234, device 5.
inline CanFrame vendorCommand(
    std::uint16_t command, std::uint16_t first = 0, std::uint16_t second = 0, std::uint16_t session = 0x1234)
{
    std::array<std::uint8_t, 8> bytes{};
    writeU16le(bytes, 0, session);
    writeU16le(bytes, 2, command);
    writeU16le(bytes, 4, first);
    writeU16le(bytes, 6, second);
    return extendedFrame(dmc60c::id::vendorCommand | 5U, bytes);
}

inline CanFrame parameterSet(std::uint8_t id, std::int64_t raw, std::uint16_t session = 0x1234)
{
    std::array<std::uint8_t, 7> bytes{};
    writeU16le(bytes, 0, session);
    bytes[2] = id;
    writeU32le(bytes, 3, static_cast<std::uint32_t>(raw & 0xFFFFFFFF));
    return extendedFrame(dmc60c::id::paramSet | 5U, bytes);
}

inline CanFrame parameterRequest(std::uint8_t id)
{
    return extendedFrame(dmc60c::id::paramRequest | 5U, {0x34, 0x12, id});
}

/// A control frame of device 5, target in bytes 3, 4, 5 as H, L, M.
inline CanFrame control(int mode, std::int32_t target, int flags0 = 0, int flags1 = 0, int ramp = 0, int device = 5)
{
    const auto raw = static_cast<std::uint32_t>(target);
    const auto octet = [](std::uint32_t value) { return static_cast<std::uint8_t>(value & 0xFFU); };
    return extendedFrame(dmc60c::id::control | static_cast<std::uint32_t>(device),
        {octet(static_cast<std::uint32_t>(mode | flags0)), octet(static_cast<std::uint32_t>(flags1)), 0,
            octet(raw >> 16U), octet(raw), octet(raw >> 8U), octet(static_cast<std::uint32_t>(ramp)),
            octet(static_cast<std::uint32_t>(ramp >> 8))});
}

inline void drive(Dmc60cBench &bench, const CanFrame &frame, Duration time)
{
    bench.drive(toText(frame), time);
}

inline void set(Dmc60cBench &bench, std::uint8_t id, std::int64_t raw)
{
    bench.send(parameterSet(id, raw));
    const CanFrame *answer = bench.next(dmc60c::id::paramResponse);
    ASSERT_NE(answer, nullptr);
    ASSERT_EQ(answer->data[5], 0) << int{id};
}

inline std::int64_t get(Dmc60cBench &bench, std::uint8_t id)
{
    bench.send(parameterRequest(id));
    const CanFrame *answer = bench.next(dmc60c::id::paramResponse);
    return answer == nullptr ? -1 : signExtend(readU32le(answer->bytes(), 1), 32);
}

/// State of a device after its supply came back, and what it says it runs.
struct Enumerated {
    int images = -1; ///< 0 application, 1 bootloader, −1 silent
    int version = -1;
    int session = 0;
};

inline Enumerated enumerate(Dmc60cBench &bench)
{
    bench.advance(std::chrono::milliseconds(500));
    bench.forget();
    bench.send("00000240#");
    bench.advance(std::chrono::milliseconds(100));
    Enumerated found;
    for (const CanFrame &frame : bench.heard()) {
        if ((frame.id & dmc60c::id::messageMask) != dmc60c::id::enumResponse || frame.size != 8)
            continue;
        found.session = readU16le(frame.bytes(), 0);
        found.images = frame.data[2] & 3;
        found.version = readU16le(frame.bytes(), 4);
    }
    return found;
}

} // namespace mb::test::dmc60csim
