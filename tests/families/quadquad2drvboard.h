// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/experiments.h"
#include "model/operation.h"
#include "support/simulatedsession.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace mb::quadquad2drv {

using namespace std::chrono_literals;
using test::run;

/// The family with another board on its bench.
inline const Family &familyWith(std::string_view unit)
{
    static std::array<std::string_view, 1> units;
    static Family family;
    units = {unit};
    family = *findFamily(families(), "quadquad2drv");
    family.bench = units;
    return family;
}

struct Board {
    explicit Board(std::string_view unit)
        : family(familyWith(unit))
        , known{&family}
        , session(clock, known)
        , renewal(clock)
    {
        const auto opened = session.openLink(*LinkAddress::parse("sim:spi"));
        EXPECT_TRUE(opened);
        link = *opened;
        const auto found = run(clock, session.scan(*link));
        EXPECT_TRUE(found && found->size() == 1);
        device = found->front();
        heard = link->traffic().add([this](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent)
                sent.emplace_back(traffic.bytes.begin(), traffic.bytes.end());
        });
        clock.advance(300ms);
    }
    SetPointStream &stream() { return session.stream(*device); }
    Simulator &board() { return *session.bench(*link)->simulators().front(); }
    /// As a window that is alive.
    void renew()
    {
        stream().renew();
        renewal.startIn(100ms, [this] { renew(); });
    }
    Result<ExperimentReport> find(const ExperimentOptions &options, Operation &operation)
    {
        renew();
        std::optional<Result<ExperimentReport>> end;
        operation.run<ExperimentReport>(findGainScales(*device, stream(), options, operation),
            [&end](Result<ExperimentReport> result) { end = std::move(result); });
        EXPECT_TRUE(clock.runUntil([&end] { return end.has_value(); }, 20min));
        renewal.stop();
        return end ? std::move(*end) : fail(Fault::Timeout, say("it did not end"));
    }
    [[nodiscard]] double kept(std::string_view key) const { return device->knowledge().profile().calibrated(key); }
    [[nodiscard]] bool hasSent(const Bytes &packet) const
    {
        return std::find(sent.begin(), sent.end(), packet) != sent.end();
    }

    const Family &family;
    std::array<const Family *, 1> known;
    VirtualClock clock;
    Session session;
    Timer renewal;
    Link *link = nullptr;
    Device *device = nullptr;
    std::vector<Bytes> sent;
    Subscription heard;
};

inline ExperimentOptions withPower(double power, int axis = 1)
{
    ExperimentOptions options;
    options.power = power;
    options.axis = axis;
    return options;
}

} // namespace mb::quadquad2drv
