// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/snapshots.h"
#include "settings/writing.h"
#include "storage/settingsbook.h"
#include "support/coreapplication.h"
#include "support/simulatedsession.h"

#include <QTemporaryDir>

namespace mb::test {

/// One simulated device, and the book of settings in a file of its own.
class SettingsBench : public testing::Test {
protected:
    explicit SettingsBench(const char *link = "sim:can")
        : bench(link)
    {
        open();
        bench.scan();
    }
    /// The program ends and begins again.
    void open()
    {
        test::needCoreApplication();
        book.reset();
        database.reset();
        auto opened = Database::open(folder.path().toStdString() + "/motorbench.db");
        ASSERT_TRUE(opened) << opened.error().detail;
        database = std::move(*opened);
        book = std::make_unique<SettingsBook>(*database, bench.clock, "anna");
    }
    template <class T> Result<T> run(Task<T> task) { return test::run(bench.clock, std::move(task)); }

    [[nodiscard]] ParameterChange change(const Device &device, std::string_view key, std::int64_t raw) const
    {
        return {bench.index(device, key), raw};
    }
    Result<std::vector<TransferOutcome>> write(Device &device, std::vector<ParameterChange> changes)
    {
        return run(settings::writeKept(device, std::move(changes), {settings::Origin::Window}, book.get(), progress));
    }
    Result<settings::ParameterSnapshot> snapshot(Device &device, const std::string &name = {})
    {
        return run(settings::takeSnapshot(device, settings::Occasion::Hand, name, *book, progress));
    }
    std::optional<std::int64_t> reads(Device &device, std::string_view key)
    {
        const auto raw = run(device.read(bench.index(device, key)));
        return raw ? std::optional(*raw) : std::nullopt;
    }

    SimulatedSession bench;
    NoProgress progress;
    QTemporaryDir folder;
    std::unique_ptr<Database> database;
    std::unique_ptr<SettingsBook> book;
};

} // namespace mb::test
