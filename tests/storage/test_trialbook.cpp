// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "files/runningprogram.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"
#include "support/fulldisk.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <chrono>
#include <cstdio>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace mb {
namespace {

class Notebooks : public testing::Test {
protected:
    Notebooks()
    {
        test::needCoreApplication();
        clock.advance(std::chrono::hours(1000));
    }
    [[nodiscard]] std::unique_ptr<Database> open() const
    {
        auto opened = Database::open(path);
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        return opened ? std::move(*opened) : nullptr;
    }
    [[nodiscard]] static tuning::Trial trial()
    {
        tuning::Trial trial;
        trial.device = "sim:can/dmc60c:5";
        trial.unit = "dmc60c 210334ABCDEF";
        trial.firmware = "1.23";
        trial.simulated = true;
        trial.slot = 1;
        trial.stimulus = *tuning::Stimulus::make(tuning::Profile::Step, 0.0, 1500.0, {}, 0.02);
        trial.repeat = 4;
        trial.envelope.travel = 4000.0;
        trial.gains = {{"slot1.i", std::nullopt}, {"slot1.p", 1.165}};
        trial.metrics.rise = 0.117;
        trial.metrics.overshoot = 0.0;
        trial.errors.rise = 0.002;
        trial.flags = {"saturated"};
        trial.reason = tuning::EndReason::Done;
        trial.stopped = true;
        trial.samples = 4711;
        trial.lost = 7;
        tuning::Trace trace;
        for (int i = 0; i < 500; ++i)
            trace.add(0.005 * i, 0.1 * i);
        trial.signals = {{"velocity", "counts/s", trace}};
        return trial;
    }
    std::int64_t keep(TrialBook &book, const tuning::Trial &done)
    {
        const auto number = test::run(clock, book.begin(done));
        EXPECT_TRUE(number) << (number ? "" : number.error().text());
        const auto completed = test::run(clock, book.complete(number.value_or(0), done));
        EXPECT_TRUE(completed) << (completed ? "" : completed.error().text());
        return number.value_or(0);
    }

    QTemporaryDir folder;
    std::string path = folder.path().toStdString() + "/below/motorbench.db";
    VirtualClock clock;
};

TEST_F(Notebooks, ATrialComesBackAsItWasKept)
{
    const tuning::Trial kept = trial();
    {
        const auto database = open();
        TrialBook book(*database, clock);
        EXPECT_EQ(keep(book, kept), 1);
    }
    const auto database = open();
    TrialBook book(*database, clock);
    const auto found = book.find(1);
    ASSERT_TRUE(found);
    const tuning::Trial &back = found->trial;
    EXPECT_DOUBLE_EQ(found->time, 3'600'000.0);
    EXPECT_EQ(back.device, kept.device);
    EXPECT_EQ(back.unit, kept.unit);
    EXPECT_EQ(back.firmware, kept.firmware);
    EXPECT_EQ(back.stimulus, kept.stimulus);
    EXPECT_EQ(back.repeat, kept.repeat);
    EXPECT_EQ(back.envelope, kept.envelope);
    EXPECT_EQ(back.gains, kept.gains);
    EXPECT_EQ(back.metrics, kept.metrics);
    EXPECT_EQ(back.errors, kept.errors);
    EXPECT_EQ(back.flags, kept.flags);
    EXPECT_EQ(back.reason, kept.reason);
    EXPECT_EQ(back.samples, kept.samples);
    EXPECT_EQ(back.lost, kept.lost);
    EXPECT_TRUE(back.stopped);
    EXPECT_TRUE(back.simulated);
    const auto signals = book.signals(1);
    ASSERT_TRUE(signals);
    EXPECT_EQ(*signals, kept.signals);
}

TEST_F(Notebooks, TwoRepeatsHaveAnErrorAndOneHasNone)
{
    const auto database = open();
    TrialBook book(*database, clock);
    tuning::Trial kept = trial();
    kept.repeat = 2;
    EXPECT_EQ(book.find(keep(book, kept))->trial.errors, kept.errors);
    kept.repeat = 1;
    EXPECT_EQ(book.find(keep(book, kept))->trial.errors, tuning::Metrics());
}

TEST_F(Notebooks, ATrialThatNobodySawEndIsThereAsAborted)
{
    {
        const auto database = open();
        TrialBook book(*database, clock);
        ASSERT_TRUE(test::run(clock, book.begin(trial())));
    }
    const auto database = open();
    const auto rows = TrialBook(*database, clock).list();
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 1U);
    EXPECT_TRUE(rows->front().trial.has("aborted"));
    EXPECT_TRUE(rows->front().trial.reason == tuning::EndReason::None);
    EXPECT_FALSE(rows->front().trial.stopped);
    EXPECT_EQ(rows->front().trial.stimulus, trial().stimulus);
}

