// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/fakeunit.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mb::test {

FakeUnit::FakeUnit(VirtualCanBus &bus, Clock &clock)
    : m_clock(clock)
    , m_link(*LinkAddress::parse("sim:can"), bus)
    , m_received(m_link.received().add([this](const CanFrame &frame) { hear(frame); }))
{
    EXPECT_TRUE(m_link.open());
}

void FakeUnit::answer(const std::string &request, std::vector<Frames> answers, Duration delay)
{
    m_scripts[request] = {std::move(answers), 0, delay};
}

void FakeUnit::send(std::string_view frame)
{
    const auto parsed = canFrameFromText(frame);
    ASSERT_TRUE(parsed) << frame;
    EXPECT_TRUE(m_link.send(*parsed));
}

void FakeUnit::every(Duration period, std::string frame)
{
    m_periodic.emplace_back(m_clock, period, std::move(frame));
    repeat(m_periodic.back());
}

void FakeUnit::repeat(Periodic &periodic)
{
    send(periodic.frame);
    periodic.timer.startIn(periodic.period, [this, &periodic] { repeat(periodic); });
}

int FakeUnit::count(std::string_view frame) const
{
    return static_cast<int>(std::count(m_heard.begin(), m_heard.end(), frame));
}

void FakeUnit::hear(const CanFrame &frame)
{
    m_heard.push_back(toText(frame));
    const auto script = m_scripts.find(m_heard.back());
    if (script == m_scripts.end() || script->second.answers.empty())
        return;
    Script &s = script->second;
    const Frames frames = s.answers[s.next];
    s.next = std::min(s.next + 1, s.answers.size() - 1);
    m_clock.arm(m_clock.now() + s.delay, [this, frames] {
        for (const std::string &text : frames)
            send(text);
    });
}

} // namespace mb::test
