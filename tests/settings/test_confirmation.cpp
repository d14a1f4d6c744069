// SPDX-License-Identifier: GPL-3.0-or-later
// Values that can cut a unit off, or make a motor livelier, go back by themselves unless somebody keeps them.
#include "model/family.h"
#include "model/registry.h"
#include "model/setpointstream.h"
#include "model/unit.h"
#include "settings/confirmation.h"
#include "settings/history.h"
#include "settingsbench.h"

#include <array>

namespace mb {
namespace {

using namespace std::chrono_literals;
using settings::Confirmation;
using settings::Origin;
using settings::Proof;
using settings::Purpose;
using settings::SettingsChange;
using State = Confirmation::State;

class Confirmations : public test::SettingsBench {
protected:
    explicit Confirmations(const char *link = "sim:can")
        : test::SettingsBench(link)
    {
    }
    /// Writes it as the window does.
    SettingsChange provisional(Device &device, std::vector<ParameterChange> changes)
    {
        EXPECT_TRUE(run(settings::writeKept(device, std::move(changes), {Origin::Window}, book.get(), progress)));
        return all(device).back();
    }
    /// As the engine does, ten times a second; how often it said that it is due.
    int pass(Confirmation &confirmation, const Device &device, Duration time)
    {
        int due = 0;
        for (const Instant end = bench.clock.now() + time; bench.clock.now() < end; bench.clock.advance(100ms))
            due += confirmation.state() != State::Due && confirmation.look(device, bench.clock.now()) == State::Due ? 1
                                                                                                                    : 0;
        return due;
    }
    [[nodiscard]] Confirmation confirmationOf(const Device &device, const SettingsChange &change)
    {
        return Confirmation(settings::toConfirm(device.family(), change.values));
    }
    [[nodiscard]] std::vector<SettingsChange> all(const Device &device)
    {
        return book->changes(unitKeyOf(device)).value_or(std::vector<SettingsChange>{});
    }
    [[nodiscard]] std::vector<std::string> keysToConfirm(
        Device &device, std::vector<std::tuple<std::string, std::optional<std::int64_t>, std::int64_t>> values)
    {
        std::vector<settings::ValueChange> list;
        for (auto &[key, before, after] : values)
            list.push_back({key, before, after, Proof::Equal});
        std::vector<std::string> keys;
        for (const auto &value : settings::toConfirm(device.family(), list))
            keys.push_back(value.key);
        return keys;
    }
    static constexpr std::int64_t amperes = 65536;
};

TEST_F(Confirmations, AreForWhatBecameLivelierNotForWhatBecameSafer)
{
    Device &five = *bench.device(5);
    const std::vector<std::string> wanted{"current_limit.peak", "current_limit.enabled",
        "limit.forward.switch.disabled", "slot0.max_forward", "current_limit.i_zone"};
    EXPECT_EQ(keysToConfirm(five,
                  {{"current_limit.peak", 40, 60}, {"current_limit.continuous", 40, 30},
                      {"current_limit.enabled", 1, 0}, {"limit.forward.switch.disabled", 0, 1},
                      {"limit.reverse.switch.disabled", 1, 0}, {"slot0.max_forward", 100, 200}, {"slot0.p", 1, 9},
                      {"current_limit.i_zone", 21809288, 0}, // 0 is no limit
                      {"current_limit.peak_duration", std::nullopt, 900}}),
        wanted);
    EXPECT_EQ(provisional(five, {change(five, "slot0.p", 7 * amperes)}).purpose, Purpose::Write);
}

TEST_F(Confirmations, AreAskedByWhatTheUnitHasNotByWhatItWasThoughtToHave)
{
    Device &five = *bench.device(5);
    const ParameterIndex peak = bench.index(five, "current_limit.peak");
    ASSERT_TRUE(write(five, {{peak, 20 * amperes}}));
    five.parameters().setRead(peak, 60 * amperes); // another program has lowered it since
    EXPECT_EQ(provisional(five, {{peak, 50 * amperes}}).purpose, Purpose::Provisional);
    EXPECT_EQ(all(five).back().values.front().before, 20 * amperes);
    ASSERT_TRUE(write(five, {{peak, 20 * amperes}}));
    five.parameters().setFailed(peak); // its last reading was lost
    EXPECT_EQ(provisional(five, {{peak, 50 * amperes}}).purpose, Purpose::Provisional);
}

TEST_F(Confirmations, AValueThatNobodyKeepsGoesBackAfterThirtySeconds)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "current_limit.peak");
    ASSERT_TRUE(old);
    const SettingsChange change
        = provisional(five, {this->change(five, "current_limit.peak", *old * 2), this->change(five, "slot0.p", 65536)});
    Confirmation confirmation = confirmationOf(five, change);
    EXPECT_EQ(confirmation.look(five, bench.clock.now()), State::Counting);
    EXPECT_EQ(confirmation.left(bench.clock.now()), 30s);
    EXPECT_EQ(pass(confirmation, five, 29'900ms), 0);
    EXPECT_EQ(pass(confirmation, five, 300ms), 1);
    EXPECT_EQ(confirmation.left(bench.clock.now()), 0s);
    ASSERT_TRUE(run(settings::putBack(five, change.number, *book, progress)));
    EXPECT_EQ(reads(five, "current_limit.peak"), old);
    EXPECT_EQ(reads(five, "slot0.p"), 65536) << "it makes no motor livelier than before by itself: it stays";
    EXPECT_EQ(all(five).back().purpose, Purpose::Revert);
    EXPECT_EQ(all(five).back().of, change.number);
    const auto left = run(settings::findUnconfirmed(five, *book));
    ASSERT_TRUE(left);
    EXPECT_TRUE(left->empty());
}

TEST_F(Confirmations, AKeptValueStaysAndCanStillBeUndone)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "current_limit.peak");
    const SettingsChange change = provisional(five, {this->change(five, "current_limit.peak", *old * 2)});
    ASSERT_TRUE(run(settings::keepChange(five, change.number, *book)));
    EXPECT_TRUE(run(settings::findUnconfirmed(five, *book))->empty());
    EXPECT_EQ(reads(five, "current_limit.peak"), *old * 2);
    ASSERT_TRUE(run(settings::undo(five, Origin::Window, *book, progress)));
    EXPECT_EQ(reads(five, "current_limit.peak"), old);
}