TEST_F(Notebooks, WhatIsOwedOutlivesTheProgramUntilItIsSettled)
{
    const std::vector<tuning::OwedValue> values{{"slot0.i", -5}, {"slot0.p", 76349}};
    {
        const auto database = open();
        TrialBook book(*database, clock);
        const auto number = test::run(clock, book.begin(trial()));
        ASSERT_TRUE(test::run(clock, book.owe(*number, "dmc60c A", values)));
    }
    const auto database = open();
    TrialBook book(*database, clock);
    const auto owedTo = [&](const char *unit) { return test::run(clock, book.owedTo(unit)); };
    const auto debts = owedTo("dmc60c A");
    ASSERT_TRUE(debts);
    ASSERT_EQ(debts->size(), 1U);
    EXPECT_EQ(debts->front().values, values);
    EXPECT_TRUE(owedTo("dmc60c B")->empty());
    ASSERT_TRUE(test::run(clock, book.settle(debts->front().trial)));
    EXPECT_TRUE(owedTo("dmc60c A")->empty());
}

TEST_F(Notebooks, ATrialThatAnotherProgramMakesIsUnderWayUntilItIsCompleteOrThatProgramIsGone)
{
    int gate[2];
    ASSERT_EQ(::pipe(gate), 0);
    const pid_t other = ::fork();
    if (other == 0) { // it lives until the gate is closed
        ::close(gate[1]);
        char byte = 0;
        (void)!::read(gate[0], &byte, 1);
        ::_exit(0);
    }
    ::close(gate[0]);
    const auto database = open();
    TrialBook book(*database, clock);
    const auto number = test::run(clock, book.begin(trial()));
    ASSERT_TRUE(test::run(clock, book.owe(*number, "dmc60c A", {{"slot1.p", 5, 7}})));
    const auto isUnderWay = [&] { return test::run(clock, book.owedTo("dmc60c A"))->front().isUnderWay; };
    EXPECT_FALSE(isUnderWay()) << "it is ours";
    ASSERT_TRUE(
        database->run("UPDATE trial SET program = ?", {QString::fromStdString(programOf(std::to_string(other)))}));
    EXPECT_TRUE(isUnderWay());
    ASSERT_TRUE(test::run(clock, book.complete(*number, trial())));
    EXPECT_FALSE(isUnderWay()) << "it could not put it back";
    ASSERT_TRUE(
        database->run("UPDATE trial SET program = ?", {QString::fromStdString(programOf(std::to_string(other)))}));
    book.abandon(*number);
    EXPECT_FALSE(isUnderWay()) << "it was cut";
    ASSERT_TRUE(
        database->run("UPDATE trial SET program = ?", {QString::fromStdString(programOf(std::to_string(other)))}));
    ::close(gate[1]);
    siginfo_t how{};
    ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(other), &how, WEXITED | WNOWAIT), 0);
    EXPECT_FALSE(isUnderWay()) << "it was killed, and nobody has asked after it";
    ::waitpid(other, nullptr, 0);
    EXPECT_FALSE(isUnderWay());
}

TEST_F(Notebooks, AUnitWithATagHasItsTrialsAndDebtsWhereverItIsConnected)
{
    const auto database = open();
    TrialBook book(*database, clock);
    SettingsBook settings(*database, clock, "anna");
    const std::string left = "place usb-1.2 supermodified:4";
    const std::string right = "place usb-1.3 supermodified:4";
    ASSERT_TRUE(settings.setTag(left, "left arm"));
    tuning::Trial done = trial();
    done.unit = left;
    const std::int64_t number = keep(book, done);
    ASSERT_TRUE(test::run(clock, book.owe(number, left, {{"gain.p", 4000}})));
    EXPECT_TRUE(book.listOf(right)->empty()) << "another unit stands there";
    EXPECT_TRUE(test::run(clock, book.owedTo(right))->empty());
    ASSERT_TRUE(settings.setTag(right, "left arm")); // it was plugged in there
    EXPECT_EQ(book.listOf(right)->size(), 1U);
    EXPECT_EQ(test::run(clock, book.owedTo(right))->size(), 1U);
    ASSERT_TRUE(test::run(clock, book.release(right, {"gain.p"})));
    EXPECT_TRUE(test::run(clock, book.owedTo(left))->empty());
}

