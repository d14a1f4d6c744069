// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "transport/backends/virtualcan.h"

#include <list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mb::test {

/// A unit on a virtual CAN bus that knows no protocol: it logs what it hears and answers literal frames with literal
/// frames, as a script says. Fails on request by not answering.
class FakeUnit {
public:
    using Frames = std::vector<std::string>;

    FakeUnit(VirtualCanBus &bus, Clock &clock);

    /// From now on, `request` gets these answers, one set after the other, the last one for ever. An empty set is
    /// silence.
    void answer(
        const std::string &request, std::vector<Frames> answers, Duration delay = std::chrono::microseconds(200));
    void send(std::string_view frame);
    /// Sends a frame at once and then periodically, until endPeriodic().
    void every(Duration period, std::string frame);
    void endPeriodic() { m_periodic.clear(); }

    [[nodiscard]] const Frames &heard() const { return m_heard; }
    [[nodiscard]] int count(std::string_view frame) const;
    [[nodiscard]] VirtualCanLink &link() { return m_link; }

private:
    struct Script {
        std::vector<Frames> answers;
        std::size_t next = 0;
        Duration delay{};
    };
    struct Periodic {
        Periodic(Clock &clock, Duration p, std::string text)
            : period(p)
            , frame(std::move(text))
            , timer(clock)
        {
        }
        Duration period;
        std::string frame;
        Timer timer;
    };
    void hear(const CanFrame &frame);
    void repeat(Periodic &periodic);

    Clock &m_clock;
    VirtualCanLink m_link;
    std::map<std::string, Script> m_scripts;
    std::list<Periodic> m_periodic;
    Frames m_heard;
    Subscription m_received;
};

} // namespace mb::test
