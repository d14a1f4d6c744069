// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/transcript.h"
#include "support/simulatedsession.h"
#include "support/temporaryfile.h"

namespace mb {
namespace {

TEST(Transcript, OfUnitsOfOneNumberOnTwoLinksInTheSameSecondAreTwoFiles)
{
    const test::TemporaryFolder folder;
    test::SimulatedSession left("sim:can");
    test::SimulatedSession right("sim:can?seed=2");
    std::vector<std::string> paths;
    for (test::SimulatedSession *bench : {&left, &right}) {
        bench->scan();
        OperationStatus status;
        status.log.push_back({status.startedAt, Severity::Info, say("page %1", 0)});
        const auto path = save(transcriptOf(folder.path("updates"), *bench->device(5), status, {}));
        ASSERT_TRUE(path) << path.error().text();
        paths.push_back(*path);
    }
    EXPECT_NE(paths[0], paths[1]);
    EXPECT_TRUE(paths[0].starts_with(folder.path("updates/sim.can.dmc60c.5-"))) << paths[0];
    EXPECT_NE(folder.read(paths[0]).find("# firmware update of sim:can/dmc60c:5\n"), std::string::npos);
    EXPECT_NE(folder.read(paths[1]).find("# firmware update of sim:can?seed=2/dmc60c:5\n"), std::string::npos);
}

} // namespace
} // namespace mb