TEST_F(Notebooks, WhatIsOwedToAUnitGoesWithItToItsNewName)
{
    const auto database = open();
    TrialBook book(*database, clock);
    SettingsBook settings(*database, clock, "anna");
    const std::string place = "place usb-1.2 supermodified:4";
    ASSERT_TRUE(test::run(clock, book.owe(keep(book, trial()), place, {{"gain.p", 4000}})));
    const auto isOwed = [&](const std::string &unit) { return !test::run(clock, book.owedTo(unit))->empty(); };
    for (const char *const name : {"left arm", "right arm", ""}) {
        ASSERT_TRUE(settings.setTag(place, name));
        EXPECT_TRUE(isOwed(place)) << name;
    }
    const std::string elsewhere = "place usb-1.3 supermodified:4";
    ASSERT_TRUE(settings.setTag(elsewhere, "left arm"));
    ASSERT_TRUE(settings.setTag(place, "left arm")); // another unit stood here when it was owed
    EXPECT_FALSE(isOwed(elsewhere));
}

TEST_F(Notebooks, WhatIsOwedToOneNamedUnitIsNotOfferedToAnotherThatIsPutInItsPlace)
{
    const auto database = open();
    TrialBook book(*database, clock);
    SettingsBook settings(*database, clock, "anna");
    const std::string place = "place usb-1.2 supermodified:4";
    const std::string elsewhere = "place usb-1.3 supermodified:4";
    const auto isOwed = [&](const std::string &unit) { return !test::run(clock, book.owedTo(unit))->empty(); };
    ASSERT_TRUE(settings.setTag(place, "A"));
    ASSERT_TRUE(settings.setTag(elsewhere, "B"));
    ASSERT_TRUE(test::run(clock, book.owe(keep(book, trial()), place, {{"gain.p", 4000}})));
    ASSERT_TRUE(settings.setTag(place, "B")); // B is known from elsewhere, and was plugged in here
    EXPECT_FALSE(isOwed(place));
    EXPECT_FALSE(isOwed(elsewhere));
    ASSERT_TRUE(settings.setTag(elsewhere, "A"));
    EXPECT_TRUE(isOwed(elsewhere)) << "A waits for its own";
}

TEST_F(Notebooks, AUnitOfAnotherFamilyWithTheSameNameDoesNotKeepADebtFromItsUnit)
{
    const auto database = open();
    TrialBook book(*database, clock);
    SettingsBook settings(*database, clock, "anna");
    const std::string place = "place usb-1.2 supermodified:4";
    ASSERT_TRUE(settings.setTag("place can-1 abstractdc:3", "left arm"));
    ASSERT_TRUE(test::run(clock, book.owe(keep(book, trial()), place, {{"gain.p", 4000}})));
    ASSERT_TRUE(settings.setTag(place, "left arm"));
    EXPECT_FALSE(test::run(clock, book.owedTo(place))->empty());
}

/// P was 5; trial 1 tries 10 and is killed; trial 2 finds 10, tries 20.
TEST_F(Notebooks, OfOneKeyTheFirstValueIsOwedAndALaterTrialThatPutsBackWhatItFoundDoesNotSettleIt)
{
    const auto database = open();
    TrialBook book(*database, clock);
    ASSERT_TRUE(test::run(clock, book.owe(1, "unit", {{"slot0.p", 5, 10}})));
    ASSERT_TRUE(test::run(clock, book.owe(2, "unit", {{"slot0.p", 10, 20}, {"slot0.i", 1, 2}})));
    const auto both = test::run(clock, book.owedTo("unit"));
    ASSERT_EQ(both->size(), 2U);
    EXPECT_EQ(both->front().trial, 1);
    EXPECT_EQ(both->front().values.front().raw, 5);
    EXPECT_EQ(both->back().values.size(), 1U) << "only what nobody owed before";
    ASSERT_TRUE(test::run(clock, book.settle(2)));
    EXPECT_EQ(test::run(clock, book.owedTo("unit"))->front().values.front().raw, 5);
}

TEST_F(Notebooks, WhatWasPutBackIsOwedAsALaterTrialFindsItUnlessTheUnitHasLostItAgain)
{
    const auto database = open();
    TrialBook book(*database, clock);
    const auto owed = [&] { return test::run(clock, book.owedTo("unit")).value_or(std::vector<tuning::OwedGains>()); };
    ASSERT_TRUE(test::run(clock, book.owe(1, "unit", {{"slot0.p", 5, 10}})));
    ASSERT_TRUE(test::run(clock, book.markPutBack(1)));
    ASSERT_EQ(owed().size(), 1U);
    EXPECT_TRUE(owed().front().isPutBack);
    ASSERT_TRUE(test::run(clock, book.owe(2, "unit", {{"slot0.p", 10, 20}}))) << "its flash had what was tried";
    EXPECT_EQ(owed().front().values.front().raw, 5);
    EXPECT_FALSE(owed().front().isPutBack);
    ASSERT_TRUE(test::run(clock, book.markPutBack(1)));
    ASSERT_TRUE(test::run(clock, book.owe(3, "unit", {{"slot0.p", 7, 30}}))) << "somebody has written 7";
    EXPECT_EQ(owed().front().trial, 3);
    EXPECT_EQ(owed().front().values.front().raw, 7);
}

