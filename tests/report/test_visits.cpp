// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/qttext.h"
#include "model/family.h"
#include "model/registry.h"
#include "report/report.h"
#include "report/visitsection.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using service::Outcome;
using service::Visit;

Visit visitOf(double time, double friction, Outcome outcome)
{
    Visit visit;
    visit.id = std::to_string(time);
    visit.time = time;
    visit.recipe = "drive-base <rev C>";
    visit.station = "bench 1";
    visit.person = "anna";
    visit.serial = "2103343A7B2E";
    visit.unit = "dmc60c 2103343A7B2E";
    visit.from = "1.23";
    visit.to = "1.25";
    visit.number = 36;
    visit.parameters = 55;
    visit.outcome = outcome;
    visit.test = {{"friction", friction, 0.1, 0.4, friction <= 0.4}, {"encoder", 1.0, 1.0, 1.0}};
    return visit;
}

Report reportOf(std::vector<Visit> visits)
{
    Report report;
    report.program = "MotorBench";
    ReportUnit unit;
    unit.identity.family = "dmc60c";
    unit.identity.address = 36;
    unit.identity.serial = "2103343A7B2E";
    unit.visits = std::move(visits);
    report.units.push_back(std::move(unit));
    return report;
}

TEST(ServiceCard, ComparesWithTheLastVisit)
{
    EXPECT_EQ(changeText(0.33, 0.24), QStringLiteral("+38 %"));
    EXPECT_EQ(changeText(0.12, 0.24), QString(QChar(0x2212)) + QStringLiteral("50 %"));
    EXPECT_EQ(changeText(0.12, std::nullopt), QString());
    const QString html
        = htmlOf(reportOf({visitOf(1e9, 0.24, Outcome::Passed), visitOf(1.01e9, 0.331, Outcome::Passed)}));
    EXPECT_TRUE(html.contains(QStringLiteral("+38 % since 2001-09-0"))) << html.toStdString();
    EXPECT_TRUE(html.contains(QStringLiteral("PASS")));
    EXPECT_TRUE(html.contains(QStringLiteral("1.23 → 1.25")));
    EXPECT_TRUE(html.contains(QStringLiteral("drive-base &lt;rev C&gt;")));
    EXPECT_TRUE(html.contains(QStringLiteral("Every service of this unit")));
}

TEST(ServiceCard, FirmwareThatWasThereAlreadyIsNoUpdate)
{
    auto visit = visitOf(1e9, 0.24, Outcome::Passed);
    visit.from = visit.to;
    const QString html = htmlOf(reportOf({visit}));
    EXPECT_TRUE(html.contains(QStringLiteral("1.25")));
    EXPECT_FALSE(html.contains(QStringLiteral("1.25 → 1.25"))) << html.toStdString();
}

TEST(ServiceCard, FrictionAndGainAreInVoltsOnlyOfAUnitThatMeasuresItsBusVoltage)
{
    for (const Family *const family : families()) {
        Report report = reportOf({visitOf(1e9, 0.24, Outcome::Passed)});
        report.units.front().family = family;
        report.units.front().visits.back().test.push_back({"gain", 4000.0, std::nullopt, 9000.0});
        const QString html = htmlOf(report);
        const bool volts = findChannel(family->channels, "bus_voltage").has_value();
        EXPECT_EQ(html.contains(QStringLiteral("Friction, V")), volts) << family->key;
        EXPECT_EQ(html.contains(QStringLiteral("counts/s per V")), volts) << family->key;
        EXPECT_EQ(html.contains(QStringLiteral("Friction, share of duty")), !volts) << family->key;
    }
}

TEST(ServiceCard, AFailureHasItsCause)
{
    Visit failed = visitOf(1e9, 0.61, Outcome::Failed);
    failed.cause = say("%1 is %2, %3", "friction", "0.61", say("limits %1 … %2", "0.1", "0.4"));
    failed.remedy = say("free the shaft");
    const QString html = htmlOf(reportOf({failed}));
    EXPECT_TRUE(html.contains(QStringLiteral("FAIL")));
    EXPECT_TRUE(html.contains(QStringLiteral("friction is 0.61, limits 0.1 … 0.4; free the shaft")));
    EXPECT_FALSE(html.contains(QStringLiteral("Every service")));
    EXPECT_FALSE(htmlOf(reportOf({})).contains(QStringLiteral("Service")));
}

TEST(ServiceCard, ComparesFrictionResistanceAndGainWithTheLastVisitThatMeasuredThem)
{
    Visit march = visitOf(1e9, 0.24, Outcome::Passed);
    march.test.push_back({"resistance", 0.080, 0.02, 0.5});
    march.test.push_back({"gain", 4000.0, std::nullopt, 9000.0});
    Visit without = visitOf(1.005e9, 0.25, Outcome::Passed);
    without.test.clear(); // served, and not tested
    Visit now = visitOf(1.01e9, 0.331, Outcome::Passed);
    now.test.push_back({"resistance", 0.092, 0.02, 0.5});
    now.test.push_back({"gain", 3800.0, std::nullopt, 9000.0});
    const QString html = cardHtmlOf(reportOf({march, without, now}));
    const QString minus = QChar(0x2212);
    for (const QString &change : {QStringLiteral("+38 %"), QStringLiteral("+15 %"), minus + QStringLiteral("5 %")})
        EXPECT_TRUE(html.contains(change + QStringLiteral(" since 2001-09-0"))) << change.toStdString();
    EXPECT_TRUE(html.contains(QStringLiteral("Resistance R, Ω")));
    EXPECT_TRUE(html.contains(QStringLiteral("Gain 1/Ke, counts/s per V")));
    EXPECT_FALSE(html.contains(QStringLiteral("Every service"))) << "a card is one page";
}

TEST(ServiceCard, SpeaksTheLanguageOfItsReader)
{
    Visit failed = visitOf(1e9, 0.61, Outcome::Failed);
    failed.cause = say("%1 is %2, %3", "friction", "0.61", say("limits %1 … %2", "0.1", "0.4"));
    Report report = reportOf({failed});
    report.phrase = [](const Message &text) { return qt("<" + std::string(text.literal()) + ">"); };
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral("&lt;%1 is %2, %3&gt;")));
}

TEST(ServiceCard, HasALabel)
{
    const QString label = labelHtmlOf(reportOf({visitOf(1e9, 0.24, Outcome::Passed)}));
    for (const char *const part : {"62mm 29mm", "36", "2103343A7B2E", "1.25", "PASS"})
        EXPECT_TRUE(label.contains(QLatin1String(part))) << part;
    EXPECT_FALSE(labelHtmlOf(reportOf({})).contains(QStringLiteral("<div")));
}

} // namespace
} // namespace mb
