// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/deviceprofile.h"
#include "model/transcript.h"
#include "support/simulatedsession.h"
#include "support/temporaryfile.h"

#include <fstream>
#include <iterator>

namespace mb {
namespace {

using namespace std::chrono_literals;

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

TEST(Transcript, HasWhatWasSaidWithUnixTimeAndHowItEnded)
{
    const test::TemporaryFolder folder;
    test::SimulatedSession bench;
    bench.scan();
    const Device &device = *bench.device(5);
    OperationStatus status;
    status.startedAt = Instant(1234567ms);
    status.log = {{Instant(1234567ms), Severity::Info, say("page %1", 3)},
        {Instant(1236005ms), Severity::Caution, say("page %1 once more", 3)}, {Instant(9us), Severity::Info, say("x")}};
    UpdateReport report;
    report.outcome = UpdateOutcome::Refused;
    report.evidence = say("page %1 was not taken", 3);
    report.remedy = say("try again");
    const Transcript made = transcriptOf(folder.path("updates"), device, status, report);
    EXPECT_EQ(made.folder, folder.path("updates"));
    EXPECT_EQ(made.path, made.folder + '/' + fileNameOf("sim:can/dmc60c:5", "-1234.log"));
    EXPECT_EQ(made.text,
        "# firmware update of sim:can/dmc60c:5\n(1234.567) page 3\n(1236.005) page 3 once more\n(0.000) x\n"
        "# refused: page 3 was not taken; try again\n");
    EXPECT_EQ(save(made), made.path);
    std::ifstream file(made.path);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), made.text);
}

TEST(Transcript, WhoseFolderCannotBeMadeIsOneClearLine)
{
    const test::TemporaryFolder folder;
    Transcript made;
    made.folder = folder.write("letter", "x") + "/updates";
    made.path = made.folder + "/one.log";
    const auto kept = save(made);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().fault, Fault::OutOfRange);
    EXPECT_EQ(kept.error().text(), made.folder + " cannot be made; check the rights of the folder above it");
}

} // namespace
} // namespace mb
