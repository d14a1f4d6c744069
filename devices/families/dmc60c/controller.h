// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/faultwatch.h"
#include "families/dmc60c/presence.h"
#include "families/dmc60c/statusrates.h"
#include "families/dmc60c/statussense.h"

#include <array>

namespace mb::dmc60c {

/// One DMC60C. Listens to its number on the bus all the time: telemetry, liveness, restarts, other masters. Talks only
/// in tasks and control frames, with three exceptions, none while the device is busy: it enumerates the bus when the
/// device is silent or its session looks wrong (README.md#bootloader), asks for a period when frames seem to be missing, and once a
/// second for the faults that no status frame tells (README.md#hidden-faults); that question clears none. When either is not answered
/// it enumerates as well.
///
/// A new session under the number, with the old one silent, is the unit after a power cycle: it is adopted, and
/// `liveness().restarted` holds until refresh() succeeds. With both answering, the identity becomes a duplicate.
/// Nothing is driven until that is judged.
class Controller final : public Device {
public:
    Controller(const Family &family, CanLink &link, Clock &clock, Identity identity);

    Task<void> refresh() override;
    Task<bool> store(Progress &progress) override { return m_desk.store(progress); }
    Task<std::vector<FaultRecord>> readFaults() override { return m_desk.faults(false); }
    Task<std::vector<FaultRecord>> clearFaults() override { return m_desk.faults(true); }
    Task<void> identify() override;
    Task<void> rename(std::string name) override;
    Task<void> renumber(int address) override;
    Task<void> setRate(ChannelIndex channel, double hertz) override { return m_rates.set(channel, hertz); }
    [[nodiscard]] StopScript stopScript() const override;
    [[nodiscard]] bool isSeenStopped() const override;

private:
    // Device, what asks and waits
    Task<std::int64_t> doRead(ParameterIndex index) override;
    Task<void> doMayWrite(ParameterIndex index, std::int64_t raw, std::span<const ParameterChange> before) override;
    Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) override;
    Task<void> doRestart() override;

    // Device, at once
    [[nodiscard]] Result<void> doCheck(const SetPoint &setPoint) const override;
    [[nodiscard]] Result<void> doMayMove() const override;
    Result<void> doCommand(const SetPoint &setPoint) override;
    void doStop() override;

    // What the bus tells, and what follows from it
    void onFrame(const CanFrame &frame);
    void onGeneral(const StatusGeneral &status, Instant time);
    void onParameter(const ParamResponse &response);
    void onVendorStatus(const VendorStatus &status);
    void onVersions(const EnumResponse1 &response);
    void askPeriod(std::uint8_t parameter);
    void askFaults();
    void sessionChanged();
    void restarted();
    void updateLiveness();
    void setState(DeviceState state, Message detail);
    [[nodiscard]] Presence::Owner owner();

    CanLink &m_can;
    UnitContact m_contact;
    VendorOrders m_orders;
    ParameterDesk m_desk;
    StatusRates m_rates;
    StatusSense m_sense;
    FaultWatch m_faultWatch;
    Presence m_presence;
    Timer m_unanswered; ///< a question that no task waits for
    bool m_restarted = false;
    Instant m_periodAskedAt{};
    std::array<std::uint32_t, 9> m_livenessKey{};
    int m_wakes = 0;         ///< frames that are still to take the device out of its halt
    Instant m_commandedAt{}; ///< the latest set-point
    bool m_isBraked = false; ///< it overrode the unit's button
    Subscription m_received;
    Subscription m_identityChanged;
};

/// Family::open.
[[nodiscard]] std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity);

} // namespace mb::dmc60c
