// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "model/registry.h"
#include "model/unit.h"
#include "support/fakejournal.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

namespace mb::test {

/// The engine's half with a notebook, on simulated units: experiments are of DMC60C #7. Virtual time.
class TrialCore : public testing::Test {
protected:
    TrialCore()
        : renewal(clock)
    {
        core.setJournal(&journal);
        core.send(orders::OpenLink{*LinkAddress::parse("sim:can")});
        EXPECT_TRUE(
            clock.runUntil([this] { return device() && device()->liveness().heard; }, std::chrono::seconds(10)));
        clock.advance(std::chrono::seconds(2));
        renew();
    }
    [[nodiscard]] Device *device()
    {
        for (Device *one : core.session().devices()) {
            if (one->identity().address == 7 && one->family().key == "dmc60c")
                return one;
        }
        return nullptr;
    }
    [[nodiscard]] DeviceId id() { return core.session().idOf(*device()); }
    [[nodiscard]] ParameterIndex p() { return *findParameter(device()->family().parameters, "slot0.p"); }
    [[nodiscard]] std::int64_t stored()
    {
        std::optional<std::int64_t> raw;
        core.send(orders::ReadParameters{id()});
        EXPECT_TRUE(clock.runUntil([this] { return !isBusy(); }, std::chrono::seconds(10)));
        raw = device()->parameters().entry(p()).raw;
        return raw.value_or(-1);
    }
    [[nodiscard]] bool isBusy()
    {
        const Snapshot shot = core.snapshot();
        const OperationView *operation = shot.operation(id());
        return operation && operation->status.state == OperationStatus::State::Running;
    }
    [[nodiscard]] bool isOutputOn()
    {
        for (Simulator *unit : core.session().bench(*core.session().links().front())->simulators()) {
            if (unit->isOutputOn())
                return true;
        }
        return false;
    }
    void renew()
    {
        core.send(orders::RenewMotion{id()});
        renewal.startIn(std::chrono::milliseconds(100), [this] { renew(); });
    }
    void start(tuning::Keep keep)
    {
        tuning::ExperimentPlan plan;
        plan.mode = Mode::Velocity;
        plan.to = 60'000.0;
        plan.gains = {{p(), 30'000}};
        plan.keep = keep;
        measured.clear();
        ended.reset();
        core.send(orders::RunTrial{id(), plan,
                      [this](const tuning::Trial &trial) { measured.emplace_back(clock.now(), trial); }},
            ended.finished());
    }
    [[nodiscard]] bool ends()
    {
        return clock.runUntil([this] { return ended.has_value(); }, std::chrono::seconds(60));
    }

    VirtualClock clock;
    FakeJournal journal;
    EngineCore core{clock, families(), false};
    Timer renewal;
    std::vector<std::pair<Instant, tuning::Trial>> measured;
    Heard<tuning::Trial> ended;
};

} // namespace mb::test
