// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/progress.h"
#include "async/task.h"
#include "firmware/firmwareimage.h"
#include "firmware/updateroute.h"
#include "model/decoded.h"
#include "model/identity.h"
#include "model/livestate.h"
#include "model/operation.h"
#include "model/parameterstore.h"
#include "model/setpoint.h"
#include "model/trialtraits.h"
#include "simulation/simulator.h"
#include "telemetry/channel.h"

#include <functional>
#include <utility>

namespace mb {

class Device;
class SetPointStream;

/// What a device of this family can do; each has its clause in the contract test.
struct Capabilities {
    bool readback = true;      ///< parameters can be read
    bool watchdog = false;     ///< the device stops by itself when nobody commands it
    bool versionOnWire = true; ///< the device tells its firmware version
    bool identify = false;     ///< it can blink
    bool rename = false;
    bool renumber = false;
    bool restart = false;       ///< Device::restart()
    bool relativeMoves = false; ///< SetPoint::relative
    bool bufferedMoves = false; ///< SetPoint::buffered, and one command that starts them on all devices of a link
    bool storesAtOnce = false;  ///< an acknowledged write survives a power cycle
    /// False: a reset takes every setting, so this program keeps what was written and offers to write it again.
    bool keepsSettings = true;
    bool zeroPosition = false; ///< Device::zeroPosition()
    OutputOptions output{};
    /// Device::setRate() changes nothing that anybody else relies on: the device is asked more often, or sends to us alone.
    bool freeRates = true;
    int firstAddress = 0;   ///< nobody has a lower one
    int lastAddress = 63;   ///< nor a higher one; renumber: 1 … this
    int lastFollowed = 255; ///< Mode::Follow: the number of the device to follow is 1 … this
    bool commandsProfile
        = false; ///< SetPoint::velocity and acceleration are the profile of RampPosition and RampVelocity
    /// Greatest duty of a motor's first motion while nobody has set its power limit; 0: no such care is needed.
    double firstPower = 0.0;
    double lowestSupply = 0.0;    ///< V; an update with less on the channel bus_voltage is warned of
    double fastestProfile = 0.0;  ///< counts/s, SetPoint::velocity is at most this; 0: no profile is commanded
    double steepestProfile = 0.0; ///< counts/s², the same of SetPoint::acceleration
    int axes = 1; ///< more than one: keys of channels and parameters of an axis begin as in model/axis.h
    int gainSlots = 1;
    /// A scan of a bus of up to eight units is complete by then.
    std::chrono::milliseconds scanLimit{500};
    std::chrono::milliseconds commandPeriod{20}; ///< between control frames of a running motor
    /// A control frame that comes later than this after the one before finds a device that has stopped by itself, or one that
    /// nobody has watched for too long: motion ends then (SetPointStream::End::Late).
    std::chrono::milliseconds commandLimit{250};
    /// With a watchdog: this long after the last frame that reached it a device has stopped by itself for certain.
    std::chrono::milliseconds watchdogLimit{250};
    std::chrono::seconds storesAfter{
        0};                             ///< flash has what RAM has this long after the last write; 0: only when told to
    std::chrono::seconds storeLimit{0}; ///< … and its store() has proved or given up this long after it
    /// Its bootloader is heard on another line than its application: a unit in it answers nothing on its own.
    bool bootloaderElsewhere = false;
};

/// A variant of the family's protocol that a user may choose against what the scan found.
struct DialectChoice {
    std::string_view key;
    std::string_view title;   ///< English; widgets translate it
    std::string_view warning; ///< what goes wrong when the unit speaks another one; a whole sentence
};

/// A number that only the user of a device knows, such as what its sensor gives for an ampere. Kept in the device's profile.
struct Calibration {
    std::string_view key;
    std::string_view unit;
    std::string_view label; ///< English; widgets translate it
    std::string_view help;
    double minimum = 0.0;
    double maximum = 0.0;
    std::span<const Choice> choices{}; ///< not empty: one of these, the first while nobody chose
    Mode loop = Mode::Off;             ///< it is what a raw gain of 1 of this loop puts out (LoopScale::calibrated) …
    Role gain = Role::None;            ///< … for this gain; None: it is something else
};
/// The one calibration that widgets know by name: encoder counts of one turn, four edges a line.
constexpr std::string_view countsPerRevolutionKey = "counts_per_revolution";

/// What the gains of a loop that computes in integers mean (docs/names.md#integer-gains): output = (P·e + I·Σe + D·Δe)/divisor.
struct LoopScale {
    double fullDuty = 0.0;            ///< output at 100 %
    double period = 0.0;              ///< seconds that I and D count in: the period of the loop, or a unit of time
    double cycle = 0.0;               ///< seconds between two passes of the loop
    double integralStep = 0.0;        ///< output that one pass must add to the integral, or it adds nothing; 0: exact
    double clock = 0.0;               ///< seconds that its loop counts in, whole ones, from pass to pass; 0: exactly
    double velocityTime = 1.0;        ///< velocities are counts per so many seconds
    double velocityWindow = 0.0;      ///< seconds over which its loop takes a velocity; 0: found out, or by the next
    std::string_view velocityEdges{}; ///< parameter: it takes it over 4 × so many counts
    std::string_view velocityError;   ///< English unit of a velocity error; widgets translate it
    std::string_view currentError;
    std::string_view time;           ///< English name of `period`: "loop", "ms"
    bool divided = false;            ///< each loop has a Role::Divisor
    bool derivativeInverted = false; ///< a positive raw D pushes the same way as the change
    bool dutyAtOnce = false;         ///< a duty is put out as soon as it is ordered, not in the next pass
    bool calibrated = false;         ///< what a raw gain of 1 puts out is not known but by Calibration::gain
};

/// A fault that devices of the family report in their telemetry.
struct FaultRow {
    std::string_view key;   ///< Liveness::faults, FaultRecord; without the axis
    std::string_view label; ///< English, marked for translation ("table"): "over-current"
};

/// What a set-point of a mode may be at first in a window: a hand cannot do much harm within it, and it can be raised.
struct ModeRange {
    Mode mode = Mode::Duty;
    double usual = 0.0; ///< ±, in the mode's unit
};
/// Of the mode in `ranges`, or what is usual for it with motors of a few ampere.
[[nodiscard]] double usualRange(std::span<const ModeRange> ranges, Mode mode);

/// How often a channel must come while somebody watches a step of it.
struct ChannelRate {
    std::string_view channel;
    double hertz = 0.0;
};

/// What such a unit drives: English, marked for translation ("table").
struct DemoMotor {
    int address = 0;
    std::string_view title; ///< "775pro"
    std::string_view parts; ///< its load, gear and encoder: "4096 counts a turn"
};

/// Units of `Family::bench` that show off the program (`--tour`, the stories of the first page): addresses.
struct DemoUnits {
    int tuned = 0;
    std::string_view livelierLimit{};                ///< its parameter: more of it makes its motor livelier
    int overshooting = 0;                            ///< with gains that are too lively …
    std::span<const std::string_view> livelyGains{}; ///< … of its velocity loop: P and I
    int inBootloader = 0;
    std::string_view image{}; ///< of its firmware: the resource of that name
    int stoppingShort = 0;    ///< friction holds it before its target …
    double shortStep = 0.0;   ///< … of a step of so many counts …
    double shortBy = 0.0;     ///< … by about so many; …
    std::span<const std::pair<std::string_view, double>> arrivingGains{}; ///< … with these gains it arrives
    std::span<const DemoMotor> motors{};                                  ///< of each of them
};

struct ExperimentOptions {
    int axis = 1;
    double power = 0.0; ///< most that the motor gets, fraction of full power
    int answer = 0;     ///< to Experiment::question, its place in the list
};

struct ExperimentReport {
    std::vector<std::pair<std::string, double>> found; ///< calibrations that it has set, by key
    Message sentence;                                  ///< the result for people
};

/// What a device does not tell, found out by trying: guided by the window, run as a job that can be cancelled.
struct Experiment {
    std::string_view key;
    std::string_view title;       ///< English, of a button: a verb and its object
    std::string_view explanation; ///< what happens, and what must be so before it begins
    double power = 0.0;           ///< greatest power that is offered first; 0: nothing moves
    double mostPower = 0.0;
    std::string_view question; ///< what only its user sees; empty: nothing
    std::span<const std::string_view> answers{};
    /// Sets the calibrations only when everything fitted. Ends with the motor stopped and the gains as they were, whatever
    /// happens. The stream's lease is the caller's to renew. Unsafe, Refused with the cause; LinkLost, Timeout.
    Task<ExperimentReport> (*run)(Device &, SetPointStream &, ExperimentOptions, Progress &) = nullptr;
};

/// How far a scan goes where looking everywhere takes long.
enum class ScanExtent {
    Quick,     ///< once all that were remembered have answered, only usual places are looked at besides
    Usual,     ///< everywhere where newcomers may be expected
    Everything ///< every rate and every address, however long it takes
};

/// Gets what a scan finds, each as soon as it answers. A device may be reported again with more detail: same address and
/// session. A row that must go (it was half an answer) is simply not in the final list.
class ScanSink {
public:
    virtual ~ScanSink() = default;
    virtual void found(const Identity &identity) = 0;
    virtual void progress(const Message &what, int done, int total) = 0;
    /// What of this family such a scan does not find, and what helps.
    virtual void leftOut(const Message &) { }
    /// Who answered on this link in an earlier scan, perhaps of an earlier run, and whom somebody has named now (his address,
    /// no more): asked first, where a scan takes long.
    [[nodiscard]] virtual std::vector<Identity> remembered() const { return {}; }
    /// Devices of this family that are in the list of this link already.
    [[nodiscard]] virtual std::vector<Identity> known() const { return {}; }
    [[nodiscard]] virtual ScanExtent extent() const { return ScanExtent::Quick; }
};

struct UpdateOptions {
    bool dryRun = false; ///< preflight only
    bool force = false;  ///< write even if the version is the same
    std::string via;
    std::string target;
    bool eraseSettings = false; ///< what the unit has stored goes too; families without such a thing refuse it
};

enum class UpdateOutcome { Done, UpToDate, Refused, Failed, Cancelled };
[[nodiscard]] std::string_view toString(UpdateOutcome outcome);

struct UpdateReport {
    UpdateOutcome outcome = UpdateOutcome::Failed;
    std::string from; ///< version before, empty when there was none
    std::string to;   ///< version that the device reports now
    int pages = 0;    ///< written and accepted
    int retries = 0;
    bool verified = false;      ///< the device answered with the version of the image
    Message evidence;           ///< what proves it, or what went wrong
    Message remedy;             ///< what to do where it went wrong; empty where nothing is known
    std::optional<Fault> fault; ///< of Failed

