// SPDX-License-Identifier: GPL-3.0-or-later
#include "tinker/simulator.h"

#include "simulation/motormodel.h"
#include "tinker/protocol.h"
#include "transport/canlink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <list>

namespace mb::tinker {
namespace {

constexpr Duration loopPeriod = std::chrono::milliseconds(1);
constexpr Duration stallTime = std::chrono::milliseconds(200);
constexpr double leastSpeed = 1.0; ///< rad/s

class Unit final : public Simulator {
public:
    Unit(CanLink &link, Clock &clock, int address, const MotorParameters &motor)
        : m_link(link)
        , m_clock(clock)
        , m_address(address)
        , m_motor(motor)
        , m_loop(clock)
        , m_report(clock)
        , m_received(link.received().add([this](const CanFrame &frame) { take(frame); }))
    {
        m_flash[0] = 1; // version 1.0
        setPowered(true);
    }
    std::string name() const override { return "tinker:" + std::to_string(m_address); }
    bool isOutputOn() const override { return m_duty != 0.0; }
    double speed() const override { return m_motor.countSpeed(); }
    double position() const override { return m_motor.countPosition(); }
    std::vector<std::uint8_t> flash() const override { return {m_flash.begin(), m_flash.end()}; }
    bool disturb(std::string_view what, double value) override
    {
        if (what != "end-switch")
            return m_motor.disturb(what, value);
        m_endSwitch = value != 0.0;
        return true;
    }
    void setPowered(bool powered) override
    {
        if (powered == m_powered)
            return;
        m_powered = powered;
        m_mode = Drive::Off;
        m_duty = 0.0;
        m_values = m_stored;
        m_answers.clear();
        if (!powered) {
            m_loop.stop();
            m_report.stop();
            return;
        }
        work();
        report();
    }

private:
    [[nodiscard]] double setting(std::size_t number) const { return m_values.at(number - 1); }

    /// One pass of the loop of 1 ms.
    void work()
    {
        if (m_clock.now() - m_driven > driveLimit)
            m_mode = Drive::Off;
        const double turn = m_motor.parameters().countsPerTurn;
        const double wished = m_mode == Drive::Duty ? m_target / fullDuty
            : m_mode == Drive::Position             ? setting(1) / 1000.0 * (m_target - m_motor.countPosition()) / turn
                - setting(2) / 1000.0 * m_motor.countSpeed() / turn
                                        : 0.0;
        const double most = setting(3) / 10000.0;
        m_duty = m_mode == Drive::Off ? 0.0 : std::clamp(wished, -most, most);
        m_motor.step(m_duty, Bridge::Drive, 1e-3);
        if (m_duty == 0.0 || std::abs(m_motor.speed()) > leastSpeed)
            m_turned = m_clock.now();
        m_loop.startIn(loopPeriod, [this] { work(); });
    }
    void report()
    {
        const auto position = static_cast<std::uint32_t>(m_motor.counts());
        const auto duty = static_cast<std::uint16_t>(std::lround(m_duty * fullDuty));
        const bool stalled = m_clock.now() - m_turned > stallTime;
        const auto flags = (stalled ? stalledFlag : 0) | (m_endSwitch ? endSwitchFlag : 0);
        if (!m_loader)
            say(Message::Status,
                {byte(position, 0), byte(position, 1), byte(position, 2), byte(position, 3), byte(duty, 0),
                    byte(duty, 1), static_cast<std::uint8_t>(flags)});
        m_report.startIn(statusPeriod, [this] { report(); });
    }
    static std::uint8_t byte(std::uint32_t number, int which)
    {
        return static_cast<std::uint8_t>(number >> (8 * which) & 0xFFU);
    }
    void say(Message message, std::initializer_list<std::uint8_t> data)
    {
        (void)m_link.send(extendedFrame(
            baseId | static_cast<std::uint32_t>(message) << 8U | static_cast<std::uint32_t>(m_address), data));
    }
    void sayHere() { say(Message::Here, {static_cast<std::uint8_t>(m_loader ? 1 : 0), m_flash[0], m_flash[1]}); }
    void sayLoaded(std::uint32_t at) { say(Message::Loaded, {byte(at, 0), byte(at, 1)}); }
    void sayValue(std::uint8_t number)
    {
        const auto raw = static_cast<std::uint32_t>(m_values.at(number - 1U));
        say(Message::Value, {number, byte(raw, 0), byte(raw, 1), byte(raw, 2), byte(raw, 3)});
    }