TEST_F(Notebooks, KeysThatHaveOtherValuesOnPurposeAreOwedByNoTrial)
{
    const auto database = open();
    TrialBook book(*database, clock);
    ASSERT_TRUE(test::run(clock, book.owe(1, "unit", {{"slot0.p", 5, 10}, {"slot1.p", 6, 10}})));
    ASSERT_TRUE(test::run(clock, book.owe(2, "other unit", {{"slot0.p", 5, 10}})));
    ASSERT_TRUE(test::run(clock, book.release("unit", {"slot0.p"})));
    const auto left = test::run(clock, book.owedTo("unit"));
    ASSERT_EQ(left->size(), 1U);
    EXPECT_EQ(left->front().values, (std::vector<tuning::OwedValue>{{"slot1.p", 6, 10}}));
    EXPECT_EQ(test::run(clock, book.owedTo("other unit"))->size(), 1U);
}

TEST_F(Notebooks, StarsNotesAndRemovalsConcernOneTrialAndANumberIsNeverUsedAgain)
{
    const auto database = open();
    TrialBook book(*database, clock);
    for (int i = 0; i < 3; ++i)
        keep(book, trial());
    ASSERT_TRUE(book.setStar(2, true));
    ASSERT_TRUE(book.setNote(2, "with \"quotes\", commas; and 'DROP TABLE trial;--"));
    ASSERT_TRUE(book.remove(3));
    EXPECT_EQ(keep(book, trial()), 4);
    const auto rows = book.list();
    ASSERT_EQ(rows->size(), 3U);
    EXPECT_TRUE((*rows)[1].star);
    EXPECT_FALSE((*rows)[0].star);
    EXPECT_EQ((*rows)[1].note, "with \"quotes\", commas; and 'DROP TABLE trial;--");
    EXPECT_TRUE(book.signals(3)->empty());
    for (const auto &refused : {book.setStar(3, true), book.setNote(99, "x"), book.remove(3)}) {
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    }
    EXPECT_FALSE(book.find(3));
}

TEST_F(Notebooks, TenThousandTrialsAreListedInAFifthOfASecond)
{
    const auto database = open();
    TrialBook book(*database, clock);
    ASSERT_TRUE(database->transact([&]() -> Result<void> {
        for (int i = 0; i < 10'000; ++i) {
            auto added = database->run(
                "INSERT INTO trial (time, device, unit, firmware, simulated, mode, axis, slot, stimulus, envelope, "
                "gains, metrics, "
                "flags, reason, detail, stopped, samples, lost) VALUES (?, 'sim:can/dmc60c:5', 'u', '1.23', 1, "
                "'velocity', 1, 0, "
                "'{\"profile\":\"step\",\"from\":0,\"to\":1500,\"time\":5,\"repeat\":1}', '{\"travel\":4000}', "
                "'{\"slot0.p\":1.165,\"slot0.i\":0.00346,\"slot0.d\":0,\"slot0.f\":0}', "
                "'{\"rise\":0.117,\"settle\":0.32,\"overshoot\":0.044,\"sse\":0.0001,\"iae\":0.071,\"itae\":0.01}', "
                "'[\"saturated\"]', 'done', '', 1, 4711, 0)",
                {i});
            if (!added)
                return added;
        }
        return {};
    }));
    const auto before = std::chrono::steady_clock::now();
    const auto rows = book.list();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->size(), 10'000U);
    EXPECT_DOUBLE_EQ(rows->back().trial.metrics.rise.value_or(0.0), 0.117);
    std::printf("10000 trials listed in %.3f s (to reach: 0.2 s)\n", took.count());
}

TEST_F(Notebooks, ADamagedFileIsPutAsideWithAWordAndNeverDeleted)
{
    const QByteArray rubbish(8192, 'x');
    for (const char *aside : {".damaged", ".damaged-2"}) {
        QDir().mkpath(folder.path() + "/below");
        QFile file(QString::fromStdString(path));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(rubbish);
        file.close();
        const auto database = open();
        ASSERT_TRUE(database);
        EXPECT_NE(database->remark().find(path + aside), std::string::npos) << database->remark();
        TrialBook book(*database, clock);
        EXPECT_EQ(keep(book, trial()), 1);
        QFile kept(QString::fromStdString(path + aside));
        ASSERT_TRUE(kept.open(QIODevice::ReadOnly)) << aside;
        EXPECT_EQ(kept.readAll(), rubbish);
    }
}