    /// Evidence and remedy in one.
    [[nodiscard]] Message summary() const { return joined(evidence, remedy); }
};

/// Of an update that was cancelled, or that an error ended before it could make its own report.
[[nodiscard]] UpdateReport unfinished(const UpdateStanding &standing, const Error &error);

/// Gets the frames of a recording in their order, those that the recorder had sent included, and tells who sent the one that
/// came last: its address at least; session, state, versions and dialect where they are known by then. Nothing for frames of
/// other families, and for those that a host sends. `CanFrame::time` is the time of the recording.
using Recogniser = std::function<std::optional<Identity>(const CanFrame &)>;

/// Family::followCan.
using CanDecoder = std::function<std::optional<DecodedFrame>(const CanFrame &)>;

/// What an image would do, without a device.
struct ImageSummary {
    std::string version;
    std::vector<int> parts;          ///< pages in the order they are written
    std::optional<int> criticalPart; ///< power must not fail while this one is written
    std::vector<Message> notes;
};

/// A controller family: data and functions, nothing else. `const`, one per folder, listed in FAMILIES.
struct Family {
    std::string_view key;
    std::string_view title; ///< "DMC60C"
    std::span<const LinkKind> links;
    std::span<const Parameter> parameters;
    std::span<const Channel> channels;
    std::span<const Mode> modes; ///< without Off, which all have
    Capabilities capabilities;
    /// Units of the bench behind `sim:`, in the notation of `simulate`.
    std::span<const std::string_view> bench;

