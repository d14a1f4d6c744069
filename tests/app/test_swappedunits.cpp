// SPDX-License-Identifier: GPL-3.0-or-later
// Another unit takes the place of one under the same number: nothing that was meant for the former reaches it. Virtual time.
#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "firmware/firmwareimage.h"
#include "heard.h"
#include "model/registry.h"
#include "model/unit.h"
#include "storage/database.h"
#include "storage/settingsbook.h"
#include "support/coreapplication.h"
#include "support/fakejournal.h"
#include "support/sourcetree.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr const char *left = "A00000000001";
constexpr const char *right = "B00000000002";

class SwappedUnits : public testing::Test {
protected:
    SwappedUnits()
        : SwappedUnits("dmc60c", "sim:can",
            {"dmc60c:5,serial=A00000000001,gains=default", "dmc60c:5,serial=B00000000002,gains=default"}, left)
    {
    }
    SwappedUnits(
        const char *key, const char *link, const std::array<std::string_view, 2> &both, const std::string &first)
        : family(*findFamily(families(), key))
        , units(both)
    {
        test::needCoreApplication();
        family.bench = units;
        auto opened = Database::open(folder.path().toStdString() + "/motorbench.db");
        EXPECT_TRUE(opened);
        database = std::move(*opened);
        book = std::make_unique<SettingsBook>(*database, clock, "anna");
        core = std::make_unique<EngineCore>(clock, only, false);
        core->setSettingsLog(book.get());
        core->setJournal(&journal);
        core->send(orders::OpenLink{*LinkAddress::parse(link)});
        EXPECT_TRUE(clock.runUntil([this] { return !core->session().links().empty(); }, 1s));
        power(1, false);
        EXPECT_TRUE(clock.runUntil([&] { return device() && serial() == first && device()->liveness().heard; }, 10s));
        clock.advance(5s);
    }
    void power(std::size_t unit, bool on)
    {
        core->session().bench(*core->session().links().front())->simulators().at(unit)->setPowered(on);
    }
    [[nodiscard]] Device *device()
    {
        const auto all = core->session().devices();
        return all.empty() ? nullptr : all.front();
    }
    [[nodiscard]] std::string serial() { return device()->identity().serial; }
    [[nodiscard]] DeviceId id() { return core->session().idOf(*device()); }
    /// The one is plugged out, the other in.
    void swap(std::size_t out, std::size_t in, Duration pause = 1s)
    {
        power(out, false);
        clock.advance(pause);
        power(in, true);
    }
    /// Until it has told who it is.
    void meet(const char *who)
    {
        EXPECT_TRUE(clock.runUntil([&] { return serial() == who && !device()->liveness().restarted; }, 20s));
        clock.advance(3s); // and was read
    }
    [[nodiscard]] ParameterChange change(const char *key, double value)
    {
        const ParameterIndex index = *findParameter(family.parameters, key);
        return {index, *toRaw(family.parameters[index.value], value)};
    }
    [[nodiscard]] Result<void> ordered(Order order)
    {
        test::Heard<> answered;
        core->send(std::move(order), answered.finished());
        EXPECT_TRUE(clock.runUntil([&] { return answered.has_value(); }, 60s));
        return answered.value_or(fail(Fault::Timeout));
    }
    [[nodiscard]] std::optional<std::int64_t> read(const char *key)
    {
        EXPECT_TRUE(ordered(orders::ReadParameters{id()}));
        return device()->parameters().entry(*findParameter(family.parameters, key)).raw;
    }

    QTemporaryDir folder;
    VirtualClock clock;
    std::unique_ptr<Database> database;
    std::unique_ptr<SettingsBook> book;
    Family family;
    std::array<std::string_view, 2> units;
    std::array<const Family *, 1> only{&family};
    test::FakeJournal journal;
    std::unique_ptr<EngineCore> core;
};

