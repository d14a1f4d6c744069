// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/operation.h"
#include "model/session.h"
#include "traffic/trafficlog.h"
#include "traffic/trafficrecorder.h"
#include "transport/linkdoctor.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace mb {

/// What the window shows, by value: taken in the engine thread, read in the other. `Family`, `Telemetry` and `TrafficLog` are
/// safe to share: the first is const data, the others lock.
struct LinkView {
    std::string address;
    std::string name; ///< short: can0, sim:can
    LinkKind kind = LinkKind::Can;
    LinkState state = LinkState::Closed;
    Message reason; ///< why it is lost
    bool simulated = false;
    bool scanning = false;
    Message scanStep; ///< what the scan looks for now, where it takes long
    int scanDone = 0;
    int scanTotal = 0;
    int bitrate = 0;
    std::optional<double> load; ///< 0…1; nothing before it was measured for a second, or where the rate is not known
    std::optional<Duration> roundTrip; ///< of serial links, smoothed; nothing before the first answer
    LinkCounters counters;
    BusHealth health;          ///< of a CAN link
    std::uint64_t unknown = 0; ///< frames received that no family knows
    Diagnosis diagnosis;       ///< one cause and one remedy; healthy when nothing is wrong
    std::shared_ptr<const TrafficLog> traffic;
    std::optional<RecordingState> recording; ///< since the window records it, and after
    std::optional<ReplayState> replay;       ///< of a recording
    Instant time{};                          ///< the present on its own time line: of a recording, where it stands
};

struct MotionView {
    bool running = false;
    SetPoint setPoint;               ///< the latest
    std::vector<SetPoint> setPoints; ///< of every axis that is kept alive
    SetPointStream::End end = SetPointStream::End::None;
    Message reason;

    /// What an axis is told now; nullptr while nothing runs on it.
    [[nodiscard]] const SetPoint *on(int axis) const;
};

/// What seldom changes is one object for all pictures until it does (Shared).
struct DeviceView {
    DeviceId id;
    const Family *family = nullptr;
    Shared<Identity> identity;
    std::string selector;
    std::string link; ///< address of its link
    std::string unit; ///< unitKeyOf()
    Liveness liveness;
    std::uint32_t origin = 0; ///< MotionGate::origin()
    LiveStates states;        ///< by the rows of family->states
    Message busy;             ///< what it does now
    MotionView motion;
    std::shared_ptr<const Telemetry> telemetry;
    std::vector<double> rates;                             ///< samples per second, in table order of the channels
    Shared<std::vector<ParameterStore::Entry>> parameters; ///< in table order
    std::uint64_t parameterRevision = 0;
    std::optional<Instant> lastWrite; ///< ParameterStore::lastWrite()
    Shared<DeviceProfile> profile;
    Message mayNotMove; ///< empty when it may be driven
    StopState stop = StopState::None;
    bool stopsMotion = false; ///< somebody knew of a motion when it was told to stop (DeviceStop::isForMotion)
    bool mayTurn = false;     ///< nobody has seen it stand, and nothing of its own stops it
    Message mayNotBeStopped;  ///< why STOP leaves it out; empty: it does not
    KeptMove kept;            ///< a buffered move that has not begun

    /// In the units that the device sends in; those of its family where nothing is recorded.
    [[nodiscard]] std::span<const Channel> channels() const;
};

struct OperationId {
    std::uint32_t value = 0;
    friend auto operator<=>(const OperationId &, const OperationId &) = default;
};

struct OperationView {
    OperationId id;
    DeviceId device;
    OperationStatus status;
    std::optional<UpdateReport> update; ///< of a finished firmware update
};

/// A change of a device's settings that goes back unless somebody keeps it.
struct UnconfirmedView {
    enum class State {
        Offered,          ///< left by a program that is gone, or from before the link was lost: nothing goes by itself
        AwaitsRestart,    ///< the device does not have it yet
        Counting,         ///< `left` seconds from now it goes back
        AwaitsStandstill, ///< it goes back as soon as the motor is seen to stand
    };
    DeviceId device;
    std::int64_t change = 0; ///< its number in the history
    Message text;            ///< "current_limit.peak: 60 -> 80"
    State state = State::Offered;
    double left = 0.0;  ///< s
    std::string unit{}; ///< whose, as the history calls it (model/unit.h)
};

/// A link that was asked for and could not be opened.
struct FailedLink {
    std::string address;
    Diagnosis diagnosis;
};

/// A stop that is owed to a device which nobody sees now.
struct OwedStopView {
    std::string device;     ///< selector, as of when it was driven
    bool elsewhere = false; ///< another adapter has the name of its link by now
};

struct Snapshot {
    Instant time{};
    std::vector<LinkView> links;
    std::vector<FailedLink> failed;
    std::vector<DeviceView> devices;          ///< grouped by link, in order of address
    std::vector<OperationView> operations;    ///< oldest first
    std::vector<UnconfirmedView> unconfirmed; ///< oldest first of each device
    /// Of devices that are in no list, because their link is closed or they were not found again.
    std::vector<OwedStopView> owedStops;

    [[nodiscard]] const DeviceView *device(DeviceId id) const;
    [[nodiscard]] const LinkView *link(std::string_view address) const;
    /// The newest operation of a device, running or ended.
    [[nodiscard]] const OperationView *operation(DeviceId device) const;
};

[[nodiscard]] DeviceView viewOf(Session &session, Device &device);
/// `clock`: its own (Session::clockOf).
[[nodiscard]] LinkView viewOf(const Link &link, const Clock &clock);

} // namespace mb
