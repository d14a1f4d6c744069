// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/scope.h"
#include "families/quadquad2drv/packetport.h"
#include "families/quadquad2drv/parameters.h"
#include "model/device.h"
#include "telemetry/ratewishes.h"

#include <array>
#include <optional>

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
    /// Status bits of an axis (0…3) now.
    [[nodiscard]] Task<std::uint8_t> askStatus(int axis);
    /// How fast the velocity estimate is at present: packet 13.
    [[nodiscard]] Task<History> askHistory();
    /// Requests that make gains, limits and input of an axis what they are known or assumed to be.
    [[nodiscard]] std::vector<Bytes> settingsOf(int axis);
    /// The one of the input alone.
    [[nodiscard]] Bytes inputOf(int axis);
    /// Sends them whoever waits for it or not, once the axis is stopped.
    void putBack(std::vector<Bytes> requests);
    /// @}

    /// Until somebody gives the axis another one: a quarter, since wrong polarity means full speed away (README.md#polarity).
    static constexpr std::int64_t firstPowerLimit = 2048;

private:
    struct Drive {
        ControlMode mode = ControlMode::Off;
        bool shifted = false; ///< Readings::velocityTargetShifted when the mode was taken: never changed in motion
        std::optional<SetPoint> profile; ///< of a ramp under way, which is sent once
    };
    struct Tracked {
        std::optional<std::int64_t> position; ///< unwrapped
        std::uint8_t status = 0;
    };

    // Device: controllertasks.cpp
    Task<void> doRefresh() override;
    Task<std::int64_t> doRead(ParameterIndex index) override;
    Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) override;
    Task<bool> doStore(Progress &progress) override;
    Task<std::vector<FaultRecord>> doReadFaults() override;
    Task<std::vector<FaultRecord>> doClearFaults() override { return doReadFaults(); }
    Task<void> doIdentify() override;
    Task<void> doRestart() override;
    Task<void> doRename(std::string name) override;
    Task<void> doRenumber(int address) override;
    Task<void> doSetRate(ChannelIndex channel, double hertz) override;
    [[nodiscard]] Task<std::int64_t> readBoard(BoardParameter which);
    [[nodiscard]] Task<void> takeLayout();
    [[nodiscard]] Task<void> tellEverything();
    [[nodiscard]] Bytes groupRequest(int axis, AxisParameter which, std::int64_t raw);
    [[nodiscard]] Result<Bytes> writeRequest(ParameterIndex index, std::int64_t raw);
    [[nodiscard]] std::int64_t known(int axis, AxisParameter which);
    [[nodiscard]] Task<void> sendAll(std::vector<Bytes> requests);
    [[nodiscard]] Readings readings() const;
    void doProfileChanged() override;

    // Device, at once: controllermotion.cpp
    [[nodiscard]] Result<void> doCheck(const SetPoint &setPoint) const override;
    Result<void> doCommand(const SetPoint &setPoint) override;
    void doStop() override;
    [[nodiscard]] bool doIsSeenStopped() const override;
    [[nodiscard]] StopScript doStopScript() const override;
    void enter(int axis, ControlMode mode);
    void limitFirstMotion(int axis);
    void sendTarget(int axis, const SetPoint &setPoint);
    void noteSetPoint(int axis, std::optional<double> target);
    void post(Bytes request);
    void workOff();
    [[nodiscard]] Task<void> work();
    [[nodiscard]] Task<void> obey(Bytes order);
    [[nodiscard]] Task<void> confirmStop();
    void resetAsLastResort();

    // What the board tells, and what follows from silence: controller.cpp
    void onPacket(const Packet &packet, Instant time);
    void onMotion(const Motion &motion, Instant time);
    void onAxis(int axis, const AxisMotion &motion, Instant time);
    [[nodiscard]] std::int64_t unwrapped(int axis, std::int32_t position) const;
    [[nodiscard]] Task<void> poll();
    void schedulePoll();
    void look();
    [[nodiscard]] Task<void> checkReset();
    void detectReset(const DataMasks &masks);
    void forgetBoard();
    void updateLiveness();
    [[nodiscard]] std::optional<Mode> modeOf(int axis) const;

    SpiLink &m_spi;
    PacketPort m_port;
    std::array<Tracked, axes> m_tracked;
    std::array<Drive, axes> m_drives;
    std::uint16_t m_streamPeriod = 0;
    RateWishes m_wishes;
    bool m_told = false;           ///< a stream of ours runs, unless the board was reset
    bool m_changed = false;        ///< we told the board something that a reset undoes
    bool m_libraryPolarity = true; ///< as inputs were written last
    bool m_resetKnown = false;     ///< whether the board was reset before we came is known
    bool m_heard = false;
    bool m_restarted = false;
    bool m_polling = false;
    bool m_checking = false;
    bool m_learning = false;
    struct LastResort {
        int unanswered = 0; ///< stops in a row, since one was confirmed
        bool tried = false; ///< the reset line was pulsed
    } m_lastResort;
    bool m_stopConfirmed = false;
    std::optional<Instant> m_motionAt;
    std::optional<Instant> m_streamAt;
    std::deque<Bytes> m_orders; ///< of set-points, waiting for the board
    bool m_working = false;
    std::uint64_t m_stops = 0;           ///< what was ordered before the last one is not sent any more
    std::optional<Error> m_orderFailure; ///< ended the motion; the next command tells
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