TEST_F(SwappedUnits, AnotherSerialNumberIsAnotherDeviceAndTheFormerOneIsItselfAgain)
{
    const DeviceId first = id();
    swap(0, 1);
    meet(right);
    EXPECT_EQ(core->session().devices().size(), 1U);
    EXPECT_NE(id(), first);
    EXPECT_EQ(core->session().find(first), nullptr);
    const DeviceId second = id();
    swap(1, 0);
    meet(left);
    EXPECT_EQ(id(), first);
    EXPECT_EQ(core->session().find(second), nullptr);
}

TEST_F(SwappedUnits, WhatTheFormerSentIsNotShownAsItsOwn)
{
    const auto position = *device()->telemetry()->find("position");
    clock.advance(1s);
    const Instant out = clock.now();
    swap(0, 1);
    meet(right);
    device()->telemetry()->commit();
    ASSERT_TRUE(device()->telemetry()->first(position));
    EXPECT_GT(device()->telemetry()->first(position)->time, out);
}

TEST_F(SwappedUnits, APowerCycleIsNoOtherUnit)
{
    const DeviceId first = id();
    swap(0, 0);
    clock.advance(20s);
    EXPECT_EQ(serial(), left);
    EXPECT_EQ(id(), first);
}

TEST_F(SwappedUnits, WhatWasStagedForTheFormerIsNotWritten)
{
    const DeviceId first = id();
    swap(0, 1);
    meet(right);
    EXPECT_FALSE(ordered(orders::WriteParameters{first, {change("slot0.p", 3.0)}}));
    EXPECT_EQ(read("slot0.p"), 0);
}

TEST_F(SwappedUnits, NothingIsWrittenBeforeARestartedUnitHasToldWhoItIs)
{
    ASSERT_TRUE(ordered(orders::WriteParameters{id(), {change("slot0.p", 2.0)}}));
    clock.advance(20s);
    const DeviceId first = id();
    swap(0, 1);
    ASSERT_TRUE(clock.runUntil([this] { return device()->liveness().restarted; }, 20s));
    const auto written = ordered(orders::WriteParameters{first, {change("slot0.p", 3.0)}});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().fault, Fault::Unsafe);
    EXPECT_FALSE(ordered(orders::UndoWrite{first, false}));
    meet(right);
    EXPECT_EQ(read("slot0.p"), 0);
    EXPECT_TRUE(ordered(orders::WriteParameters{id(), {change("slot0.p", 3.0)}})) << "then it may be";
}

TEST_F(SwappedUnits, AChangeThatIsToGoBackGoesIntoItsOwnUnitOnly)
{
    ASSERT_TRUE(ordered(orders::WriteParameters{id(), {change("current_limit.peak", 40.0)}}));
    ASSERT_TRUE(ordered(orders::StoreParameters{id()}));
    ASSERT_TRUE(ordered(orders::WriteParameters{id(), {change("current_limit.peak", 70.0)}}));
    clock.advance(1s);
    ASSERT_EQ(core->snapshot().unconfirmed.size(), 1U);
    swap(0, 1);
    meet(right);
    EXPECT_TRUE(core->snapshot().unconfirmed.empty()) << "the other one has no such change";
    const auto stored = read("current_limit.peak");
    clock.advance(60s);
    EXPECT_EQ(read("current_limit.peak"), stored);
}

