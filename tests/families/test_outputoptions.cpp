// SPDX-License-Identifier: GPL-3.0-or-later
// Capabilities::output of every family: an option that it has changes what is sent, another is refused.
#include "support/simulatedsession.h"
#include "wire/bytelog.h"

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;

struct FirstUnit {
    explicit FirstUnit(const Family &family)
        : bench("sim:" + std::string(toString(family.links.front())))
    {
        bench.scan();
        const auto units = bench.devices(family.key);
        device
            = *std::ranges::find(units, DeviceState::Online, [](const Device *unit) { return unit->identity().state; });
    }
    test::SimulatedSession bench;
    Device *device = nullptr;
};

/// What goes out in the first moments of a motion.
std::string sentFor(const Family &family, const SetPoint &setPoint)
{
    FirstUnit unit(family);
    unit.bench.clock.advance(200ms);
    std::string sent;
    const Subscription tap = unit.device->link().traffic().add([&sent](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent)
            sent += (traffic.can ? toText(*traffic.can) : toHexText(traffic.bytes)) + '\n';
    });
    EXPECT_TRUE(unit.bench.session.stream(*unit.device).start(setPoint, 10s));
    unit.bench.clock.advance(100ms);
    return sent;
}

TEST(OutputOptions, ChangeWhatIsSentOrAreRefused)
{
    using Change = void (*)(SetPoint &);
    for (const Family *family : families()) {
        const OutputOptions &can = family->capabilities.output;
        SetPoint plain;
        plain.mode = family->modes.front();
        plain.target = plain.mode == Mode::Duty ? 0.3 : 1000.0;
        const std::string usual = sentFor(*family, plain);
        EXPECT_EQ(sentFor(*family, plain), usual);
        const FirstUnit unit(*family);
        const auto expect = [&](bool has, std::string_view what, Change change) {
            SetPoint changed = plain;
            change(changed);
            const Result<void> checked = unit.device->check(changed);
            EXPECT_EQ(checked.has_value(), has) << family->key << ' ' << what;
            if (!checked) {
                EXPECT_EQ(checked.error().fault, Fault::Unsupported) << family->key << ' ' << what;
            } else if (has) {
                EXPECT_NE(sentFor(*family, changed), usual) << family->key << ' ' << what;
            }
        };
        expect(can.brake, "brake", [](SetPoint &s) { s.brake = true; });
        expect(can.brake, "coast", [](SetPoint &s) { s.brake = false; });
        expect(can.directions, "motor", [](SetPoint &s) { s.reverseMotor = true; });
        expect(can.directions, "sensor", [](SetPoint &s) { s.reverseSensor = true; });
        expect(can.limits, "limits", [](SetPoint &s) { s.overrideLimits = true; });
        expect(can.ramps(plain.mode), "ramp", [](SetPoint &s) { s.ramp = 0.01; });
    }
}

TEST(OutputOptions, ARampIsRefusedInTheModesThatDoNotKeepIt)
{
    for (const Family *family : families()) {
        const FirstUnit unit(*family);
        for (const Mode mode : family->modes) {
            SetPoint ramped;
            ramped.mode = mode;
            ramped.target = mode == Mode::Follow ? unit.device->identity().address + 1 : 0.0;
            ramped.velocity = mode == Mode::RampPosition ? 100.0 : 0.0;
            ramped.ramp = 0.01;
            EXPECT_EQ(unit.device->check(ramped).has_value(), family->capabilities.output.ramps(mode))
                << family->key << ' ' << toString(mode);
        }
    }
}

} // namespace
} // namespace mb
