// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/virtualclock.h"
#include "model/family.h"
#include "model/registry.h"
#include "model/session.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mb::test {

/// Runs a task on a virtual clock to its end, at most `limit` of virtual time; Timeout when it is not finished then.
template <class T> Result<T> run(VirtualClock &clock, Task<T> task, Duration limit = std::chrono::minutes(5))
{
    task.start();
    if (!clock.runUntil([&task] { return task.isFinished(); }, limit))
        return fail(Fault::Timeout, say("the task is still suspended"));
    return std::move(task.result());
}

/// A session of all families on a simulated bench, in virtual time.
struct SimulatedSession {
    /// `unit` in the notation of `simulate` instead of the bench's own.
    explicit SimulatedSession(std::string_view address = "sim:can", std::string_view unit = {})
        : m_unit(unit)
        , m_families(familiesWith(unit))
        , session(clock, m_families)
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

private:
    /// Those of the program, the family of the unit with it as its bench.
    std::vector<const Family *> familiesWith(std::string_view unit)
    {
        std::vector<const Family *> list(families().begin(), families().end());
        for (const Family *&family : list) {
            if (!unit.starts_with(std::string(family->key) + ':'))
                continue;
            m_units[0] = m_unit;
            m_family = std::make_unique<Family>(*family);
            m_family->bench = m_units;
            family = m_family.get();
        }
        return list;
    }
    std::string m_unit;
    std::array<std::string_view, 1> m_units{};
    std::unique_ptr<Family> m_family;
    std::vector<const Family *> m_families;

public:
    VirtualClock clock;
    Session session;
    Link *link = nullptr;
};

} // namespace mb::test
