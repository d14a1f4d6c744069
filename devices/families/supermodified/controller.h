// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/codereports.h"
#include "families/supermodified/followerstop.h"
#include "families/supermodified/interview.h"
#include "families/supermodified/motion.h"
#include "families/supermodified/nodepresence.h"
#include "families/supermodified/nodesettings.h"
#include "families/supermodified/telemetrypolls.h"
#include "model/device.h"

#include <memory>

namespace mb::supermodified {

/// One node of a line. Asks for its telemetry all the time; everything it sends goes through the line, one request in flight.
/// There is no watchdog in the node: what ends a motion sends stop until it is acknowledged.
class Controller final : public Device {
public:
    Controller(const Family &family, SerialLink &link, Clock &clock, Identity identity);
    ~Controller() override;

    /// Asks nothing: somebody else talks to the node.
    void setAsleep(bool asleep) { m_polls.setPaused(asleep); }
    /// A motor of this or of another node of the line is driven.
    [[nodiscard]] bool isLineDriving() const { return m_line->driven().any(); }
    /// Another node of the line, as far as it is known.
    [[nodiscard]] std::optional<int> neighbour() const { return m_line->roster().neighbourOf(m_node.id); }

    Task<void> refresh() override;
    Task<bool> store(Progress &progress) override;
    Task<std::vector<FaultRecord>> readFaults() override;
    Task<std::vector<FaultRecord>> clearFaults() override;
    Task<void> renumber(int address) override;
    Task<void> setRate(ChannelIndex channel, double hertz) override;
    Task<void> zeroPosition() override;
    [[nodiscard]] bool offers(ParameterIndex index) const override { return m_settings.offers(index); }
    [[nodiscard]] Message caution(const SetPoint &setPoint) const override;
    [[nodiscard]] StopScript stopScript() const override;
    [[nodiscard]] bool isSeenStopped() const override;

private:
    // Device, what asks and waits
    Task<std::int64_t> doRead(ParameterIndex index) override { return m_settings.read(index); }
    Task<void> doMayWrite(ParameterIndex index, std::int64_t raw, std::span<const ParameterChange> before) override;
    Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) override { return m_settings.write(index, raw); }

    // Device, at once
    [[nodiscard]] Result<void> doCheck(const SetPoint &setPoint) const override { return m_motion.check(setPoint); }
    [[nodiscard]] Result<void> doMayMove() const override;
    Result<void> doCommand(const SetPoint &setPoint) override;
    Result<void> doReleaseMoves() override { return m_motion.release(); }
    void doStop() override;
    void repeatStop() override { } // Motion repeats it until it is acknowledged

    // What the node says, and what follows
    void onAnswer(const Result<Frame> &reply);
    void onCodes(std::span<const std::uint8_t> codes);
    void onMotion();
    void identityChanged();
    void doProfileChanged() override;
    void setHeard(bool heard);
    void updateLiveness();

    SerialLink &m_serial;
    std::shared_ptr<Line> m_line;
    Node m_node;
    Motion m_motion;
    TelemetryPolls m_polls;
    NodeSettings m_settings;
    NodePresence m_presence;
    CodeReports m_codes;
    FollowerStop m_followerStop;
    std::weak_ptr<bool> m_zeroing; ///< held by zeroPosition(), which may outlive this
    bool m_energized = false;      ///< as onMotion() saw it last
    Subscription m_linkState;
    Subscription m_identityChanged;
};

/// Family::open.
[[nodiscard]] std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity);

} // namespace mb::supermodified
