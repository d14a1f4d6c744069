// SPDX-License-Identifier: GPL-3.0-or-later
// What is between a simulated board and its client on one computer: a socket with a path.
#include "async/descriptor.h"
#include "support/temporaryfile.h"
#include "transport/backends/unixsocket.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <list>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

struct UnixSocketPath : testing::Test {
    /// Why it fails, in words and as an ailment.
    [[nodiscard]] static std::pair<std::string, Ailment> causeOf(
        const Result<int> &tried, Fault fault = Fault::LinkLost)
    {
        EXPECT_FALSE(tried);
        if (tried)
            return {};
        EXPECT_EQ(tried.error().fault, fault);
        return {tried.error().text(), tried.error().ailment};
    }
    test::TemporaryFolder folder;
    std::string path = folder.path("board");
};

using Cause = std::pair<std::string, Ailment>;

TEST_F(UnixSocketPath, ConnectsToWhoeverListensAndBothEndsWaitForNothing)
{
    const Descriptor listening(listenOnUnixSocket(path).value_or(-1));
    const Descriptor client(connectUnixSocket(path).value_or(-1));
    for (const int each : {listening.get(), client.get()}) {
        EXPECT_TRUE(::fcntl(each, F_GETFL) & O_NONBLOCK);
        EXPECT_TRUE(::fcntl(each, F_GETFD) & FD_CLOEXEC);
    }
    const Descriptor server(::accept(listening.get(), nullptr, nullptr));
    ASSERT_EQ(::send(client.get(), "ab", 2, 0), 2);
    std::vector<std::uint8_t> in{9};
    EXPECT_TRUE(receiveFrom(server.get(), in));
    EXPECT_EQ(in, (std::vector<std::uint8_t>{9, 'a', 'b'}));
}

TEST_F(UnixSocketPath, OneThatCannotBeHasFrom1To107Characters)
{
    const std::string longest(107, 'x');
    EXPECT_EQ(causeOf(connectUnixSocket(longest)),
        (Cause{"there is no socket " + longest
                + "; start the simulator first: motorbenchctl simulate --on unix:" + longest,
            Ailment::NotThere}));
    for (const std::string &none : {std::string(), longest + 'x'}) {
        const Cause cause{"'" + none + "' is no path of a socket: it has 1 to 107 characters", Ailment::None};
        EXPECT_EQ(causeOf(connectUnixSocket(none), Fault::OutOfRange), cause);
        EXPECT_EQ(causeOf(listenOnUnixSocket(none), Fault::OutOfRange), cause);
    }
}

TEST_F(UnixSocketPath, OneInAFolderThatIsNotThereIsNotServedAndNobodyIsToldToStartIt)
{
    const std::string nowhere = path + "/socket";
    const Cause cause{nowhere + " cannot be made: No such file or directory; choose another path", Ailment::None};
    EXPECT_EQ(causeOf(listenOnUnixSocket(nowhere)), cause);
}

TEST_F(UnixSocketPath, WhoeverServesItNoMoreIsNamedAndReplaced)
{
    ::close(listenOnUnixSocket(path).value_or(-1));
    EXPECT_EQ(causeOf(connectUnixSocket(path)),
        (Cause{"nobody serves " + path + "; start the simulator again", Ailment::NotThere}));
    const Descriptor next(listenOnUnixSocket(path).value_or(-1));
    EXPECT_GE(next.get(), 0);
    const Descriptor client(connectUnixSocket(path).value_or(-1));
    EXPECT_GE(client.get(), 0);
}

TEST_F(UnixSocketPath, WhoServesItIsLeftAloneAlsoWhileHisQueueIsFull)
{
    const Descriptor listening(listenOnUnixSocket(path).value_or(-1));
    std::list<Descriptor> clients;
    Result<int> next = connectUnixSocket(path);
    for (; next && clients.size() < 9; next = connectUnixSocket(path))
        clients.emplace_back(*next);
    EXPECT_EQ(clients.size(), 2U) << "one that is taken next, and one behind it";
    EXPECT_EQ(causeOf(next), (Cause{path + " is busy: it serves one client at a time", Ailment::Busy}));
    EXPECT_EQ(
        causeOf(listenOnUnixSocket(path)), (Cause{path + " is served by another program already", Ailment::Busy}));
    const Descriptor first(::accept(listening.get(), nullptr, nullptr));
    EXPECT_EQ(causeOf(listenOnUnixSocket(path)).second, Ailment::Busy);
}

TEST_F(UnixSocketPath, WhatIsNoSocketStaysAndWhatElseIsWrongIsSaidByTheSystem)
{
    folder.write("board", "a letter");
    EXPECT_EQ(causeOf(listenOnUnixSocket(path)),
        (Cause{path + " exists and is no socket; choose another path", Ailment::None}));
    EXPECT_EQ(folder.read("board"), "a letter");
    const std::string below = path + "/x";
    EXPECT_EQ(causeOf(connectUnixSocket(below)), (Cause{below + ": Not a directory", Ailment::None}));
    EXPECT_EQ(causeOf(listenOnUnixSocket(below)), (Cause{below + ": Not a directory", Ailment::None}));
}

} // namespace
} // namespace mb