    void take(const CanFrame &frame)
    {
        const auto to = static_cast<int>(frame.id & 0xFFU);
        if (!m_powered || !frame.extended || (frame.id & 0xFFFF0000U) != baseId || (to != m_address && to != 0))
            return;
        const auto &data = frame.data;
        const auto four = static_cast<std::int32_t>(data[1] | data[2] << 8 | data[3] << 16
            | static_cast<std::int32_t>(static_cast<std::uint32_t>(data[4]) << 24U));
        switch (static_cast<Message>(frame.id >> 8U & 0xFFU)) {
        case Message::Who:
            m_answers.emplace_back(m_clock).startIn(m_address * std::chrono::milliseconds(1), [this] { sayHere(); });
            break;
        case Message::Drive:
            m_mode = m_loader ? Drive::Off : static_cast<Drive>(data[0]);
            m_target = four;
            m_driven = m_clock.now();
            if (m_mode == Drive::Off)
                m_duty = 0.0;
            break;
        case Message::Write:
            if (data[0] >= 1 && data[0] <= m_values.size())
                m_values.at(data[0] - 1U) = four;
            [[fallthrough]];
        case Message::Read:
            if (data[0] >= 1 && data[0] <= m_values.size())
                sayValue(data[0]);
            break;
        case Message::Store:
            m_stored = m_values;
            sayHere();
            break;
        default: load(static_cast<Message>(frame.id >> 8U & 0xFFU), data); break;
        }
    }
    void load(Message message, const std::array<std::uint8_t, 8> &data)
    {
        const std::uint32_t at = data[0] | static_cast<std::uint32_t>(data[1]) << 8U;
        if (message == Message::Load || message == Message::Run) {
            m_loader = message == Message::Load;
            m_mode = Drive::Off;
            sayLoaded(wholeProgram);
        } else if (message == Message::Piece && m_loader && at + pieceSize <= m_flash.size()) {
            std::copy_n(data.begin() + 2, pieceSize, m_flash.begin() + at);
            sayLoaded(at);
        }
    }

    CanLink &m_link;
    Clock &m_clock;
    int m_address;
    MotorModel m_motor;
    bool m_powered = false;
    bool m_loader = false;
    bool m_endSwitch = false;
    Drive m_mode = Drive::Off;
    std::int32_t m_target = 0;
    double m_duty = 0.0;
    Instant m_driven{};
    Instant m_turned{};
    std::array<std::int32_t, 3> m_stored{5000, 200, 10000};
    std::array<std::int32_t, 3> m_values{};
    std::array<std::uint8_t, programSize> m_flash{};
    Timer m_loop;
    Timer m_report;
    std::list<Timer> m_answers;
    Subscription m_received;
};

} // namespace

Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit)
{
    auto *const can = dynamic_cast<CanLink *>(&link);
    if (!can)
        return fail(Fault::Unsupported, say("it lives on CAN links only"));
    if (unit.address < 1 || unit.address > highestAddress)
        return fail(Fault::OutOfRange, say("it has an address from 1 to 15, not %1", unit.address));
    const MotorParameters *motor = motorByName("25d");
    for (const auto &[key, value] : unit.options) {
        motor = key == "motor" ? motorByName(value) : nullptr;
        if (!motor)
            return fail(Fault::OutOfRange, say("it has no option %1=%2", key, value));
    }
    return std::unique_ptr<Simulator>(std::make_unique<Unit>(*can, clock, unit.address, *motor));
}

} // namespace mb::tinker
