// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/autotune.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
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
            co_return full();
        co_return static_cast<std::int64_t>(begun.size());
    }
    Task<void> owe(std::int64_t, std::string unit, std::vector<tuning::OwedValue> values) override
    {
        log.emplace_back("owe");
        if (whenOwed)
            whenOwed();
        if (isFull)
            co_return full();
        noteTime();
        debtor = std::move(unit);
        if (std::exchange(isPutBack, false))
            owed.clear();
        for (tuning::OwedValue &value : values) {
            if (std::none_of(owed.begin(), owed.end(), [&](const auto &known) { return known.key == value.key; }))
                owed.push_back(std::move(value));
        }
        co_return {};
    }
    Task<void> markPutBack(std::int64_t) override
    {
        log.emplace_back("put back");
        if (isFull)
            co_return full();
        noteTime();
        isPutBack = true;
        co_return {};
    }
    Task<void> release(std::string, std::vector<std::string> keys) override
    {
        log.emplace_back("release");
        if (releaseFails || isFull)
            co_return full();
        std::erase_if(owed, [&keys](const tuning::OwedValue &value) {
            return std::find(keys.begin(), keys.end(), value.key) != keys.end();
        });
        co_return {};
    }
    Task<void> settle(std::int64_t) override
    {
        log.emplace_back("settle");
        if (isFull)
            co_return full();
        owed.clear();
        co_return {};
    }
    Task<void> complete(std::int64_t, tuning::Trial trial) override
    {
        log.emplace_back("complete");
        if (isFull)
            co_return full();
        completed.push_back(std::move(trial));
        co_return {};
    }
    void abandon(std::int64_t) override { log.emplace_back("abandon"); }
    Task<void> keepTuning(tuning::TuneReport report) override
    {
        log.emplace_back("tuning");
        if (isFull)
            co_return full();
        tunings.push_back(std::move(report));
        co_return {};
    }
    Task<std::vector<tuning::OwedGains>> owedTo(std::string unit) override
    {
        std::vector<tuning::OwedGains> all;
        if (isFull)
            co_return full();
        if (!owed.empty() && unit == debtor)
            all.push_back({static_cast<std::int64_t>(begun.size()), owedAt, owed, isPutBack, isUnderWay});
        for (tuning::OwedGains &debt : all) {
            for (tuning::OwedValue &value : debt.values)
                value.isKept = isKept;
        }
        co_return all;
    }

    [[nodiscard]] static tl::unexpected<Error> full() { return fail(Fault::NotKept, say("the disk is full")); }
    void noteTime()
    {
        if (clock)
            owedAt = std::chrono::duration<double>(clock->now().time_since_epoch() + clock->unixOffset()).count();
    }

    std::vector<std::string> log;
    std::function<void()> whenOwed; ///< while it is written down
    std::vector<tuning::OwedValue> owed;
    const Clock *clock = nullptr; ///< of `owedAt`; nullptr: 0
    double owedAt = 0.0;          ///< Unix, s
    bool isPutBack = false;       ///< and the unit may not have it for good
    std::string debtor;           ///< the unit that `owed` is for
    std::vector<tuning::Trial> begun;
    std::vector<tuning::Trial> completed;
    std::vector<tuning::TuneReport> tunings;
    bool isUnderWay = false; ///< by another program
    bool isFull = false;
    bool releaseFails = false;
    bool isKept = false; ///< what is owed is of a tuning that is kept
};

} // namespace mb::test
