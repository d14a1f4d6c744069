// SPDX-License-Identifier: GPL-3.0-or-later
// Whoever gave an order is answered, whatever becomes of it.
#include "app/engine/enginecore.h"
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

template <class O> O example(const Place &place)
{
    O order{};
    if constexpr (requires { order.device; })
        order.device = place.id;
    return order;
}

template <> orders::OpenLink example(const Place &place)
{
    return {*LinkAddress::parse(place.link)};
}

template <> orders::CloseLink example(const Place &place)
{
    return {place.link};
}

template <> orders::ScanLinks example(const Place &)
{
    return {};
}

template <> orders::ScanEverything example(const Place &place)
{
    return {place.link};
}

template <> orders::CancelScan example(const Place &place)
{
    return {place.link};
}

template <> orders::FindMute example(const Place &place)
{
    return {place.link, std::string(place.family.key), 60};
}

template <> orders::SendFrame example(const Place &place)
{
    return {place.link, {}};
}

template <> orders::WriteParameters example(const Place &place)
{
    for (std::uint16_t i = 0; i < place.family.parameters.size(); ++i) {
        const Parameter &row = place.family.parameters[i];
        if (row.access != Access::ReadOnly && row.nature == Nature::Setting)
            return {place.id, {{{i}, toRaw(row, row.fallback).value_or(0)}}};
    }
    return {place.id, {}};
}

template <> orders::RestoreParameters example(const Place &place)
{
    return {place.id, example<orders::WriteParameters>(place).changes};
}

template <> orders::Rename example(const Place &place)
{
    return {place.id, "intake"};
}

template <> orders::Renumber example(const Place &place)
{
    return {place.id, 42};
}

template <> orders::Calibrate example(const Place &place)
{
    return {place.id, "counts_per_revolution", 100.0};
}

template <> orders::SetDialect example(const Place &place)
{
    return {place.id, "F"};
}

template <> orders::WishRates example(const Place &place)
{
    return {1, {{place.id, {0}, 100.0}}};
}

template <> orders::StartMotion example(const Place &place)
{
    return {place.id, gentle(place), 1s};
}

template <> orders::UpdateMotion example(const Place &place)
{
    return {place.id, gentle(place)};
}

template <> orders::DismissStops example(const Place &)
{
    return {};
}

template <> orders::RunExperiment example(const Place &place)
{
    return {place.id, "gain-scales", {}};
}

template <> orders::RunTrial example(const Place &place)
{
    return {place.id, stepOf(place), {}};
}

template <> orders::PayGains example(const Place &place)
{
    return {place.id, 1};
}

template <> orders::DismissGains example(const Place &place)
{
    return {place.id, 1};
}

template <> orders::UpdateFirmware example(const Place &place)
{
    return {place.id, std::make_shared<FirmwareImage>(), {}};
}

template <> orders::CancelOperation example(const Place &)
{
    return {{1}};
}

template <> orders::StartRecording example(const Place &place)
{
    return {place.link, place.folder + "/a.log"};
}

template <> orders::StopRecording example(const Place &place)
{
    return {place.link};
}

template <> orders::SteerReplay example(const Place &place)
{
    return {place.link, {}};
}

/// One of each kind that there is: an order that is added without an example does not compile, or is one of a device.
template <std::size_t... kind> std::vector<Order> everyOrder(const Place &place, std::index_sequence<kind...>)
{
    return {example<std::variant_alternative_t<kind, Order>>(place)...};
}

constexpr auto everyKind = std::make_index_sequence<std::variant_size_v<Order>>();

enum class Fate { LinkClosed, LinkClosedLater, PowerCut, Stopped, EngineEnds };
const std::array fates{Fate::LinkClosed, Fate::LinkClosedLater, Fate::PowerCut, Fate::Stopped, Fate::EngineEnds};

class Answers : public testing::TestWithParam<const Family *> { };

/// How often it was answered.
int answersTo(const Family &family, std::size_t kind, Fate fate)
{
    const test::TemporaryFolder folder;
    VirtualClock clock;
    int answers = 0;
    auto core = std::make_unique<EngineCore>(clock, families(), false);
    const std::string link = "sim:" + std::string(toString(family.links.front()));
    core->send(orders::OpenLink{*LinkAddress::parse(link)}, [](const Result<void> &) {});
    clock.advance(3s);
    const auto devices = core->session().devices();
    const auto found = std::find_if(devices.begin(), devices.end(), [&family](const Device *device) {
        return &device->family() == &family && device->identity().state == DeviceState::Online;
    });
    EXPECT_NE(found, devices.end());
    if (found == devices.end())
        return 0;
    Place place{*core, core->session().idOf(**found), family, link, folder.path()};
    core->carryOut(everyOrder(place, everyKind).at(kind), Reply([&answers](const Result<Answer> &) { ++answers; }));
    switch (fate) {
    case Fate::LinkClosed: core->send(orders::CloseLink{link}); break;
    case Fate::LinkClosedLater:
        clock.advance(7ms);
        core->send(orders::CloseLink{link});
        break;
    case Fate::PowerCut:
        for (const Link *open : core->session().links()) {
            for (Simulator *simulator : core->session().bench(*open)->simulators())
                simulator->setPowered(false);
        }
        break;
    case Fate::Stopped: core->stopAll(StopCause::User); break;
    case Fate::EngineEnds: core.reset(); break;
    }
    (void)clock.runUntil([&answers] { return answers > 0; }, 2min);
    clock.advance(1s);
    return answers;
}

TEST(Reply, IsGivenOnceByTheFirstWhoGivesOne)
{
    std::vector<Result<Answer>> heard;
    {
        const Reply reply([&heard](Result<Answer> answer) { heard.push_back(std::move(answer)); });
        const auto finished = reply.as<void>();
        finished(fail(Fault::Refused, say("no")));
        finished({});
        reply.give(Answer());
    }
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard.front().error().fault, Fault::Refused);
}

TEST(Reply, ToAnOrderThatIsDroppedIsWhy)
{
    std::vector<Result<tuning::Trial>> heard;
    const auto finished
        = Reply::from<tuning::Trial>([&heard](Result<tuning::Trial> trial) { heard.push_back(std::move(trial)); });
    Reply(finished).as<tuning::Trial>()(tuning::Trial());
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_TRUE(heard.back());
    const std::function<void(Result<tuning::Trial>)> dropped = Reply(finished).as<tuning::Trial>(); // and never called
    EXPECT_EQ(heard.size(), 1U) << "whoever holds it may still call it";
    (void)Reply(finished);
    ASSERT_EQ(heard.size(), 2U);
    EXPECT_EQ(heard.back().error().fault, Fault::Cancelled);
}

TEST_P(Answers, EveryOrderIsAnsweredOnceWhateverBecomesOfIt)
{
    for (std::size_t kind = 0; kind < std::variant_size_v<Order>; ++kind) {
        for (const Fate fate : fates)
            EXPECT_EQ(answersTo(*GetParam(), kind, fate), 1) << "order " << kind << ", fate " << static_cast<int>(fate);
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, Answers, testing::ValuesIn(families().begin(), families().end()),
    [](const auto &row) { return std::string(row.param->key); });

} // namespace
} // namespace mb
