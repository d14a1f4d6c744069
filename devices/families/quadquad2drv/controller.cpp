// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: telemetry, silence and resets.
#include "families/quadquad2drv/controller.h"

#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/states.h"
#include "model/family.h"

#include <algorithm>
#include <string>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

constexpr Duration pollPeriod = 10ms;
constexpr Duration silence = 300ms;
constexpr Duration lookPeriod = 100ms;
constexpr int lookForReset = 10; ///< every so many looks
constexpr double standing = 8.0; ///< counts/s, twice the resolution (README.md#times-4096)
constexpr std::array<int, 4> positionBits{0, 8, 16, 32};

constexpr std::uint8_t faultBits = status::glitch | status::overspeed;

} // namespace

extern const Family family;

Controller::Controller(const Family &known, SpiLink &link, Clock &clock, Identity identity)
    : Device(known, link, clock, std::move(identity))
    , m_spi(link)
    , m_port(link, clock)
    , m_received(m_port.received().add([this](const Packet &packet, Instant time) { onPacket(packet, time); }))
    , m_state(link.stateChanged().add([this](LinkState) { look(); }))
    , m_poll(clock)
    , m_look(clock)
    , m_scope(clock)
{
    m_readyRaised = link.readyRaised().add([this] {
        if (m_streamPeriod > 0 && m_spi.turns().isFree())
            m_scope.spawn(m_port.fetch());
    });
    schedulePoll();
    look();
}

void Controller::onPacket(const Packet &packet, Instant time)
{
    const bool stream = packet.id == static_cast<std::uint8_t>(PacketId::Stream);
    if (stream || packet.id == static_cast<std::uint8_t>(PacketId::GetMotion)) {
        if (const auto motion = parseMotion(packet, m_port.masks(), m_port.streamConfig())) {
            if (stream)
                m_streamAt = time;
            onMotion(*motion, time);
        } else if (!m_learning && busy().empty()) { // another program has changed what the board sends
            m_learning = true;
            m_scope.spawn<void>(takeLayout(), [this](const Result<void> &) { m_learning = false; });
        }
    }
}

void Controller::onMotion(const Motion &motion, Instant time)
{
    m_motionAt = time;
    m_heard = true;
    LiveStates told = states();
    for (int axis = 0; axis < axes; ++axis) {
        const auto lost = motion.elapsed.value_or(0);
        for (std::uint16_t i = 0; lost > 0 && i < measuredPerAxis; ++i)
            telemetry()->lost(channelOf(axis, static_cast<AxisChannel>(i)), lost);
        onAxis(axis, motion.channels[static_cast<std::size_t>(axis)], time);
        if (const auto &status = motion.channels[static_cast<std::size_t>(axis)].status)
            takeStates(told, axis, *status);
    }
    setStates(told, time);
    telemetry()->commit();
    updateLiveness();
}

std::int64_t Controller::unwrapped(int axis, std::int32_t position) const
{
    const std::uint8_t mask = m_port.masks()[static_cast<std::size_t>(axis)];
    const auto &before = m_tracked[static_cast<std::size_t>(axis)].position;
    if ((mask & datamask::relative) != 0)
        return before.value_or(0) + position;
    const int bits = positionBits[mask & datamask::positionSize];
    if (!before || bits == 32)
        return position;
    const std::int64_t span = std::int64_t{1} << bits;
    std::int64_t moved = (position - *before) % span;
    if (moved >= span / 2)
        moved -= span;
    if (moved < -span / 2)
        moved += span;
    return *before + moved;
}

void Controller::onAxis(int axis, const AxisMotion &motion, Instant time)
{
    Tracked &tracked = m_tracked[static_cast<std::size_t>(axis)];
    if (motion.position) {
        tracked.position = unwrapped(axis, *motion.position);
        telemetry()->append({channelOf(axis, AxisChannel::Position), time, static_cast<double>(*tracked.position)});
    }
    if (motion.velocity)
        telemetry()->append({channelOf(axis, AxisChannel::Velocity), time, static_cast<double>(*motion.velocity)});
    if (motion.status) {
        tracked.status = *motion.status;
        telemetry()->append({channelOf(axis, AxisChannel::Status), time, static_cast<double>(*motion.status)});
    }
}

void Controller::schedulePoll()
{
    if (m_streamPeriod > 0 || m_spi.state() != LinkState::Open) {
        m_poll.stop();
        return;
    }
    m_poll.startIn(pollPeriod, [this] {
        if (!m_polling && busy().empty()) {
            m_polling = true;
            m_scope.spawn<void>(poll(), [this](const Result<void> &) { m_polling = false; });
        }
        schedulePoll();
    });
}

