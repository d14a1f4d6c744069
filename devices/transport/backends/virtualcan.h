// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "transport/canlink.h"

#include <deque>
#include <random>
#include <vector>

namespace mb {

class VirtualCanLink;

/// A CAN bus in memory, on the given clock, with the timing of a real one: frames take their exact number of bits
/// (stuff bits and intermission included), the lowest identifier wins arbitration, one frame at a time. Two controllers
/// that start the same identifier with different content destroy both frames: an error is counted at every controller,
/// and both try again after a short seeded delay. Frames are stamped with the end of the frame, delivered from the
/// clock queue.
class VirtualCanBus : NonCopyable {
public:
    VirtualCanBus(Clock &clock, int bitrate, std::uint64_t seed);

    [[nodiscard]] int bitrate() const { return m_bitrate; }
    [[nodiscard]] Clock &clock() const { return m_clock; }
    /// This fraction of frames is seen by nobody but its sender, 0…1.
    void setLoss(double fraction) { m_loss = fraction; }
    /// As controllers do: who collided tries again at once, collides again, and gives the frame up after 32 times.
    void setStubborn(bool stubborn) { m_stubborn = stubborn; }
    /// A controller at `link` leaves the bus, as after 256 transmit errors.
    void forceBusOff(VirtualCanLink &link);

private:
    friend class VirtualCanLink;
    void attach(VirtualCanLink &link);
    void detach(VirtualCanLink &link);
    void contend();
    void startFrame(const std::vector<VirtualCanLink *> &winners);
    void finishFrame();
    [[nodiscard]] Duration bits(int count) const { return Duration(std::chrono::seconds(1)) * count / m_bitrate; }
    void arm(Instant deadline);

    Clock &m_clock;
    int m_bitrate;
    double m_loss = 0.0;
    bool m_stubborn = false;
    std::mt19937_64 m_random;
    std::vector<VirtualCanLink *> m_links;
    std::vector<VirtualCanLink *> m_sending;
    CanFrame m_onWire;
    bool m_collision = false;
    Instant m_idleAt{};
    Instant m_armedFor{};
    Timer m_timer;
};

/// One controller on a virtual bus. Whoever simulates a device has one of these, the host has another.
class VirtualCanLink : public CanLink {
public:
    VirtualCanLink(LinkAddress address, VirtualCanBus &bus);
    ~VirtualCanLink() override;
    [[nodiscard]] std::unique_ptr<CanLink> makeAnotherEnd() override
    {
        return std::make_unique<VirtualCanLink>(address(), m_bus);
    }

private:
    friend class VirtualCanBus;
    struct Waiting {
        CanFrame frame;
        Instant readyAt{};
        bool urgent = false;
        int collisions = 0;
    };
    Result<void> doOpen() override;
    void doClose() override;
    Result<void> doSend(const CanFrame &frame, Priority priority) override;
    [[nodiscard]] std::size_t doBacklog() const override { return m_queue.size(); }
    [[nodiscard]] int doBitrate() const override { return m_bus.bitrate(); }

    VirtualCanBus &m_bus;
    std::deque<Waiting> m_queue;
    bool m_onWire = false; ///< the front of the queue is being sent
};

} // namespace mb
