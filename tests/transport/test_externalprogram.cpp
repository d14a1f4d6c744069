// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/task.h"
#include "firmware/programmer.h"
#include "support/eventloop.h"
#include "transport/externalprogram.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include <unistd.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

struct Heard {
    std::vector<std::string> lines;
    std::vector<std::string> partial;
    ExternalProgram::Exit exit;
};

Task<Heard> listen(Clock &clock, ExternalProgram::Command command, Duration patience)
{
    Heard heard;
    ExternalProgram program(clock);
    if (auto started = program.start(command); !started)
        co_return fail(started.error());
    for (;;) {
        const auto piece = co_await program.next(patience);
        if (!piece)
            co_return fail(piece.error());
        if (!*piece)
            break;
        ((*piece)->complete ? heard.lines : heard.partial).push_back((*piece)->text);
    }
    heard.exit = program.exit();
    co_return heard;
}

Result<Heard> run(test::EventLoop &loop, const std::string &script, Duration patience = 10s)
{
    auto task = listen(loop.clock(), {"sh", {"-c", script}}, patience);
    task.start();
    EXPECT_TRUE(loop.runUntil([&] { return task.isFinished(); }));
    return std::move(task.result());
}

TEST(ExternalProgram, YieldsLinesOfBothStreamsInOrderAndTheExitStatus)
{
    test::EventLoop loop;
    const auto heard = run(loop, "echo one; echo two >&2; printf 'three\\r\\nfour\\n\\nfive'; exit 3");
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->lines, (std::vector<std::string>{"one", "two", "three", "four", "five"}));
    EXPECT_EQ(heard->exit.status, 3);
    EXPECT_FALSE(heard->exit.isSuccess());
}

TEST(ExternalProgram, IsNotReachedByCtrlCInTheTerminalOfThisProgram)
{
    test::EventLoop loop;
    const auto heard = run(loop, "cut -d' ' -f5 /proc/$$/stat");
    ASSERT_TRUE(heard);
    ASSERT_EQ(heard->lines.size(), 1U);
    EXPECT_NE(heard->lines.front(), std::to_string(::getpgrp()));
}

TEST(ExternalProgram, GoesOnToPrintWhenThisProgramDies)
{
    test::EventLoop loop;
    const auto heard = run(loop, "sed -n 's/^SigIgn:[^0-9a-f]*//p' /proc/self/status");
    ASSERT_TRUE(heard);
    ASSERT_EQ(heard->lines.size(), 1U);
    EXPECT_TRUE(std::stoull(heard->lines.front(), nullptr, 16) >> (SIGPIPE - 1) & 1U) << heard->lines.front();
}

TEST(ExternalProgram, TellsALineThatGrows)
{
    test::EventLoop loop;
    const auto heard = run(loop, "printf 'bar |'; sleep 0.05; printf '##'; sleep 0.05; printf '##|\\n'");
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->lines, (std::vector<std::string>{"bar |####|"}));
    ASSERT_FALSE(heard->partial.empty());
    EXPECT_EQ(heard->partial.front(), "bar |");
    EXPECT_TRUE(heard->exit.isSuccess());
}

TEST(ExternalProgram, ALineWithoutEndComesInPiecesOf4096)
{
    test::EventLoop loop;
    const auto heard = run(loop, "head -c 9000 /dev/zero | tr '\\0' x; echo; echo end");
    ASSERT_TRUE(heard);
    std::vector<std::size_t> sizes;
    for (const std::string &line : heard->lines)
        sizes.push_back(line.size());
    EXPECT_EQ(sizes, (std::vector<std::size_t>{4096, 4096, 808, 3}));
}

TEST(ExternalProgram, StandardInputIsEmpty)
{
    test::EventLoop loop;
    const auto heard = run(loop, "cat; echo end");
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->lines, (std::vector<std::string>{"end"}));
}

TEST(ExternalProgram, ASilentProgramIsATimeout)
{
    test::EventLoop loop;
    const auto heard = run(loop, "exec sleep 100", 30ms);
    ASSERT_FALSE(heard);
    EXPECT_EQ(heard.error().fault, Fault::Timeout);
}

