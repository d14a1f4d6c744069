// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/virtualclock.h"
#include "model/registry.h"
#include "model/session.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace mb::test {

/// Runs a task on a virtual clock to its end, at most `limit` of virtual time; Timeout when it is not finished then.
template <class T> Result<T> run(VirtualClock &clock, Task<T> task, Duration limit = std::chrono::minutes(5))
{
    task.start();
    if (!clock.runUntil([&task] { return task.isFinished(); }, limit))
        return fail(Fault::Timeout, "the task is still suspended");
    return std::move(task.result());
}

/// A session of all families on a simulated bench, in virtual time.
struct SimulatedSession {
    explicit SimulatedSession(std::string_view address = "sim:can")
        : session(clock, families())
    {
        const auto parsed = LinkAddress::parse(address);
        EXPECT_TRUE(parsed);
        const auto opened = session.openLink(*parsed);
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        link = opened ? *opened : nullptr;
    }
    std::vector<Device *> scan()
    {
        auto found = run(clock, session.scan(*link));
        EXPECT_TRUE(found) << (found ? "" : found.error().text());
        return found.value_or(std::vector<Device *>{});
    }
    /// Several families may have a unit of this address; the tests of the session itself use this one's.
    Device *device(int address, std::string_view family = "dmc60c")
    {
        for (Device *candidate : devices(family)) {
            if (candidate->identity().address == address)
                return candidate;
        }
        return nullptr;
    }
    std::vector<Device *> devices(std::string_view family)
    {
        std::vector<Device *> found = session.devices();
        std::erase_if(found, [family](const Device *device) { return device->family().key != family; });
        return found;
    }
    Simulator *simulator(const std::string &name)
    {
        for (Simulator *candidate : session.bench(*link)->simulators()) {
            if (candidate->name() == name)
                return candidate;
        }
        return nullptr;
    }
    ParameterIndex index(const Device &of, std::string_view key) const
    {
        const auto found = findParameter(of.parameters().table(), key);
        EXPECT_TRUE(found) << key;
        return found.value_or(ParameterIndex{});
    }

    VirtualClock clock;
    Session session;
    Link *link = nullptr;
};

} // namespace mb::test
