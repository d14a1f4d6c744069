// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/axisdrives.h"
#include "families/quadquad2drv/missedsamples.h"
#include "families/quadquad2drv/stopproof.h"

namespace mb::quadquad2drv {

/// One board with four axes. Asks for motion data while nobody streams, 100 times a second; setRate() makes the board stream.
/// Whoever writes or drives makes it tell position, velocity and status of every channel (data mask 0x2B): finding the
/// start-up masks again means that the board was reset, and `liveness().restarted` holds until refresh() succeeds. What its
/// profile says was written is lost then, also when the reset was before this program came.
class Controller final : public Device {
public:
    Controller(const Family &family, SpiLink &link, Clock &clock, Identity identity);

    /// @name For experiments (experiments.h)
    /// @{
    /// Sends a request and waits until the board has accepted it.
    [[nodiscard]] Task<void> tell(Bytes request);
    /// For what changes nothing.
    [[nodiscard]] PacketPort &port() { return m_port; }
    /// Those that make the settings of an axis what they are known or assumed to be.
    [[nodiscard]] SettingRequests &settings() { return m_settings; }
    /// Goes on whoever waits for it or not.
    void putBack(Task<void> restoring) { m_scope.spawn<void>(std::move(restoring)); }
    /// Of the board, that were noticed.
    [[nodiscard]] std::uint64_t resets() const { return m_layout.resets(); }
    /// @}

    Task<void> refresh() override;
    Task<bool> store(Progress &progress) override;
    Task<std::vector<FaultRecord>> readFaults() override;
    Task<std::vector<FaultRecord>> clearFaults() override { return readFaults(); }
    Task<void> renumber(int address) override;
    Task<void> setRate(ChannelIndex channel, double hertz) override;
    [[nodiscard]] Message caution(const SetPoint &setPoint) const override
    {
        return checkSetPoint(setPoint) ? cautionOf(setPoint, parameters()) : Message();
    }
    [[nodiscard]] bool isSeenStopped() const override;
    [[nodiscard]] StopScript stopScript() const override;

private:
    // Device, what asks and waits
    Task<std::int64_t> doRead(ParameterIndex index) override;
    Task<void> doMayWrite(ParameterIndex index, std::int64_t raw, std::span<const ParameterChange> before) override;
    Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) override;
    Task<void> doRestart() override;
    void doProfileChanged() override;

    // Device, at once
    [[nodiscard]] Result<void> doCheck(const SetPoint &setPoint) const override { return checkSetPoint(setPoint); }
    Result<void> doCommand(const SetPoint &setPoint) override;
    void doStop() override;

    // What the board tells, and what follows from silence
    void onPacket(const Packet &packet, Instant time);
    void onMotion(const Motion &motion, Instant time);
    void schedulePoll();
    void look();
    void breakLines();
    void onReset();
    void updateLiveness();

    SpiLink &m_spi;
    PacketPort m_port;
    BoardLayout m_layout;
    SettingRequests m_settings;
    AxisSense m_sense;
    OrderQueue m_orders;
    AxisDrives m_drives;
    StopProof m_stopProof;
    bool m_heard = false;
    bool m_polling = false;
    bool m_checking = false;
    bool m_learning = false;
    std::optional<Instant> m_motionAt;
    MissedSamples m_missed;
    Subscription m_received;
    Subscription m_readyRaised;
    Subscription m_state;
    Timer m_poll;
    Timer m_look;
    Scope m_scope; ///< last: its tasks use everything above
};

/// Family::open.
[[nodiscard]] std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity);

} // namespace mb::quadquad2drv
