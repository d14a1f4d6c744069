// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/simulatedsession.h"
#include "tuning/experiment.h"

#include <memory>
#include <string_view>
#include <vector>

namespace mb::test {

/// Keeps in memory what an experiment writes down, and in which order.
class FakeJournal final : public tuning::ExperimentJournal {
public:
    Task<std::int64_t> begin(tuning::Trial trial) override
    {
        log.emplace_back("begin");
        begun.push_back(std::move(trial));
        if (isFull)
            co_return fail(Fault::OutOfRange, "the disk is full");
        co_return static_cast<std::int64_t>(begun.size());
    }
    Task<void> owe(std::int64_t, std::string, std::vector<tuning::OwedValue> values) override
    {
        log.emplace_back("owe");
        owed = std::move(values);
        co_return {};
    }
    Task<void> settle(std::int64_t) override
    {
        log.emplace_back("settle");
        owed.clear();
        co_return {};
    }
    Task<void> complete(std::int64_t, tuning::Trial trial) override
    {
        log.emplace_back("complete");
        completed.push_back(std::move(trial));
        co_return {};
    }

    std::vector<std::string> log;
    std::vector<tuning::OwedValue> owed;
    std::vector<tuning::Trial> begun;
    std::vector<tuning::Trial> completed;
    bool isFull = false;
};

/// Experiments on the simulated bench in virtual time. The lease is renewed as the console does, unless a test hangs it.
struct ExperimentBench {
    explicit ExperimentBench(std::string_view link = "sim:can", std::string_view family = "dmc60c", int address = 5)
        : bench(link)
        , renewal(bench.clock)
    {
        bench.scan();
        device = bench.device(address, family);
        EXPECT_NE(device, nullptr) << family;
        bench.clock.advance(std::chrono::milliseconds(300));
        surroundings.journal = &journal;
        surroundings.directions = &directions;
        surroundings.interruption = &interruption;
        surroundings.note = [this](const std::string &text) { notes.push_back(text); };
        renew();
    }
    void renew()
    {
        renewal.startIn(std::chrono::milliseconds(100), [this] {
            bench.session.stream(*device).renew();
            renew();
        });
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
