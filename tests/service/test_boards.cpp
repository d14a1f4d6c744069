// SPDX-License-Identifier: GPL-3.0-or-later
// Three boards in one queue: there is one cable to a bootloader and one pair of hands, so that their steps come one after the other.
// Virtual time; the bootloaders are on pseudo terminals.
#include "servicebench.h"

#include <cstdio>

namespace mb::service {
namespace {

using namespace std::chrono_literals;
using test::QueueRun;
using test::ServiceBooks;
using test::UnitRack;

constexpr int boards = 3;

/// Whoever plugs the cable into the board whose turn it is, and does what its row asks for.
class Hands {
public:
    Hands(const ServiceBooks &books, std::vector<UnitRack *> racks)
        : m_books(books)
        , m_racks(std::move(racks))
    {
    }
    void follow(const std::vector<Shared<QueueRow>> &rows)
    {
        int running = 0;
        for (const QueueRow &row : rows) {
            if (row.state != RowState::Running)
                continue;
            ++running;
            help(row);
        }
        mostAtOnce = std::max(mostAtOnce, running);
    }
    std::vector<std::string> done; ///< board and what was asked for, in order
    int mostAtOnce = 0;

private:
    void help(const QueueRow &row)
    {
        const auto place = static_cast<std::size_t>(row.link.back() - '1');
        plug(place);
        const std::string &asked = row.what.english();
        Simulator &board = m_racks[place]->unit(0);
        if (asked.starts_with("close the jumper") && note(place, "close")) {
            board.disturb("jumper", 1.0);
            board.disturb("reset", 1.0);
        }
        if (asked.starts_with("take the jumper out") && note(place, "open"))
            board.disturb("jumper", 0.0);
    }
    void plug(std::size_t place)
    {
        if (std::exchange(m_plugged, place) == place)
            return;
        const QString cable = QString::fromStdString(m_books.path("cable"));
        QFile::remove(cable);
        EXPECT_TRUE(QFile::link(QString::fromStdString(m_books.path("boot" + std::to_string(place + 1))), cable));
    }
    bool note(std::size_t place, const std::string &what)
    {
        const std::string entry = std::to_string(place + 1) + ' ' + what;
        if (!done.empty() && done.back() == entry)
            return false;
        done.push_back(entry);
        return true;
    }
    const ServiceBooks &m_books;
    std::vector<UnitRack *> m_racks;
    std::optional<std::size_t> m_plugged;
};

RecipeMatter recipeOf(const ServiceBooks &books, const UnitRack &rack)
{
    books.write("board.hex", ":0400000001020304F2\n:0400040005060708DE\n:00000001FF\n");
    books.write("recipe.json",
        QByteArray(
            R"({"recipe":1,"name":"boards","family":"quadquad2drv","firmware":{"file":"board.hex","via":"serial:)")
            + QByteArray::fromStdString(books.path("cable")) + "\"}}");
    auto matter = loadRecipe(books.path("recipe.json"), rack.list());
    EXPECT_TRUE(matter) << matter.error().text();
    return *matter;
}

/// As long as `goesOn` says, five minutes at most.
void play(VirtualClock &clock, QueueRun &run, Hands &hands, const std::function<bool()> &goesOn)
{
    for (int round = 0; round < 60'000 && goesOn(); ++round) {
        clock.advance(5ms);
        test::serveDescriptors();
        hands.follow(run.queue.rows());
    }
}

TEST(BoardQueue, ThreeBoardsTheirHandsStepsOneAfterTheOther)
{
    VirtualClock clock;
    ServiceBooks books(clock);
    std::vector<std::unique_ptr<UnitRack>> racks;
    std::vector<UnitRack *> all;
    for (int i = 1; i <= boards; ++i) {
        const std::string number = std::to_string(i);
        racks.push_back(std::make_unique<UnitRack>(
            std::vector{"quadquad2drv:0,boot=pty:" + books.path("boot" + number)}, "sim:spi?seed=" + number, &clock));
        ASSERT_NE(racks.back()->link, nullptr);
        all.push_back(racks.back().get());
    }
    QueueRun run(*racks[0], books, recipeOf(books, *racks[0]));
    for (int i = 1; i < boards; ++i)
        run.queue.addBus(*all[static_cast<std::size_t>(i)]->session, *all[static_cast<std::size_t>(i)]->link);
    Hands hands(books, all);
    run.queue.start();
    play(clock, run, hands, [&run] { return !run.isEnded; });
    ASSERT_TRUE(run.isEnded);
    EXPECT_FALSE(run.queue.trouble()) << run.queue.trouble()->text();
    EXPECT_EQ(run.queue.counts().passed, boards);
    for (const QueueRow &row : run.queue.rows())
        EXPECT_EQ(row.state, RowState::Passed) << row.link << ": " << row.visit.cause.english();
    EXPECT_EQ(hands.mostAtOnce, 1) << "one cable, one pair of hands";
    ASSERT_EQ(hands.done.size(), 6U);
    for (std::size_t i = 0; i < hands.done.size(); i += 2) {
        EXPECT_EQ(hands.done[i].substr(1), " close");
        EXPECT_EQ(hands.done[i + 1], hands.done[i].substr(0, 1) + " open") << "of the same board";
    }
    const auto visits = books.visits();
    ASSERT_EQ(visits.size(), 3U);
    for (const Visit &visit : visits) {
        EXPECT_EQ(visit.from, "1.3");
        EXPECT_EQ(visit.to, "1.4");
    }
    std::printf("three boards, %zu steps by hand, never two at once, %.0f s\n", hands.done.size(),
        std::chrono::duration<double>(clock.now().time_since_epoch()).count());
}

TEST(BoardQueue, ABoardThatWasCutWhileItWasWrittenIsWrittenAgainThoughItIsMuteOnItsBus)
{
    VirtualClock clock;
    ServiceBooks books(clock);
    UnitRack rack(std::vector{"quadquad2drv:0,boot=pty:" + books.path("boot1")}, "sim:spi?seed=1", &clock);
    const RecipeMatter matter = recipeOf(books, rack);
    QueueOptions options;
    for (const bool isCut : {true, false}) {
        QueueRun run(rack, books, matter, options);
        Hands hands(books, {&rack});
        run.queue.start();
        play(clock, run, hands, [&] {
            const auto rows = run.queue.rows();
            const bool isWritten
                = !rows.empty() && rows[0]->what.english() == "sending the firmware" && rows[0]->done > 0;
            return !run.isEnded && !(isCut && isWritten);
        });
        EXPECT_EQ(run.isEnded, !isCut);
        options.run = run.queue.run();
    }
    const auto visits = books.visits();
    ASSERT_EQ(visits.size(), 1U);
    EXPECT_EQ(visits[0].outcome, Outcome::Passed) << visits[0].cause.english();
    EXPECT_EQ(visits[0].to, "1.4");
}

} // namespace
} // namespace mb::service