TEST_F(Confirmations, WhatAProgramThatIsGoneHasLeftIsFound)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "current_limit.peak");
    const SettingsChange first = provisional(five, {change(five, "current_limit.peak", *old * 2)});
    open();
    auto left = run(settings::findUnconfirmed(five, *book));
    ASSERT_TRUE(left);
    ASSERT_EQ(left->size(), 1U);
    EXPECT_EQ(left->front().number, first.number);
    ASSERT_TRUE(run(settings::putBack(five, left->front().number, *book, progress)));
    EXPECT_EQ(reads(five, "current_limit.peak"), old);
}

TEST_F(Confirmations, WhatWasUndoneOrReplacedIsNobodysQuestion)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "current_limit.peak");
    provisional(five, {change(five, "current_limit.peak", *old * 2)});
    ASSERT_TRUE(run(settings::undo(five, Origin::Window, *book, progress)));
    EXPECT_TRUE(run(settings::findUnconfirmed(five, *book))->empty());
    provisional(five, {change(five, "current_limit.peak", *old * 2)});
    ASSERT_TRUE(write(five, {change(five, "current_limit.peak", *old / 2)}));
    EXPECT_TRUE(run(settings::findUnconfirmed(five, *book))->empty());
}

TEST_F(Confirmations, WhatIsWrittenOverAnOpenValueGoesBackToWhatWasKeptLast)
{
    struct Row {
        const char *of;
        double second; ///< of what was kept
        bool isOpen;
    };
    for (const Row &row : {Row{"wider again", 3.0, true}, Row{"narrower, but not enough", 1.5, true},
             Row{"as it was kept", 1.0, false}, Row{"narrower than that", 0.5, false}}) {
        SCOPED_TRACE(row.of);
        Device &five = *bench.device(5);
        const std::int64_t old = 20 * amperes;
        ASSERT_TRUE(write(five, {change(five, "current_limit.peak", old)}));
        const auto before = run(settings::findUnconfirmed(five, *book));
        for (const SettingsChange &open : *before)
            ASSERT_TRUE(run(settings::keepChange(five, open.number, *book)));
        provisional(five, {change(five, "current_limit.peak", old * 2), change(five, "slot0.max_forward", 100)});
        const auto second = static_cast<std::int64_t>(static_cast<double>(old) * row.second);
        const ParameterChange wanted = change(five, "current_limit.peak", second);
        provisional(five, {wanted});
        const auto left = *run(settings::findUnconfirmed(five, *book));
        ASSERT_EQ(left.size(), row.isOpen ? 1U : 0U);
        if (!row.isOpen)
            continue;
        const std::vector<settings::ValueChange> open{{"current_limit.peak", old, second, Proof::Equal}};
        EXPECT_EQ(left.front().values, open);
        ASSERT_TRUE(run(settings::putBack(five, left.front().number, *book, progress)));
        EXPECT_EQ(reads(five, "current_limit.peak"), old);
        EXPECT_TRUE(run(settings::findUnconfirmed(five, *book))->empty());
    }
}

