// SPDX-License-Identifier: GPL-3.0-or-later
// Units served in the engine's session: the link is lent, nothing turns unarmed, STOP ends all. Virtual time.
#include "app/engine/serviceroom.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "model/registry.h"
#include "storage/servicebook.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;

class Served : public testing::Test {
protected:
    Served()
    {
        test::needCoreApplication();
        auto opened = Database::open(folder.path().toStdString() + "/motorbench.db");
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        database = std::move(*opened);
        journal = std::make_unique<ServiceBook>(*database, clock, "bench 1", "anna");
        settings = std::make_unique<SettingsBook>(*database, clock, "anna");
        trials = std::make_unique<TrialBook>(*database, clock);
        core = std::make_unique<EngineCore>(clock, families(), false);
        core->setSettingsLog(settings.get());
        core->send(orders::OpenLink{*LinkAddress::parse("sim:can")});
        EXPECT_TRUE(clock.runUntil([this] { return device(7) && device(7)->liveness().heard; }, 10s));
        clock.advance(3s);
        room = std::make_unique<ServiceRoom>(
            *core, ServiceRoom::Surroundings{*journal, settings.get(), trials.get(), "bench 1"});
    }
    ~Served() override
    {
        room.reset();
        core.reset();
    }
    [[nodiscard]] Device *device(int address)
    {
        for (Device *one : core->session().devices()) {
            if (one->identity().address == address && one->family().key == "dmc60c")
                return one;
        }
        return nullptr;
    }
    [[nodiscard]] std::shared_ptr<const service::RecipeMatter> recipe(const QByteArray &text)
    {
        QFile file(folder.filePath(QStringLiteral("recipe.json")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        auto loaded = service::loadRecipe(file.fileName().toStdString(), families());
        EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().text());
        return loaded ? std::make_shared<const service::RecipeMatter>(std::move(*loaded)) : nullptr;
    }
    [[nodiscard]] bool anyMoves()
    {
        const auto all = core->session().devices();
        return std::any_of(all.begin(), all.end(), [](const Device *one) { return one->liveness().moving; });
    }

    QTemporaryDir folder;
    VirtualClock clock;
    std::unique_ptr<Database> database;
    std::unique_ptr<ServiceBook> journal;
    std::unique_ptr<SettingsBook> settings;
    std::unique_ptr<TrialBook> trials;
    std::unique_ptr<EngineCore> core;
    std::unique_ptr<ServiceRoom> room;

    const QByteArray plain = R"({"recipe":1,"name":"look","family":"dmc60c"})";
    const QByteArray moving = R"({"recipe":1,"name":"turn","family":"dmc60c","test":{"loop":"velocity","to":2000,
"limits":{"travel":20000,"speed":20000,"duty":0.5,"current":40},"accept":{"overshoot":9}}})";
};

TEST_F(Served, EveryUnitOfALinkAndTheEngineLeavesItAloneMeanwhile)
{
    ASSERT_TRUE(room->begin({recipe(plain), "sim:can", std::nullopt}));
    EXPECT_TRUE(room->view().running);
    test::Heard<> refused;
    core->send(orders::Identify{core->session().idOf(*device(7))}, refused.finished());
    ASSERT_TRUE(refused.has_value());
    EXPECT_FALSE(*refused) << "the link is lent";
    ASSERT_TRUE(clock.runUntil([this] { return !room->view().running; }, 10min));
    EXPECT_GE(room->view().counts.passed, 2);
    EXPECT_EQ(room->view().counts.ended(), static_cast<int>(room->view().rows.size()));
    EXPECT_GE(journal->list({})->size(), static_cast<std::size_t>(room->view().counts.passed));
    core->send(orders::Identify{core->session().idOf(*device(7))}, refused.finished());
    ASSERT_TRUE(clock.runUntil([&refused] { return refused && *refused; }, 10s)) << "it is given back";
}

TEST_F(Served, TheSameLinkAgainAndARetryOfNothingGivesItBack)
{
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(room->begin({recipe(plain), "sim:can", std::nullopt}));
        EXPECT_FALSE(room->begin({recipe(plain), "sim:can", std::nullopt})) << "it runs";
        EXPECT_EQ(core->lend("sim:can"), nullptr) << "it is lent";
        ASSERT_TRUE(clock.runUntil([this] { return !room->view().running; }, 10min));
        EXPECT_GE(room->view().counts.passed, 2);
        room->retry(12345);
        EXPECT_FALSE(room->view().running);
    }
    test::Heard<> free;
    core->send(orders::Identify{core->session().idOf(*device(7))}, free.finished());
    ASSERT_TRUE(clock.runUntil([&free] { return free.has_value(); }, 10s));
    EXPECT_TRUE(*free);
}

TEST_F(Served, NothingTurnsUnlessItIsArmed)
{
    ASSERT_TRUE(room->begin({recipe(moving), "sim:can", std::nullopt}));
    bool moved = false;
    ASSERT_TRUE(clock.runUntil(
        [&] {
            moved = moved || anyMoves();
            return !room->view().running;
        },
        20min));
    EXPECT_FALSE(moved);
    EXPECT_EQ(room->view().counts.passed, 0);
    const ServiceView view = room->view();
    EXPECT_TRUE(std::any_of(view.rows.begin(), view.rows.end(),
        [](const service::QueueRow &row) { return row.visit.cause.english().find("not armed") != std::string::npos; }));
}

TEST_F(Served, ArmedItSaysSoThreeSecondsBeforeAMotorTurns)
{
    ASSERT_TRUE(room->begin({recipe(moving), "sim:can", std::nullopt}));
    room->arm(true);
    EXPECT_TRUE(room->view().armed);
    ASSERT_TRUE(clock.runUntil([this] { return room->view().announces; }, 5min));
    const Instant told = clock.now();
    ASSERT_TRUE(clock.runUntil(
        [this] {
            room->renew();
            return anyMoves();
        },
        1min));
    EXPECT_GE(clock.now() - told, 3s);
    room->stop();
    core->stopAll(StopCause::User);
    EXPECT_FALSE(room->view().armed);
    ASSERT_TRUE(clock.runUntil([this] { return !room->view().running && !anyMoves(); }, 30s));
}

TEST_F(Served, WhoeverEndsItDisarms)
{
    ASSERT_TRUE(room->begin({recipe(moving), "sim:can", 0}));
    room->arm(true);
    room->finish();
    EXPECT_FALSE(room->view().armed);
    EXPECT_FALSE(room->begin({recipe(moving), "sim:nowhere", 0})) << "no such link";
}

} // namespace
} // namespace mb
