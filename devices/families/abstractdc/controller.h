// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/leadprobe.h"
#include "families/abstractdc/logsense.h"
#include "families/abstractdc/powercycledebt.h"
#include "families/abstractdc/setpoints.h"
#include "families/abstractdc/settingsdesk.h"

namespace mb::abstractdc {

/// One Abstract DC Drive. The drive never speaks by itself, so that everything known of it is polled: the position always, the
/// others where somebody wishes for them and where they mean something (logs that stand still outside their mode are not
/// recorded). It obeys the last set-point for ever, so that stop() sends both lengths of the stop, twice.
class Controller final : public Device {
public:
    Controller(const Family &family, CanLink &link, Clock &clock, Identity identity);

    /// The settings pages are other ones, by order of this program: blank, or what an image has there.
    void settingsReplaced(bool blank);

    Task<void> refresh() override;
    Task<bool> store(Progress &progress) override { return m_desk.store(progress); }
    Task<std::vector<FaultRecord>> readFaults() override;
    Task<std::vector<FaultRecord>> clearFaults() override;
    Task<void> renumber(int address) override;
    Task<void> setRate(ChannelIndex channel, double hertz) override;
    [[nodiscard]] Message caution(const SetPoint &setPoint) const override;
    [[nodiscard]] StopScript stopScript() const override;
    [[nodiscard]] bool isSeenStopped() const override;

private:
    // Device, what asks and waits
    Task<std::int64_t> doRead(ParameterIndex index) override;
    Task<void> doMayWrite(ParameterIndex index, std::int64_t raw, std::span<const ParameterChange> before) override;
    Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) override;

    // Device, at once
    [[nodiscard]] Result<void> doCheck(const SetPoint &setPoint) const override;
    [[nodiscard]] Result<void> doMayMove() const override;
    void doProfileChanged() override;
    Result<void> doCommand(const SetPoint &setPoint) override;
    void doStop() override;
    [[nodiscard]] Result<void> doMayStop() const override;

    // What the bus tells, and what follows from it
    [[nodiscard]] LogSense::Owner owner();
    void speak();
    void enter(std::optional<Loop> loop, Instant time);
    void sendStop();
    void onFrame(const CanFrame &frame, bool ours);
    void onSent(const CanFrame &frame);
    void onSilence();
    void onRestart(Restart restart);
    void breakLines();
    void updateLiveness();

    CanLink &m_can;
    LogSense m_logs;
    PowerCycleDebt m_debt;
    SettingsDesk m_desk;
    TargetLead m_lead;
    LeadProbe m_probe;
    bool m_ours = false;          ///< the loop was commanded by us
    bool m_isHeldByOther = false; ///< for ever, also where it stands and after a silence (README.md#no-watchdog)
    bool m_restarted = false;     ///< Liveness::restarted
    std::int32_t m_sentTarget = 0;
    Instant m_sentAt{};
    std::optional<Instant> m_foreignAt; ///< somebody else's set-point, or the stop of ours
    Subscription m_received;
    Subscription m_sent; ///< to all drives; of a recording: whatever its recorder had sent
    Subscription m_identityChanged;
};

/// Family::open.
[[nodiscard]] std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity);

} // namespace mb::abstractdc