TEST_F(SwappedUnits, GainsAreOwedToTheUnitThatAnExperimentChangedAndToNoOther)
{
    journal.debtor = unitKeyOf(*device());
    journal.owed = {{"slot0.p", 70'000}};
    swap(0, 0); // it is looked up again when it is back
    meet(left);
    core->send(orders::CloseLink{"sim:can"});
    core->send(orders::OpenLink{*LinkAddress::parse("sim:can")});
    ASSERT_TRUE(clock.runUntil([this] { return !core->session().links().empty(); }, 1s));
    power(1, false);
    ASSERT_TRUE(clock.runUntil([this] { return device() && core->owedGains().count(id()) == 1; }, 20s));
    const DeviceId first = id();
    const std::int64_t trial = core->owedGains().at(first).front().trial;
    swap(0, 1);
    meet(right);
    clock.advance(3s);
    EXPECT_TRUE(core->owedGains().empty());
    EXPECT_FALSE(ordered(orders::PayGains{id(), trial}));
    EXPECT_FALSE(ordered(orders::PayGains{first, trial}));
    EXPECT_EQ(read("slot0.p"), 0);
    EXPECT_FALSE(journal.owed.empty()) << "it is owed still";
    swap(1, 0);
    ASSERT_TRUE(clock.runUntil([&] { return core->owedGains().count(first) == 1; }, 20s)) << "it is back";
}

/// Nobody can tell one of these from the other.
class SwappedPlaces : public SwappedUnits {
protected:
    SwappedPlaces()
        : SwappedUnits("supermodified", "sim:serial", {"supermodified:4,dialect=D1", "supermodified:4,dialect=D1"}, "")
    {
    }
    [[nodiscard]] UnconfirmedView::State state() { return core->snapshot().unconfirmed.front().state; }
    /// What somebody has to keep.
    void widen()
    {
        ASSERT_TRUE(ordered(orders::WriteParameters{id(), {change("limit.current", 1500.0)}}));
        ASSERT_TRUE(ordered(orders::WriteParameters{id(), {change("limit.current", 3000.0)}}));
        clock.advance(1s);
        ASSERT_EQ(core->snapshot().unconfirmed.size(), 1U);
        EXPECT_EQ(state(), UnconfirmedView::State::Counting);
    }
};

TEST_F(SwappedPlaces, AChangeGoesBackThoughTheLineWasSilentForAMoment)
{
    widen();
    Bench &bench = *core->session().bench(*core->session().links().front());
    bench.setLoss(1.0);
    clock.advance(500ms);
    EXPECT_FALSE(device()->liveness().heard);
    bench.setLoss(0.0);
    clock.advance(1s);
    ASSERT_EQ(core->snapshot().unconfirmed.size(), 1U);
    EXPECT_EQ(state(), UnconfirmedView::State::Counting);
    clock.advance(40s);
    EXPECT_TRUE(core->snapshot().unconfirmed.empty());
    EXPECT_EQ(read("limit.current"), 1500);
}

TEST_F(SwappedPlaces, AChangeThatIsToGoBackIsOfferedWhereAnotherUnitMayStandByNow)
{
    widen();
    swap(0, 1, 5s);
    clock.advance(40s);
    ASSERT_EQ(core->snapshot().unconfirmed.size(), 1U);
    EXPECT_EQ(state(), UnconfirmedView::State::Offered);
    EXPECT_EQ(read("limit.current"), 5000) << "as it came";
}

class SwappedOnUpdate : public SwappedUnits {
protected:
    SwappedOnUpdate()
    {
        QFile file(QString::fromStdString(inSourceTree("resources/firmware/dmc60c-demo.hex")));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        auto image = FirmwareImage::fromIntelHex(file.readAll().toStdString());
        EXPECT_TRUE(image);
        core->send(orders::UpdateFirmware{id(), std::make_shared<FirmwareImage>(*image), {}}, ended.finished());
        EXPECT_TRUE(clock.runUntil([this] { return status().update.pages == 5; }, 60s));
    }
    [[nodiscard]] OperationStatus status() { return core->snapshot().operations.back().status; }
    [[nodiscard]] bool isScanned() { return core->snapshot().links.front().scanning; }
    void end()
    {
        ASSERT_TRUE(clock.runUntil([&] { return ended.has_value(); }, 5min));
    }

    test::Heard<> ended;
};

TEST_F(SwappedOnUpdate, ASearchByHandLeavesTheBusOfAnUpdateAloneWhichEndsAsIfNobodyHadAskedForIt)
{
    EXPECT_TRUE(ordered(orders::ScanLinks{}));
    EXPECT_FALSE(isScanned());
    const Result<void> everything = ordered(orders::ScanEverything{"sim:can"});
    ASSERT_FALSE(everything);
    EXPECT_EQ(everything.error().fault, Fault::Unsafe);
    end();
    EXPECT_TRUE(*ended);
    EXPECT_EQ(status().update.retries, 0);
    EXPECT_TRUE(ordered(orders::ScanLinks{}));
    EXPECT_TRUE(isScanned()) << "afterwards it may";
}

TEST_F(SwappedOnUpdate, TheUnitThatTookThePlaceDuringAnUpdateIsFreeWhenItHasEnded)
{
    swap(0, 1);
    core->send(orders::ScanLinks{});
    end();
    EXPECT_FALSE(*ended);
    EXPECT_TRUE(device()->gate().busy().empty()) << device()->gate().busy().english();
    meet(right);
    EXPECT_TRUE(ordered(orders::ReadParameters{id()}));
}

class SwappedOnTrial : public SwappedUnits, public testing::WithParamInterface<int> {
protected:
    SwappedOnTrial()
        : renewal(clock)
    {
        renew();
        tuning::ExperimentPlan plan;
        plan.mode = Mode::Velocity;
        plan.to = 20'000.0;
        plan.gains = {change("slot0.p", 0.2), change("slot0.f", 0.02)};
        plan.seconds = 6.0;
        plan.keep = tuning::Keep::Never;
        core->send(orders::RunTrial{id(), plan, {}}, ended.finished());
        EXPECT_TRUE(clock.runUntil([this] { return journal.log.size() >= 2; }, 30s));
        clock.advance(2s);
        EXPECT_FALSE(ended.has_value());
    }
    void renew()
    {
        if (device())
            core->send(orders::RenewMotion{id()});
        renewal.startIn(100ms, [this] { renew(); });
    }
    [[nodiscard]] static Duration pause() { return std::chrono::milliseconds(GetParam()); }

    Timer renewal;
    test::Heard<tuning::Trial> ended;
};

TEST_P(SwappedOnTrial, PutsNothingIntoTheNextUnit)
{
    swap(0, 1, pause());
    ASSERT_TRUE(clock.runUntil([&] { return ended.has_value(); }, 60s));
    meet(right);
    ASSERT_TRUE(*ended);
    EXPECT_EQ((*ended)->reason, tuning::EndReason::Link);
    EXPECT_FALSE(journal.owed.empty()) << "what the former one is owed stands in the notebook";
    EXPECT_EQ(std::count(journal.log.begin(), journal.log.end(), "settle"), 0);
    EXPECT_EQ(read("slot0.p"), 0);
    EXPECT_TRUE(core->owedGains().empty());
}

TEST_P(SwappedOnTrial, TheSameUnitHasItsGainsBackOrIsOfferedThemAndIsReadAgain)
{
    swap(0, 0, pause());
    ASSERT_TRUE(clock.runUntil([&] { return ended.has_value(); }, 60s));
    meet(left);
    clock.advance(5s);
    const auto entries = device()->parameters().entries();
    EXPECT_TRUE(std::all_of(entries.begin(), entries.end(), [](const auto &entry) { return entry.raw.has_value(); }));
    if (!journal.owed.empty()) {
        ASSERT_EQ(core->owedGains().count(id()), 1U);
        EXPECT_TRUE(ordered(orders::PayGains{id(), core->owedGains().at(id()).front().trial}));
    }
    EXPECT_TRUE(journal.owed.empty());
    EXPECT_EQ(read("slot0.p"), 0);
}

INSTANTIATE_TEST_SUITE_P(Pauses, SwappedOnTrial, testing::Values(150, 500, 1000, 1300, 1600, 2000, 2300, 3000, 5000));

} // namespace
} // namespace mb
