// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experiment.h"
#include "support/fakejournal.h"
#include "support/simulatedsession.h"

#include <memory>
#include <string_view>
#include <vector>

namespace mb::test {

/// Experiments on the simulated bench in virtual time. The lease is renewed as the console does, unless a test hangs it.
struct ExperimentBench {
    /// `unit` in the notation of `simulate` instead of the bench's own units of the family.
    explicit ExperimentBench(std::string_view link = "sim:can", std::string_view family = "dmc60c", int address = 5,
        std::string_view unit = {})
        : bench(link, unit)
        , renewal(bench.clock)
    {
        bench.scan();
        device = bench.device(address, family);
        EXPECT_NE(device, nullptr) << family;
        bench.clock.advance(std::chrono::milliseconds(300));
        surroundings.journal = &journal;
        surroundings.directions = &directions;
        surroundings.interruption = &interruption;
        surroundings.note = [this](const Message &text) { notes.push_back(text.english()); };
        renew();
    }
    void renew()
    {
        bench.session.stream(*device).renew();
        renewal.startIn(std::chrono::milliseconds(100), [this] { renew(); });
    }
    [[nodiscard]] Task<tuning::Trial> start(tuning::ExperimentPlan plan)
    {
        return tuning::runExperiment(*device, bench.session.stream(*device), std::move(plan), surroundings);
    }
    [[nodiscard]] Result<tuning::Trial> run(tuning::ExperimentPlan plan)
    {
        plan.slot = std::min(plan.slot, device->family().capabilities.gainSlots - 1);
        return test::run(bench.clock, start(std::move(plan)));
    }
    [[nodiscard]] Simulator *simulator()
    {
        return bench.simulator(std::string(device->family().key) + ':' + std::to_string(device->identity().address));
    }
    [[nodiscard]] ParameterChange change(std::string_view key, double value) const
    {
        const ParameterIndex index = bench.index(*device, key);
        return {index, toRaw(device->parameters().parameter(index), value).value_or(0)};
    }

    SimulatedSession bench;
    Device *device = nullptr;
    FakeJournal journal;
    tuning::DirectionBook directions;
    tuning::Interruption interruption;
    std::vector<std::string> notes;
    tuning::ExperimentSurroundings surroundings;
    Timer renewal;
};

[[nodiscard]] inline tuning::ExperimentPlan stepTo(Mode mode, double to)
{
    tuning::ExperimentPlan plan;
    plan.mode = mode;
    plan.to = to;
    plan.slot = mode == Mode::Position ? 1 : 0;
    return plan;
}

} // namespace mb::test