Task<void> Controller::poll()
{
    auto asking = m_port.request(getRequest(PacketId::GetMotion), 1);
    co_await std::move(asking);
    co_return {};
}

void Controller::look()
{
    if (m_spi.state() != LinkState::Open)
        m_heard = false;
    const Instant now = clock().now();
    if (m_motionAt && now - *m_motionAt > silence)
        m_heard = false;
    if (!m_heard)
        setStates({}, now);
    const bool streamGone = m_streamPeriod > 0 && (!m_streamAt || now - *m_streamAt > silence);
    if ((streamGone || m_changed || (m_heard && !m_judged)) && !m_checking && busy().empty()
        && m_spi.state() == LinkState::Open) {
        m_checking = true;
        m_scope.spawn<void>(checkReset(), [this](const Result<void> &) { m_checking = false; });
    }
    if (!m_poll.isActive())
        schedulePoll();
    updateLiveness();
    m_look.startIn(lookPeriod, [this] { look(); });
}

/// Section 4: a board that was reset has its start-up data masks again. At the first look that tells of a reset since the
/// settings in its profile were written, by this run of the program or another one: all that write set other masks first.
Task<void> Controller::checkReset()
{
    auto asking = m_port.request(getRequest(PacketId::GetDataMask), 1);
    const Packet reply = co_await std::move(asking);
    const auto masks = parseDataMasks(reply);
    if (!masks)
        co_return fail(Fault::BadReply, "the data masks have an unexpected length");
    judge(*masks);
    if (*masks != m_port.masks()) // another program has changed what the board sends
        m_port.setLayout(*masks, m_port.streamConfig());
    co_return {};
}

/// Wherever the masks are seen: what is understood with the new ones must not hide what they mean.
void Controller::judge(const DataMasks &masks)
{
    const bool startUp
        = std::all_of(masks.begin(), masks.end(), [](std::uint8_t mask) { return mask == datamask::startUp; });
    const bool told = m_changed && masks != m_port.masks();
    const bool before = !m_judged && holdsSettings();
    m_judged = true;
    if (startUp && (told || before))
        forgetBoard();
}

void Controller::forgetBoard()
{
    m_changed = false;
    m_restarted = true;
    m_streamPeriod = 0;
    m_drives = {};
    m_orders.clear();
    m_port.setLayout({datamask::startUp, datamask::startUp, datamask::startUp, datamask::startUp}, 0);
    for (Tracked &tracked : m_tracked)
        tracked.position.reset();
    settingsLost();
    schedulePoll();
    updateLiveness();
}

/// What it was told: the board does not say.
std::optional<Mode> Controller::modeOf(int axis) const
{
    const Drive &drive = m_drives[static_cast<std::size_t>(axis)];
    if (!m_heard)
        return std::nullopt;
    switch (drive.mode) {
    case ControlMode::Off: return Mode::Off;
    case ControlMode::Power: return Mode::Duty;
    case ControlMode::Position: return drive.profile ? Mode::RampPosition : Mode::Position;
    case ControlMode::Velocity: return drive.profile ? Mode::RampVelocity : Mode::Velocity;
    }
    return std::nullopt;
}

void Controller::updateLiveness()
{
    Liveness now;
    now.heard = m_heard;
    now.restarted = m_restarted;
    for (int axis = 0; axis < axes; ++axis) {
        const auto velocity = telemetry()->latest(channelOf(axis, AxisChannel::Velocity));
        const bool driven = m_drives[static_cast<std::size_t>(axis)].mode != ControlMode::Off;
        const bool moving = driven || (m_heard && velocity && std::abs(velocity->value) > standing);
        now.moving = now.moving || moving;
        now.axes.push_back({modeOf(axis), moving});
        const std::uint8_t status = m_tracked[static_cast<std::size_t>(axis)].status & faultBits;
        const std::string prefix = "ch" + std::to_string(axis + 1) + '.';
        if ((status & status::glitch) != 0)
            now.faults.push_back(prefix + "glitch");
        if ((status & status::overspeed) != 0)
            now.faults.push_back(prefix + "overspeed");
    }
    setLiveness(now);
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    if (link.kind() != LinkKind::Spi)
        return nullptr;
    return std::make_unique<Controller>(family, static_cast<SpiLink &>(link), clock, identity);
}

} // namespace mb::quadquad2drv
