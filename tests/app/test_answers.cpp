// SPDX-License-Identifier: GPL-3.0-or-later
// Whoever gave an order is answered, whatever becomes of it.
#include "app/enginecore.h"
#include "async/virtualclock.h"
#include "model/registry.h"
#include "support/temporaryfile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace mb {
namespace {

using namespace std::chrono_literals;

struct Place {
    EngineCore &core;
    DeviceId id;
    const Family &family;
    std::string link;
    std::string folder;
};

struct Order {
    const char *name;
    void (*give)(Place &, const EngineCore::Finished &);
};

SetPoint gentle(const Place &place)
{
    SetPoint setPoint;
    setPoint.mode = place.family.modes.front();
    setPoint.target = setPoint.mode == Mode::Duty ? 0.1 : 500.0;
    return setPoint;
}

tuning::ExperimentPlan stepOf(const Place &place)
{
    tuning::ExperimentPlan plan;
    plan.mode = place.family.key == "supermodified" ? Mode::Position : Mode::Velocity;
    plan.to = 2000.0;
    return plan;
}

const std::array orders{
    Order{"writeParameters",
        [](Place &p, const EngineCore::Finished &f) {
            for (std::uint16_t i = 0; i < p.family.parameters.size(); ++i) {
                const Parameter &row = p.family.parameters[i];
                if (row.access != Access::ReadOnly && row.nature == Nature::Setting)
                    return p.core.writeParameters(p.id, {{{i}, toRaw(row, row.fallback).value_or(0)}}, f);
            }
        }},
    Order{"storeParameters", [](Place &p, const EngineCore::Finished &f) { p.core.storeParameters(p.id, f); }},
    Order{"rewriteSettings", [](Place &p, const EngineCore::Finished &f) { p.core.rewriteSettings(p.id, f); }},
    Order{"experiment", [](Place &p, const EngineCore::Finished &f) { p.core.experiment(p.id, "gain-scales", {}, f); }},
    Order{"runTrial",
        [](Place &p, const EngineCore::Finished &f) {
            p.core.runTrial(p.id, stepOf(p), {},
                [f](const Result<tuning::Trial> &trial) { f(trial ? Result<void>() : fail(trial.error())); });
        }},
    Order{"payGains", [](Place &p, const EngineCore::Finished &f) { p.core.payGains(p.id, 1, f); }},
    Order{"dismissGains", [](Place &p, const EngineCore::Finished &f) { p.core.dismissGains(p.id, 1, f); }},
    Order{"identify", [](Place &p, const EngineCore::Finished &f) { p.core.identify(p.id, f); }},
    Order{"rename", [](Place &p, const EngineCore::Finished &f) { p.core.rename(p.id, "intake", f); }},
    Order{"renumber", [](Place &p, const EngineCore::Finished &f) { p.core.renumber(p.id, 42, f); }},
    Order{"clearFaults", [](Place &p, const EngineCore::Finished &f) { p.core.clearFaults(p.id, f); }},
    Order{"calibrate",
        [](Place &p, const EngineCore::Finished &f) { p.core.calibrate(p.id, "counts_per_revolution", 100.0, f); }},
    Order{"setDialect", [](Place &p, const EngineCore::Finished &f) { p.core.setDialect(p.id, "F", f); }},
    Order{"startMotion", [](Place &p, const EngineCore::Finished &f) { p.core.startMotion(p.id, gentle(p), 1s, f); }},
    Order{"updateMotion", [](Place &p, const EngineCore::Finished &f) { p.core.updateMotion(p.id, gentle(p), f); }},
    Order{"releaseMoves", [](Place &p, const EngineCore::Finished &f) { p.core.releaseMoves(p.id, f); }},
    Order{"zeroPosition", [](Place &p, const EngineCore::Finished &f) { p.core.zeroPosition(p.id, f); }},
    Order{"sendFrame", [](Place &p, const EngineCore::Finished &f) { p.core.sendFrame(p.link, {}, f); }},
    Order{"startRecording",
        [](Place &p, const EngineCore::Finished &f) { p.core.startRecording(p.link, p.folder + "/a.log", f); }},
};

enum class Fate { LinkClosed, LinkClosedLater, PowerCut, Stopped };
const std::array fates{Fate::LinkClosed, Fate::LinkClosedLater, Fate::PowerCut, Fate::Stopped};

class Answers : public testing::TestWithParam<const Family *> { };

/// How often it was answered.
int answersTo(const Family &family, const Order &order, Fate fate)
{
    const test::TemporaryFolder folder;
    VirtualClock clock;
    int answers = 0;
    auto core = std::make_unique<EngineCore>(clock, families(), false);
    const std::string link = "sim:" + std::string(toString(family.links.front()));
    core->openLink(*LinkAddress::parse(link), [](const Result<void> &) {});
    clock.advance(3s);
    const auto devices = core->session().devices();
    const auto found = std::find_if(devices.begin(), devices.end(), [&family](const Device *device) {
        return &device->family() == &family && device->identity().state == DeviceState::Online;
    });
    EXPECT_NE(found, devices.end());
    if (found == devices.end())
        return 0;
    Place place{*core, core->session().idOf(**found), family, link, folder.path()};
    order.give(place, [&answers](const Result<void> &) { ++answers; });
    switch (fate) {
    case Fate::LinkClosed: core->closeLink(link); break;
    case Fate::LinkClosedLater:
        clock.advance(7ms);
        core->closeLink(link);
        break;
    case Fate::PowerCut:
        for (Simulator *simulator : core->session().bench(*core->session().links().front())->simulators())
            simulator->setPowered(false);
        break;
    case Fate::Stopped: core->stopAll(StopCause::User); break;
    }
    (void)clock.runUntil([&answers] { return answers > 0; }, 2min);
    clock.advance(1s);
    return answers;
}

TEST_P(Answers, EveryOrderIsAnsweredOnceWhateverBecomesOfIt)
{
    for (const Order &order : orders) {
        for (const Fate fate : fates)
            EXPECT_EQ(answersTo(*GetParam(), order, fate), 1) << order.name << ", fate " << static_cast<int>(fate);
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, Answers, testing::ValuesIn(families().begin(), families().end()),
    [](const auto &row) { return std::string(row.param->key); });

} // namespace
} // namespace mb
