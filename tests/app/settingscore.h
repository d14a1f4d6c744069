// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "model/registry.h"
#include "model/unit.h"
#include "storage/settingsbook.h"
#include "support/coreapplication.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mb::test {

/// The engine's half with a history, on simulated units: DMC60C #7 is heard. Virtual time.
class SettingsCore : public testing::Test {
protected:
    SettingsCore()
    {
        needCoreApplication();
        auto opened = Database::open(folder.path().toStdString() + "/motorbench.db");
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        database = std::move(*opened);
        book = std::make_unique<SettingsBook>(*database, clock, "anna");
        noticed = core.noticed().add(
            [this](Severity, const std::string &, const Message &text) { notices.push_back(text.english()); });
        core.setSettingsLog(book.get());
        core.send(orders::OpenLink{*LinkAddress::parse("sim:can")});
        EXPECT_TRUE(
            clock.runUntil([this] { return device(7) && device(7)->liveness().heard; }, std::chrono::seconds(10)));
    }
    [[nodiscard]] Device *device(int address)
    {
        for (Device *one : core.session().devices()) {
            if (one->identity().address == address && one->family().key == "dmc60c")
                return one;
        }
        return nullptr;
    }
    [[nodiscard]] DeviceId id(int address = 7) { return core.session().idOf(*device(address)); }
    [[nodiscard]] std::vector<settings::ParameterSnapshot> snapshots(int address = 7)
    {
        return book->snapshots(unitKeyOf(*device(address))).value_or(std::vector<settings::ParameterSnapshot>{});
    }
    [[nodiscard]] std::vector<settings::SettingsChange> changes()
    {
        return book->changes(unitKeyOf(*device(7))).value_or(std::vector<settings::SettingsChange>{});
    }
    [[nodiscard]] ParameterChange change(std::string_view key, std::int64_t raw)
    {
        return {*findParameter(device(7)->family().parameters, key), raw};
    }
    [[nodiscard]] std::optional<std::int64_t> known(std::string_view key)
    {
        return device(7)->parameters().entry(change(key, 0).index).raw;
    }
    [[nodiscard]] Finished heard()
    {
        answered.reset();
        return answered.finished();
    }
    Result<void> ends()
    {
        EXPECT_TRUE(clock.runUntil([this] { return answered.has_value(); }, std::chrono::seconds(60)));
        return answered.value_or(fail(Fault::Timeout));
    }
    Result<void> write(std::vector<ParameterChange> writes)
    {
        core.send(orders::WriteParameters{id(), std::move(writes)}, heard());
        return ends();
    }

    QTemporaryDir folder;
    VirtualClock clock;
    std::unique_ptr<Database> database;
    std::unique_ptr<SettingsBook> book;
    EngineCore core{clock, families(), false};
    Subscription noticed;
    std::vector<std::string> notices;
    Heard<> answered;
};

} // namespace mb::test
