// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/faultwatch.h"
#include "families/dmc60c/flashproof.h"
#include "families/dmc60c/parameterexchange.h"
#include "families/dmc60c/statusstream.h"
#include "families/dmc60c/vendor.h"
#include "model/device.h"
#include "model/ratewishes.h"

#include <map>
#include <optional>

namespace mb::dmc60c {

/// One DMC60C. Listens to its number on the bus all the time: telemetry, liveness, restarts, other masters. Talks only
/// in tasks and control frames, with three exceptions, none while the device is busy: it enumerates the bus when the
/// device is silent or its session looks wrong (README.md#bootloader), asks for a period when frames seem to be missing, and once a
/// second for the faults that no status frame tells (README.md#hidden-faults); that question clears none.
///
/// A new session under the number, with the old one silent, is the unit after a power cycle: it is adopted, and
/// `liveness().restarted` holds until refresh() succeeds. With both answering, the identity becomes a duplicate.
class Controller final : public Device {
public:
    Controller(const Family &family, CanLink &link, Clock &clock, Identity identity);

private:
    static constexpr Duration enumeratePeriod = std::chrono::seconds(2); ///< while the device is silent
    /// The latest answer to an enumeration starts after 63.5 ms.
    static constexpr Duration candidateStep = std::chrono::milliseconds(70);

    // Device, in controllertasks.cpp and controllerparameters.cpp
    Task<void> doRefresh() override;
    Task<std::int64_t> doRead(ParameterIndex index) override;
    Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) override;
    Task<bool> doStore(Progress &progress) override;
    Task<std::vector<FaultRecord>> doReadFaults() override;
    Task<std::vector<FaultRecord>> doClearFaults() override;
    Task<void> doIdentify() override;
    Task<void> doRestart() override;
    Task<void> doRename(std::string name) override;
    Task<void> doRenumber(int address) override;
    Task<void> doSetRate(ChannelIndex channel, double hertz) override;

    [[nodiscard]] Task<VendorReply> vendor(VendorCommand command, std::vector<std::uint8_t> data);
    [[nodiscard]] Task<FirmwareVersions> getVersions();
    [[nodiscard]] Task<DescriptorList> getDescriptors();
    [[nodiscard]] Task<std::uint32_t> flashSequence();
    [[nodiscard]] Task<std::int64_t> readId(std::uint8_t parameter);
    [[nodiscard]] Task<std::int64_t> writeSetting(const Parameter &parameter, std::int64_t raw);
    [[nodiscard]] Task<std::int64_t> clearCounter(const Parameter &parameter, std::int64_t raw);
    [[nodiscard]] Task<std::vector<FaultRecord>> gatherFaults(bool clear);
    [[nodiscard]] Task<void> expectFree(int number);
    [[nodiscard]] Task<FirmwareVersions> moveTo(int number);

    // Device, at once
    [[nodiscard]] Result<void> doCheck(const SetPoint &setPoint) const override;
    Result<void> doCommand(const SetPoint &setPoint) override;
    void doStop() override;
    [[nodiscard]] StopScript doStopScript() const override;
    [[nodiscard]] bool doIsSeenStopped() const override;

    // What the bus tells
    void onFrame(const CanFrame &frame);
    void onGeneral(const StatusGeneral &status, Instant time);
    void onEncoder(const StatusEncoder &status, Instant time);
    void onAnalog(const StatusAnalog &status, Instant time);
    void onParameter(const ParamResponse &response);
    void onVendorStatus(const VendorStatus &status);
    void onSession(std::uint16_t session, Instant time);
    void onVersions(const EnumResponse1 &response);
    void askPeriod(const StatusStream &stream, std::uint8_t parameter);
    void askFaults();

    // What follows from it, and from silence: controllerpresence.cpp
    void tick();
    void armTick();
    [[nodiscard]] Duration silenceLimit() const;
    void fallSilent();
    void judgeCandidate();
    void sessionChanged();
    void restarted();
    void enumerate();
    void updateLiveness();
    void setState(DeviceState state, Message detail);

    [[nodiscard]] ParameterExchange::Target target() const { return {identity().address, session()}; }
    [[nodiscard]] std::uint16_t session() const { return static_cast<std::uint16_t>(identity().session.value_or(0)); }
    [[nodiscard]] StatusStream *streamOf(std::uint8_t periodParameter);

    CanLink &m_can;
    ParameterExchange m_exchange;
    FlashProof m_flash;
    bool m_flashLost = false; ///< the device restarted before its flash was proved
    std::optional<int> m_knownSession;

    StatusStream m_general;
    StatusStream m_encoder;
    StatusStream m_analog;
    std::map<std::uint8_t, RateWishes> m_rateWishes;       ///< by status frame
    std::map<std::uint8_t, std::uint32_t> m_usualPeriods;  ///< what setRate() goes back to, ms
    std::map<std::uint8_t, std::uint32_t> m_wantedPeriods; ///< what it asked for; the device forgets it in a restart
    Instant m_periodAskedAt{};
    FaultWatch m_faultWatch;
    LiveStates m_told; ///< by the frames of the device
    Instant m_toldAt{};

    bool m_heard = false;
    bool m_restarted = false;
    StatusGeneral m_lastGeneral;
    std::optional<Instant> m_generalAt;
    int m_idleFrames = 0; ///< general frames in a row with no output, since the last stop()
    bool m_turning = false;
    Instant m_turningAt{};
    std::optional<Instant> m_foreignAt;
    std::uint32_t m_livenessKey = ~0U;
    int m_wakes = 0;         ///< frames that are still to take the device out of its halt
    Instant m_commandedAt{}; ///< the latest set-point

    /// Another session that answers under this number.
    struct Candidate {
        std::uint16_t session = 0;
        int enumerations = 0;
        Instant nextAt{};
    };
    std::optional<Candidate> m_candidate;
    Instant m_ownSeenAt{};
    Instant m_candidateSince{};
    Instant m_enumerateAt{};

    Timer m_timer;
    Instant m_armedFor{};
    Subscription m_received;
    Subscription m_identityChanged;
};

/// Family::open.
[[nodiscard]] std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity);

} // namespace mb::dmc60c
