// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/interview.h"
#include "families/supermodified/motion.h"
#include "families/supermodified/telemetrypolls.h"
#include "model/device.h"

#include <map>
#include <memory>
#include <optional>

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
    [[nodiscard]] bool isLineDriving() const { return m_line->isDriving(); }

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
    Task<void> doZeroPosition() override;

    [[nodiscard]] Task<Frame> talk(Line::Request request);
    [[nodiscard]] Task<std::int64_t> readNumber(Command command);
    [[nodiscard]] Task<void> writeNumber(Command command, std::int64_t raw);
    [[nodiscard]] Task<void> writeDuration(std::int64_t raw);
    void noteWritten(const Parameter &row, std::int64_t raw);
    void noteRead(const Parameter &row, std::int64_t raw);
    [[nodiscard]] std::vector<FaultRecord> faultRecords() const;
    [[nodiscard]] Error about(const Parameter &parameter, const Error &error) const;

    // Device, at once
    [[nodiscard]] Result<void> doMayMove() const override;
    [[nodiscard]] bool doOffers(ParameterIndex index) const override;
    [[nodiscard]] Result<void> doCheck(const SetPoint &setPoint) const override;
    [[nodiscard]] Message doCaution(const SetPoint &setPoint) const override;
    Result<void> doCommand(const SetPoint &setPoint) override;
    Result<void> doReleaseMoves() override;
    void doStop() override;
    void doRepeatStop() override { } // Motion repeats it until it is acknowledged
    [[nodiscard]] StopScript doStopScript() const override;
    [[nodiscard]] bool doIsSeenStopped() const override;

    // What the node says, and what follows
    void onAnswer(const Result<Frame> &reply);
    void onCodes(std::span<const std::uint8_t> codes);
    void onPosition(std::int64_t raw);
    void onOverheard(const Frame &frame);
    void onLinkState(LinkState state);
    void onMotion();
    void onStored(Command command, std::int64_t raw);
    void identityChanged();
    void doProfileChanged() override;
    void stopAsFollower();
    void setHeard(bool heard);
    void updateLiveness();

    SerialLink &m_serial;
    std::shared_ptr<Line> m_line;
    Node m_node;
    Motion m_motion;
    TelemetryPolls m_polls;
    struct Reported {
        std::int64_t count = 0;
        bool active = false;
    };
    std::map<std::uint8_t, Reported> m_codes; ///< since it was opened
    bool m_heard = false;
    bool m_restarted = false;
    bool m_energized = false;                ///< as onMotion() saw it last
    std::optional<std::int64_t> m_owedLimit; ///< the stored current limit, while the node takes a duration for it
    int m_misses = 0;
    bool m_missed = false;                  ///< the answer before the last one did not come
    std::optional<std::int64_t> m_position; ///< of the node
    std::optional<Instant> m_foreignAt;
    Timer m_foreignTimer;
    Timer m_followerStop;
    Subscription m_followersTold;
    Subscription m_overheard;
    Subscription m_linkState;
    Subscription m_identityChanged;
};

/// Family::open.
[[nodiscard]] std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity);

} // namespace mb::supermodified