TEST_F(Confirmations, WhatTheConsoleSetsIsDecided)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "current_limit.peak");
    const SettingsChange first = provisional(five, {change(five, "current_limit.peak", *old * 2)});
    ASSERT_TRUE(run(settings::writeKept(
        five, {change(five, "current_limit.peak", *old * 3)}, {Origin::Console}, book.get(), progress)));
    EXPECT_TRUE(run(settings::findUnconfirmed(five, *book))->empty());
    EXPECT_FALSE(run(settings::putBack(five, first.number, *book, progress)).value_or(true));
    EXPECT_EQ(reads(five, "current_limit.peak"), *old * 3);
}

TEST_F(Confirmations, AnUndoThatWidensALimitIsAsked)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "current_limit.peak");
    ASSERT_TRUE(write(five, {change(five, "current_limit.peak", *old / 2)}));
    ASSERT_TRUE(run(settings::undo(five, Origin::Window, *book, progress)));
    const auto left = *run(settings::findUnconfirmed(five, *book));
    ASSERT_EQ(left.size(), 1U);
    ASSERT_TRUE(run(settings::putBack(five, left.front().number, *book, progress)));
    EXPECT_EQ(reads(five, "current_limit.peak"), *old / 2);
    EXPECT_TRUE(run(settings::findUnconfirmed(five, *book))->empty());
}

TEST_F(Confirmations, NothingIsWrittenWhileTheMotorTurns)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "current_limit.peak");
    const SettingsChange change = provisional(five, {this->change(five, "current_limit.peak", *old * 2)});
    Confirmation confirmation = confirmationOf(five, change);
    SetPoint duty;
    duty.mode = Mode::Duty;
    duty.target = 0.3;
    SetPointStream &stream = bench.session.stream(five);
    ASSERT_TRUE(stream.start(duty, 60s));
    EXPECT_EQ(pass(confirmation, five, 40s), 0);
    ASSERT_TRUE(five.liveness().moving);
    EXPECT_EQ(confirmation.state(), State::AwaitsStandstill);
    EXPECT_FALSE(run(settings::putBack(five, change.number, *book, progress)));
    EXPECT_EQ(all(five).size(), 1U) << "nothing was begun";
    stream.stop();
    EXPECT_EQ(pass(confirmation, five, 20s), 1);
}

TEST_F(Confirmations, NothingIsPutBackIntoAUnitThatIsNotHeard)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "current_limit.peak");
    const SettingsChange change = provisional(five, {this->change(five, "current_limit.peak", *old * 2)});
    Confirmation confirmation = confirmationOf(five, change);
    bench.simulator("dmc60c:5")->setPowered(false);
    EXPECT_EQ(pass(confirmation, five, 40s), 0);
    EXPECT_EQ(confirmation.state(), State::AwaitsStandstill);
    EXPECT_EQ(run(settings::putBack(five, change.number, *book, progress)).error().fault, Fault::Unsafe);
    EXPECT_EQ(all(five).size(), 1U) << "nothing was begun";
    bench.simulator("dmc60c:5")->setPowered(true);
    EXPECT_EQ(pass(confirmation, five, 5s), 1);
}

TEST_F(Confirmations, OnlyALaterValueThatWasSeenReplacesOne)
{
    const Family &nodes = *findFamily(families(), "supermodified");
    for (const auto &[proof, open] :
        {std::pair{Proof::Equal, 0U}, {Proof::Blind, 0U}, {Proof::Open, 1U}, {Proof::Refused, 1U}}) {
        std::array<SettingsChange, 2> changes;
        changes[0].purpose = Purpose::Provisional;
        changes[0].values = {{"uart.baud", 57600, 115200, Proof::Equal}};
        changes[1].origin = settings::Origin::Console; // what the window writes over it is measured by what was kept
        changes[1].values = {{"uart.baud", 115200, 9600, proof}};
        EXPECT_EQ(settings::unconfirmed(nodes, changes).size(), open) << static_cast<int>(proof);
    }
}