TEST(ExternalProgram, AMissingProgramIsOneClearLine)
{
    test::EventLoop loop;
    auto task = listen(loop.clock(), {"no-such-program-here", {}}, 1s);
    task.start();
    ASSERT_TRUE(task.isFinished());
    ASSERT_FALSE(task.result());
    EXPECT_EQ(task.result().error().fault, Fault::LinkLost);
    EXPECT_NE(task.result().error().text().find("no-such-program-here is not installed"), std::string::npos);
}

TEST(ExternalProgram, OneThatIsEndedByASignalHasCrashed)
{
    test::EventLoop loop;
    const auto heard = run(loop, "echo before; kill -9 $$");
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->lines, (std::vector<std::string>{"before"}));
    EXPECT_TRUE(heard->exit.crashed);
}

TEST(ExternalProgram, CancellingTheTaskKillsTheProgram)
{
    test::EventLoop loop;
    std::string pid;
    {
        ExternalProgram program(loop.clock());
        ASSERT_TRUE(program.start({"sh", {"-c", "echo $$; exec sleep 100"}}));
        auto first = [](ExternalProgram &of) -> Task<std::string> {
            const auto piece = co_await of.next(10s);
            if (!piece || !*piece)
                co_return fail(Fault::BadReply, say("no line"));
            co_return (*piece)->text;
        }(program);
        first.start();
        ASSERT_TRUE(loop.runUntil([&] { return first.isFinished(); }));
        ASSERT_TRUE(first.result());
        pid = *first.result();
        ASSERT_EQ(::kill(std::atoi(pid.c_str()), 0), 0);
    }
    EXPECT_NE(::kill(std::atoi(pid.c_str()), 0), 0) << "process " << pid << " is still there";
}

TEST(ExternalProgram, ManyLinesInOneGoAreAllTold)
{
    test::EventLoop loop;
    const auto heard = run(loop, "seq 1 20000");
    ASSERT_TRUE(heard);
    ASSERT_EQ(heard->lines.size(), 20000U);
    EXPECT_EQ(heard->lines.back(), "20000");
}

/// What is told of a job.
class Told final : public Progress {
public:
    void step(const Message &, int, int) override { }
    void part(int, PartState) override { }
    void log(Severity, const Message &text) override { lines.push_back(text.english()); }
    std::vector<std::string> lines;
};

TEST(Programmer, WholeLinesThatAreNotEmptyGoToTheLog)
{
    test::EventLoop loop;
    Told told;
    std::vector<std::string> taken;
    auto task = runProgrammer(
        loop.clock(), {"sh", {"-c", "echo erased; echo; printf 'writing 1'; sleep 0.1; echo 2; exit 4"}}, {},
        [&taken](const ExternalProgram::Piece &piece) { taken.push_back(piece.text); }, told);
    task.start();
    ASSERT_TRUE(loop.runUntil([&] { return task.isFinished(); }));
    ASSERT_TRUE(task.result());
    EXPECT_EQ(task.result()->status, 4);
    EXPECT_EQ(told.lines, (std::vector<std::string>{"erased", "writing 12"}));
    EXPECT_EQ(std::count(taken.begin(), taken.end(), "writing 1"), 1) << "what grows is seen while it does";
}

TEST(Programmer, OneThatIsFoundAndCannotBeStartedIsNotTakenForASilentOne)
{
    test::EventLoop loop;
    QTemporaryDir folder;
    QFile script(folder.path() + "/programmer");
    ASSERT_TRUE(script.open(QIODevice::WriteOnly));
    script.write("#!/nonexistent\n");
    script.close();
    ASSERT_TRUE(script.setPermissions(QFile::ReadOwner | QFile::ExeOwner));
    Told told;
    auto task = runProgrammer(loop.clock(), {script.fileName().toStdString(), {}}, say("check the probe"), {}, told);
    task.start();
    ASSERT_TRUE(loop.runUntil([&] { return task.isFinished(); }));
    ASSERT_FALSE(task.result());
    EXPECT_EQ(task.result().error().fault, Fault::LinkLost);
    EXPECT_NE(task.result().error().text().find("cannot be started"), std::string::npos)
        << task.result().error().text();
}

} // namespace
} // namespace mb
