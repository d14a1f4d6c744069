// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/logpoller.h"
#include "families/abstractdc/motionsense.h"
#include "families/abstractdc/setpoints.h"
#include "model/device.h"

#include <map>
#include <set>

namespace mb::abstractdc {

/// One Abstract DC Drive. The drive never speaks by itself, so that everything known of it is polled: the position always, the
/// others where somebody wishes for them and where they mean something (logs that stand still outside their mode are not
/// recorded). It obeys the last set-point for ever, so that stop() sends both lengths of the stop, twice.
class Controller final : public Device {
public:
    Controller(const Family &family, CanLink &link, Clock &clock, Identity identity);

    /// The settings pages are blank, by order of this program.
    void settingsErased();

private:
    // Device, in controllertasks.cpp
    Task<void> doRefresh() override;
    Task<std::int64_t> doRead(ParameterIndex index) override;
    Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) override;
    Task<bool> doStore(Progress &progress) override;
    Task<std::vector<FaultRecord>> doReadFaults() override;
    Task<std::vector<FaultRecord>> doClearFaults() override;
    Task<void> doIdentify() override;
    Task<void> doRename(std::string name) override;
    Task<void> doRenumber(int address) override;
    Task<void> doSetRate(ChannelIndex channel, double hertz) override;

    [[nodiscard]] Task<void> expectAnswer();
    [[nodiscard]] Result<void> mayWrite(const Parameter &parameter, std::int64_t raw) const;
    [[nodiscard]] bool mayLowerAveraging(std::int64_t raw) const;
    [[nodiscard]] bool needsPowerCycle() const;
    void judgeSilence(std::int32_t position);
    [[nodiscard]] Task<void> save(Loop loop, Progress &progress);

    // Device, at once
    [[nodiscard]] Result<void> doMayMove() const override;
    void doProfileChanged() override;
    [[nodiscard]] Result<void> doCheck(const SetPoint &setPoint) const override;
    [[nodiscard]] Message doCaution(const SetPoint &setPoint) const override;
    Result<void> doCommand(const SetPoint &setPoint) override;
    void doStop() override;
    [[nodiscard]] Result<void> doMayStop() const override;
    [[nodiscard]] StopScript doStopScript() const override;
    [[nodiscard]] StopStep proofStep() const;
    [[nodiscard]] bool doIsSeenStopped() const override;

    void speak();
    void enter(std::optional<Loop> loop);
    void planPolling();
    [[nodiscard]] double rateOf(Log log) const;
    [[nodiscard]] bool isFresh(Log log) const;
    [[nodiscard]] std::optional<double> feedback(Loop loop) const;
    [[nodiscard]] bool isDriven() const { return m_loop && *m_loop != Loop::None; }

    void onFrame(const CanFrame &frame, bool ours);
    void onLog(Log log, std::int32_t value, Instant time);
    void onPosition(std::int32_t value, Instant time);
    void onVoltage(std::int32_t value, Instant time);
    void onSilence();
    void updateLiveness();

    CanLink &m_can;
    const Dialect *m_dialect = nullptr; ///< nullptr: not proven
    LogPoller m_poller;
    MotionSense m_sense;
    TargetLead m_lead;
    std::map<Log, double> m_wishes; ///< of setRate()

    std::optional<Loop> m_loop; ///< last commanded, by us or by somebody we heard; nothing: not known
    bool m_ours = false;        ///< by us
    std::int32_t m_sentTarget = 0;
    Instant m_sentAt{};
    std::optional<double> m_velocity; ///< in force, counts/s
    std::optional<Instant> m_foreignAt;
    bool m_saturated = false;
    bool m_wrapped = false; ///< since the motor was stopped last
    std::int64_t m_saturations = 0;
    std::int64_t m_wraps = 0;
    bool m_wasSilent = false;                     ///< since it was heard last, while its link was open
    std::optional<std::int64_t> m_positionBefore; ///< the silence
    std::set<Loop> m_unsaved;
    Timer m_look;
    Subscription m_received;
    Subscription m_sent; ///< of a recording: what its recorder had sent
    Subscription m_identityChanged;
};

/// Family::open.
[[nodiscard]] std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity);

} // namespace mb::abstractdc