    std::span<const DialectChoice> dialects{};   ///< empty: there is one
    std::span<const Calibration> calibrations{}; ///< empty: everything is known
    std::span<const Experiment> experiments{};   ///< empty: nothing can be found out
    std::span<const UpdateRoute> routes{};       ///< of update(); empty: the device's own link
    UpdateWords updateWords{};                   ///< of an update over the device's own link
    std::span<const StateRow> states{};          ///< empty: its devices tell no limits and no pins
    std::span<const FaultRow> faults{};          ///< empty: its devices tell no faults
    std::span<const ModeRange> ranges{};         ///< of modes where usualRange() is not what it seems
    std::span<const ChannelRate> watched{};      ///< while a motion is tuned
    std::span<const std::string_view>
        versionEntries{};                ///< keys of Identity::descriptors that tell its versions once more
    const DemoUnits *demo = nullptr;     ///< nullptr: the tour shows another family
    const LoopScale *loop = nullptr;     ///< nullptr: what the gains mean is not known
    const TrialTraits *trials = nullptr; ///< nullptr: no loop of it can be tried
    /// Puts changes of write-only or interlocked parameters into the order that passes through safe states only.
    void (*arrange)(const ParameterStore &known, std::vector<ParameterChange> &changes) = nullptr;

    /// Finds devices. Sends nothing that changes or moves one. Ends when the list is complete.
    Task<void> (*scan)(Link &, Clock &, ScanSink &) = nullptr;
    /// Asks whether one address answers, where a scan takes long. nullptr: a scan tells.
    Task<void> (*probe)(Link &, Clock &, int address, ScanSink &) = nullptr;
    std::unique_ptr<Device> (*open)(Link &, Clock &, const Identity &) = nullptr;
    /// How devices are found in a recording, where nobody can be asked: makes what listens to one. nullptr: there they are not
    /// found.
    Recogniser (*recogniser)() = nullptr;
    /// Nothing when the frame is not of this family.
    std::optional<DecodedFrame> (*decodeCan)(const CanFrame &, std::string_view dialect) = nullptr;
    /// Made for one bus, and shown all its frames in their order: reads an answer by the question before it, where decodeCan() alone
    /// cannot know whose it is. nullptr: no answer of this family needs that.
    CanDecoder (*followCan)(std::string_view dialect) = nullptr;
    /// Of a family on serial and SPI links.
    std::unique_ptr<ByteDecoder> (*decodeBytes)(std::string_view dialect) = nullptr;
    /// nullptr: no firmware update. The image outlives the task. Whoever calls it has asked standsStill() first.
    Task<UpdateReport> (*update)(Device &, const FirmwareImage &, UpdateOptions, Progress &) = nullptr;
    Result<ImageSummary> (*inspect)(const FirmwareImage &) = nullptr;
    Result<std::unique_ptr<Simulator>> (*simulate)(Link &, Clock &, const SimulatedUnit &) = nullptr;
};

/// Whether this address is the unit of `Family::demo` that is meant; never where the family has none such.
[[nodiscard]] bool isDemoUnit(const Family &family, int address, int DemoUnits::*which);
/// What is said around an update: of the first route, which is the one that a window offers, or of the device's own link.
[[nodiscard]] const UpdateWords &updateWords(const Family &family);
/// nullptr where the family reports no such fault. `key` may begin with an axis: "ch1.glitch".
[[nodiscard]] const FaultRow *findFault(const Family &family, std::string_view key);

} // namespace mb