TEST_F(Confirmations, AreNotAskedOfALimitThatNobodyCouldReadBeforeForItIsNotWritten)
{
    Device &five = *bench.device(5);
    bench.simulator("dmc60c:5")->setPowered(false);
    for (const std::vector<ParameterChange> &changes : {std::vector{change(five, "current_limit.peak", 20 * amperes)},
             {change(five, "slot0.p", amperes), change(five, "current_limit.peak", 20 * amperes)}}) {
        const auto outcomes = write(five, changes);
        ASSERT_FALSE(outcomes);
        EXPECT_EQ(outcomes.error().fault, Fault::Timeout);
    }
    EXPECT_TRUE(all(five).empty());
    EXPECT_TRUE(write(five, {change(five, "slot0.p", amperes)})) << "nobody has to keep a gain";
}

class BoardConfirmations : public Confirmations {
protected:
    BoardConfirmations()
        : Confirmations("sim:spi")
    {
    }
};

TEST_F(BoardConfirmations, ALimitThatNobodyKnewCountsAsWiderAndGoesToItsTightest)
{
    Device &board = *bench.device(0, "quadquad2drv");
    const std::vector<std::pair<std::string, std::int64_t>> tightest{
        {"ch1.limit.power", 0}, {"ch1.limit.velocity", 0}, {"ch1.limit.acceleration", 1}};
    std::vector<ParameterChange> changes;
    for (const auto &[key, least] : tightest)
        changes.push_back(change(board, key, 2000));
    const SettingsChange first = provisional(board, changes);
    EXPECT_EQ(first.purpose, Purpose::Provisional);
    Confirmation confirmation = confirmationOf(board, first);
    EXPECT_EQ(pass(confirmation, board, 31s), 1);
    ASSERT_TRUE(run(settings::putBack(board, first.number, *book, progress)));
    for (const auto &[key, least] : tightest)
        EXPECT_EQ(board.parameters().entry(bench.index(board, key)).raw, least) << key;
    EXPECT_TRUE(run(settings::findUnconfirmed(board, *book))->empty());

    const SettingsChange second = provisional(board, {change(board, "ch2.limit.power", 4000)});
    ASSERT_TRUE(run(settings::keepChange(board, second.number, *book)));
    EXPECT_EQ(provisional(board, {change(board, "ch2.limit.power", 2000)}).purpose, Purpose::Write) << "that is safer";
    EXPECT_EQ(provisional(board, {change(board, "ch3.limit.power", 0)}).purpose, Purpose::Write) << "nothing is safer";
}

class SerialConfirmations : public Confirmations {
protected:
    SerialConfirmations()
        : Confirmations("sim:serial")
    {
    }
};

TEST_F(SerialConfirmations, WhatActsAfterARestartCountsFromThen)
{
    Device &four = *bench.device(4, "supermodified");
    const auto old = reads(four, "uart.baud");
    ASSERT_TRUE(old);
    const std::int64_t other = *old == 57600 ? 115200 : 57600;
    const SettingsChange change = provisional(four, {this->change(four, "uart.baud", other)});
    Confirmation confirmation = confirmationOf(four, change);
    EXPECT_EQ(pass(confirmation, four, 60s), 0);
    EXPECT_EQ(confirmation.state(), State::AwaitsRestart);
    EXPECT_EQ(confirmation.left(bench.clock.now()), 30s);
}

TEST_F(SerialConfirmations, WhatActsAfterARestartGoesBackThirtySecondsAfterIt)
{
    Device &four = *bench.device(4, "supermodified");
    const auto restart = [this] {
        bench.simulator("supermodified:4")->setPowered(false);
        bench.clock.advance(1s);
        bench.simulator("supermodified:4")->setPowered(true);
        bench.clock.advance(1s);
    };
    const auto old = reads(four, "node.mask");
    ASSERT_TRUE(old);
    const SettingsChange change = provisional(four, {this->change(four, "node.mask", 127)});
    Confirmation confirmation = confirmationOf(four, change);
    EXPECT_EQ(pass(confirmation, four, 60s), 0);
    restart();
    ASSERT_EQ(reads(four, "node.mask"), 127);
    EXPECT_EQ(confirmation.look(four, bench.clock.now()), State::Counting);
    EXPECT_EQ(pass(confirmation, four, 29'900ms), 0);
    EXPECT_EQ(pass(confirmation, four, 300ms), 1);
    ASSERT_TRUE(run(settings::putBack(four, change.number, *book, progress)));
    restart();
    EXPECT_EQ(reads(four, "node.mask"), old);
}

} // namespace
} // namespace mb
