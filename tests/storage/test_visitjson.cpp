// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/visitjson.h"
#include "support/temporaryfile.h"

#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonObject>

namespace mb {
namespace {

using service::Outcome;
using service::Step;
using service::Visit;

Visit whole()
{
    Visit visit;
    visit.time = 1.7e9;
    visit.station = "bench 1";
    visit.person = "anna";
    visit.recipe = "rev C, \"left\"";
    visit.recipeHash = "a1";
    visit.imageHash = "b2";
    visit.unit = "dmc60c A";
    visit.serial = "A";
    visit.device = "sim:can/dmc60c:5";
    visit.outcome = Outcome::Failed;
    visit.step = Step::Test;
    visit.from = "1.23";
    visit.to = "1.25";
    visit.parameters = 55;
    visit.number = 36;
    visit.seconds = 41.26;
    visit.cause = say("friction is %1", "0.61");
    visit.remedy = say("free the shaft");
    visit.evidence = say("read back");
    visit.note = "two\nlines";
    visit.test = {{"resistance", 0.25, {}, {}}, {"friction", 0.61, 0.1, 0.4, false}, {"encoder", 1.0, {}, {}}};
    return visit;
}

TEST(VisitJson, ATableHasARowAVisitAndAColumnAMeasuredValue)
{
    test::TemporaryFolder folder;
    Visit begun;
    begun.time = 1.7e9 + 60;
    begun.test = {{"gain", 4000.0, {}, {}}, {"friction", {}, {}, {}}};
    ASSERT_TRUE(exportVisits(folder.path("visits.csv"), {whole(), begun}));
    EXPECT_EQ(folder.read("visits.csv"),
        "time,station,person,recipe,recipe_hash,image_hash,unit,serial,device,result,step,from,to,parameters,number,"
        "seconds,cause,remedy,evidence,note,encoder,friction,gain,resistance\n"
        "2023-11-14T22:13:20Z,bench 1,anna,\"rev C, \"\"left\"\"\",a1,b2,dmc60c A,A,sim:can/dmc60c:5,failed,self-test,"
        "1.23,1.25,55,36,41.3,friction is 0.61,free the shaft,read back,\"two\nlines\",1,0.61,,0.25\n"
        "2023-11-14T22:14:20Z,,,,,,,,,open,preflight,,,,,0,,,,,,,4000,\n");
}

TEST(VisitJson, ALineHasNullForWhatIsNotKnown)
{
    const QJsonObject line = visitLine(whole());
    EXPECT_EQ(line.value(QStringLiteral("seconds")).toDouble(), 41.26);
    EXPECT_EQ(line.value(QStringLiteral("parameters")).toInt(), 55);
    EXPECT_EQ(
        line.value(QStringLiteral("evidence")).toString().toStdString(), "friction is 0.61; free the shaft; read back");
    const QJsonObject test = line.value(QStringLiteral("test")).toObject();
    EXPECT_TRUE(test.value(QStringLiteral("encoder")).toBool());
    EXPECT_EQ(test.value(QStringLiteral("friction")).toDouble(), 0.61);
    const QJsonObject empty = visitLine({});
    for (const char *const key : {"serial", "from", "to", "parameters"})
        EXPECT_TRUE(empty.value(QLatin1String(key)).isNull()) << key;
}

TEST(VisitJson, RowsAreLinesWithTheirPlace)
{
    const QJsonArray rows = visitRows({whole(), Visit()});
    ASSERT_EQ(rows.size(), 2);
    const QJsonObject row = rows[0].toObject();
    EXPECT_EQ(row.value(QStringLiteral("unit")).toString().toStdString(), "dmc60c A");
    EXPECT_EQ(row.value(QStringLiteral("time")).toDouble(), 1.7e9);
    EXPECT_EQ(row.value(QStringLiteral("station")).toString().toStdString(), "bench 1");
}

} // namespace
} // namespace mb