TEST_F(Notebooks, ADamagedPageThatOpeningDoesNotReadIsToldWithWhatMayBeDone)
{
    constexpr qint64 page = 4096;
    {
        const auto database = open();
        TrialBook book(*database, clock);
        for (int i = 0; i < 40; ++i)
            keep(book, trial());
    } // all is in the file itself, not in its log
    QFile file(QString::fromStdString(path));
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    const qint64 pages = file.size() / page;
    for (qint64 at = pages / 3; at < pages; ++at) {
        ASSERT_TRUE(file.seek(at * page));
        file.write(QByteArray(page, '\xEE'));
    }
    file.close();
    const auto database = open();
    ASSERT_TRUE(database);
    EXPECT_EQ(database->remark(), "");
    TrialBook book(*database, clock);
    const auto failed = book.list();
    ASSERT_FALSE(failed);
    EXPECT_NE(failed.error().detail.english().find(path + ": "), std::string::npos) << failed.error().text();
    EXPECT_EQ(failed.error().remedy.english(),
        "'sqlite3 " + path + " .recover' tells what it still holds; where it is moved away, a new one is begun");
}

TEST_F(Notebooks, ADiskWithoutRoomIsNamed)
{
    const auto database = open();
    TrialBook book(*database, clock);
    keep(book, trial());
    ASSERT_TRUE(database->run("PRAGMA max_page_count = 1")); // SQLite takes what the file has already
    tuning::Trial large = trial();
    large.device = std::string(100'000, 'x');
    const auto failed = test::run(clock, book.begin(large));
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().remedy.english(), "make room on its disk") << failed.error().text();
}

TEST_F(Notebooks, AnotherProgramThatKeepsTheFileIsNamed)
{
    const auto one = open();
    const auto two = open();
    ASSERT_TRUE(one->run("BEGIN EXCLUSIVE"));
    ASSERT_TRUE(two->run("PRAGMA busy_timeout = 0"));
    const auto failed = two->run("DELETE FROM trial");
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().remedy.english(), "another program holds it: try again when that has ended");
}

TEST_F(Notebooks, AFileOfANewerVersionIsLeftAloneAndSaidSo)
{
    ASSERT_TRUE(open()->run("PRAGMA user_version = 1000"));
    const auto refused = Database::open(path);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("newer version"), std::string::npos) << refused.error().detail;
    EXPECT_FALSE(QFile::exists(QString::fromStdString(path + ".damaged")));
}

TEST_F(Notebooks, TwoProgramsWriteAtOnceAndNeitherLosesATrial)
{
    const auto one = open();
    const auto two = open();
    TrialBook first(*one, clock);
    TrialBook second(*two, clock);
    for (int i = 0; i < 20; ++i) {
        keep(first, trial());
        keep(second, trial());
    }
    EXPECT_EQ(first.list()->size(), 40U);
    EXPECT_EQ(second.list()->size(), 40U);
}

TEST_F(Notebooks, AFullDiskFailsTheTrialButKeepsTheOthers)
{
    const auto database = open();
    TrialBook book(*database, clock);
    keep(book, trial());
    tuning::Trial large = trial();
    std::uint64_t noise = 1;
    for (int i = 0; i < 200'000; ++i) {
        noise = noise * 6364136223846793005ULL + 1442695040888963407ULL;
        large.signals.front().trace.add(i, static_cast<double>(noise >> 11U));
    }
    {
        const auto number = test::run(clock, book.begin(large));
        ASSERT_TRUE(number);
        const test::FullDisk full(300'000);
        const auto failed = test::run(clock, book.complete(*number, large));
        ASSERT_FALSE(failed);
        EXPECT_EQ(failed.error().fault, Fault::NotKept);
        EXPECT_EQ(failed.error().remedy.english(), "look whether its disk is there, has room and is in order");
    }
    EXPECT_EQ(book.find(1)->trial.samples, 4711U);
    EXPECT_EQ(keep(book, trial()), 3);
}

TEST_F(Notebooks, AFolderThatCannotBeMadeIsSaidSo)
{
    const auto refused = Database::open("/proc/motorbench/motorbench.db");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("/proc/motorbench"), std::string::npos);
}

} // namespace
} // namespace mb
