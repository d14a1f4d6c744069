// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "model/registry.h"
#include "storage/servicebook.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"
#include "support/sourcetree.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>

namespace mb::test {

/// The bench of the demo, whose units the engine serves in virtual time.
class Served : public testing::Test {
protected:
    Served()
    {
        needCoreApplication();
        auto opened = Database::open(folder.path().toStdString() + "/motorbench.db");
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        database = std::move(*opened);
        journal = std::make_unique<ServiceBook>(*database, clock, "bench 1", "anna");
        settings = std::make_unique<SettingsBook>(*database, clock, "anna");
        trials = std::make_unique<TrialBook>(*database, clock);
        core = std::make_unique<EngineCore>(clock, families(), false);
        core->setSettingsLog(settings.get());
        core->send(orders::OpenLink{*LinkAddress::parse("sim:can")});
        EXPECT_TRUE(
            clock.runUntil([this] { return device(7) && device(7)->liveness().heard; }, std::chrono::seconds(10)));
        clock.advance(std::chrono::seconds(3));
        core->service().setBooks({journal.get(), settings.get(), trials.get()}, "bench 1");
    }
    /// What came of the order, which is answered at once.
    [[nodiscard]] Result<void> serve(orders::ServeUnits order)
    {
        Heard<> begun;
        core->send(std::move(order), begun.finished());
        EXPECT_TRUE(begun.has_value());
        return begun ? *begun : fail(Fault::Timeout);
    }
    [[nodiscard]] ServiceView view() const { return core->service().view(); }
    /// An order to a unit of the link is refused.
    [[nodiscard]] bool isLent()
    {
        Heard<> named;
        core->send(orders::Identify{core->session().idOf(*device(7))}, named.finished());
        return named && !*named;
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

    /// A motor is driven by a self-test now.
    [[nodiscard]] bool isDriven()
    {
        const auto all = core->session().devices();
        return std::any_of(
            all.begin(), all.end(), [this](Device *one) { return core->session().stream(*one).isRunning(); });
    }

    QTemporaryDir folder;
    VirtualClock clock;
    std::unique_ptr<Database> database;
    std::unique_ptr<ServiceBook> journal;
    std::unique_ptr<SettingsBook> settings;
    std::unique_ptr<TrialBook> trials;
    std::unique_ptr<EngineCore> core;

    /// The row whose self-test waits for arming.
    [[nodiscard]] service::QueueRow waiting() const
    {
        for (const service::QueueRow &row : view().rows) {
            if (row.state == service::RowState::Running)
                return row;
        }
        return {};
    }
    /// With a window that watches over the motors.
    [[nodiscard]] bool renewedUntil(const std::function<bool()> &is)
    {
        return clock.runUntil(
            [&] {
                core->send(orders::RenewService{});
                return is();
            },
            std::chrono::minutes(5));
    }

    const QByteArray plain = R"({"recipe":1,"name":"look","family":"dmc60c"})";
    const QByteArray moving = R"({"recipe":1,"name":"turn","family":"dmc60c","test":{"loop":"velocity","to":2000,
"limits":{"travel":20000,"speed":20000,"duty":0.5,"current":40},"accept":{"overshoot":9}}})";
    const QByteArray pushing = R"({"recipe":1,"name":"push","family":"dmc60c","test":{"loop":"velocity","to":2000,
"limits":{"travel":200000,"speed":200000,"duty":0.5,"current":40},"accept":{"friction":[0,9]}}})";
    const QByteArray failing = R"({"recipe":1,"name":"strict","family":"dmc60c","test":{"loop":"velocity","to":2000,
"limits":{"travel":20000,"speed":20000,"duty":0.5,"current":40},"accept":{"settle":0.001}}})";
};

} // namespace mb::test
