// SPDX-License-Identifier: GPL-3.0-or-later
#include "tinker/controller.h"

#include "async/sleep.h"
#include "tinker/tables.h"
#include "transport/exchange.h"

#include <cmath>
#include <set>

namespace mb::tinker {
namespace {

constexpr Duration silence = 10 * statusPeriod;

class Controller final : public Device {
public:
    Controller(const Family &family, CanLink &link, Clock &clock, Identity identity)
        : Device(family, link, clock, std::move(identity))
        , m_can(link)
        , m_silence(clock)
        , m_received(link.received().add([this](const CanFrame &frame) { take(frame); }))
    {
    }

private:
    [[nodiscard]] int address() const { return identity().address; }

    void take(const CanFrame &frame)
    {
        const auto status = statusOf(frame, address());
        if (!status)
            return;
        m_status = *status;
        m_statusAt = frame.time;
        telemetry()->append({channel::position, frame.time, static_cast<double>(status->position)});
        telemetry()->append({channel::duty, frame.time, status->duty});
        m_silence.startIn(silence, [this] { fallSilent(); });
        Liveness now;
        now.heard = true;
        now.moving = status->duty != 0.0;
        if (status->stalled)
            now.faults.emplace_back("stalled");
        LiveStates states;
        states.set({0}, status->endSwitch);
        setLiveness(now, states, frame.time);
    }
    void fallSilent()
    {
        for (const ChannelIndex channel : {channel::position, channel::duty})
            telemetry()->breakLine(channel);
        setLiveness({}, {}, clock().now());
    }

    Task<CanFrame> answer(CanFrame request, CanInbox::Match match)
    {
        auto asking = exchange(m_can, clock(), request, std::move(match), {});
        const CanFrame frame = co_await std::move(asking);
        co_return frame;
    }
    Task<std::int64_t> value(CanFrame request, ParameterIndex index)
    {
        const auto number = static_cast<std::uint8_t>(parameters().parameter(index).id);
        CanInbox::Match match = [unit = address(), number](const CanFrame &frame) {
            const auto value = valueOf(frame, unit);
            return value && value->number == number;
        };
        const CanFrame frame = co_await answer(request, std::move(match));
        co_return valueOf(frame, address())->raw;
    }

    Task<void> refresh() override
    {
        CanInbox::Match match = [unit = address()](const CanFrame &frame) { return hereOf(frame, unit).has_value(); };
        const CanFrame frame = co_await answer(ask(Message::Who, 0), std::move(match));
        setIdentity(identityOf(address(), *hereOf(frame, address())));
        co_return {};
    }
    Task<std::int64_t> doRead(ParameterIndex index) override
    {
        return value(readParameter(address(), static_cast<std::uint8_t>(parameters().parameter(index).id)), index);
    }
    Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) override
    {
        const auto number = static_cast<std::uint8_t>(parameters().parameter(index).id);
        return value(writeParameter(address(), {number, static_cast<std::int32_t>(raw)}), index);
    }
    Task<bool> store(Progress &) override
    {
        CanInbox::Match match = [unit = address()](const CanFrame &frame) { return hereOf(frame, unit).has_value(); };
        const CanFrame frame = co_await answer(ask(Message::Store, address()), std::move(match));
        (void)frame;
        co_return true;
    }
    Task<std::vector<FaultRecord>> readFaults() override
    {
        co_return std::vector{FaultRecord{"stalled", m_status.stalled, false, std::nullopt}};
    }
    Task<std::vector<FaultRecord>> clearFaults() override { return readFaults(); }
    Task<void> renumber(int) override { co_return fail(Fault::Unsupported, say("its number is soldered")); }
    Task<void> setRate(ChannelIndex, double) override { co_return {}; } // it has one

    Result<void> doCheck(const SetPoint &setPoint) const override
    {
        if (setPoint.mode != Mode::Duty && setPoint.mode != Mode::Position && setPoint.mode != Mode::Off)
            return fail(Fault::Unsupported, say("it has duty and position only"));
        if (setPoint.mode == Mode::Duty && std::abs(setPoint.target) > 1.0)
            return fail(Fault::OutOfRange, say("duty is -1 to 1"));
        return {};
    }
    Result<void> doCommand(const SetPoint &setPoint) override
    {
        if (auto legal = doCheck(setPoint); !legal)
            return legal;
        const bool duty = setPoint.mode == Mode::Duty;
        const auto raw = static_cast<std::int32_t>(std::lround(setPoint.target * (duty ? fullDuty : 1.0)));
        const Drive mode = setPoint.mode == Mode::Off ? Drive::Off : duty ? Drive::Duty : Drive::Position;
        telemetry()->append({channel::setPoint, clock().now(), setPoint.target});
        return m_can.send(drive(address(), mode, raw));
    }
    void doStop() override
    {
        (void)m_can.send(drive(address(), Drive::Off, 0), Priority::Urgent);
        telemetry()->breakLine(channel::setPoint);
    }
    StopScript stopScript() const override
    {
        StopStep step;
        step.frame = drive(address(), Drive::Off, 0);
        step.wait = std::chrono::milliseconds(10);
        step.attempts = 3;
        return {{std::move(step)}};
    }
    bool isSeenStopped() const override { return m_statusAt > gate().stoppedAt() && m_status.duty == 0.0; }

    CanLink &m_can;
    Status m_status;
    Instant m_statusAt{};
    Timer m_silence;
    Subscription m_received;
};

} // namespace

Identity identityOf(int address, const Here &here)
{
    Identity identity;
    identity.family = "tinker";
    identity.address = address;
    identity.state = here.loader ? DeviceState::Bootloader : DeviceState::Online;
    if (!here.loader)
        identity.firmware = std::to_string(here.major) + '.' + std::to_string(here.minor);
    return identity;
}

Task<void> scan(Link &link, Clock &clock, ScanSink &sink)
{
    auto *const can = dynamic_cast<CanLink *>(&link);
    if (!can)
        co_return fail(Fault::Unsupported, say("it lives on CAN links only"));
    std::set<int> known;
    const Subscription heard = can->received().add([&known, &sink](const CanFrame &frame) {
        const auto address = static_cast<int>(frame.id & 0xFFU);
        const auto here = hereOf(frame, address);
        if (here && known.insert(address).second)
            sink.found(identityOf(address, *here));
    });
    for (int round = 0; round < 2; ++round) { // a frame may be lost
        if (auto sent = can->send(ask(Message::Who, 0)); !sent)
            co_return fail(sent.error());
        co_await Sleep(clock, std::chrono::milliseconds(50));
    }
    co_return {};
}

std::unique_ptr<Device> open(Link &link, Clock &clock, const Identity &identity)
{
    extern const Family family;
    auto *const can = dynamic_cast<CanLink *>(&link);
    return can ? std::make_unique<Controller>(family, *can, clock, identity) : nullptr;
}

} // namespace mb::tinker
