// SPDX-License-Identifier: GPL-3.0-or-later
// What the page Design announces is of the limits that are in force, whichever a set was found for.
#include "designbench.h"
#include "support/windowtests.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/design/designpage.h"

#include <QLineEdit>
#include <QPointer>
#include <QTest>

using namespace mb;
using namespace mb::test;
using namespace mb::tuning;

namespace {

void enter(DesignBench &bench, const char *limit, const char *text)
{
    for (auto *field : bench.page->envelope().findChildren<QLineEdit *>()) {
        if (field->accessibleName().startsWith(QLatin1String(limit))) {
            field->setText(QLatin1String(text));
            Q_EMIT field->textEdited(field->text());
            Q_EMIT field->editingFinished();
        }
    }
    bench.workbench.publish();
}

/// Between soft limits this far to both sides.
TuneReport identifiedBetween(DeviceView &drive, double limit)
{
    const auto set
        = [&drive](const char *key, std::int64_t raw) { drive.parameters.edit()[named(key).value].raw = raw; };
    set("limit.forward.soft.threshold", rawOf("limit.forward.soft.threshold", limit));
    set("limit.reverse.soft.threshold", rawOf("limit.reverse.soft.threshold", -limit));
    set("limit.forward.soft.enabled", 1);
    set("limit.reverse.soft.enabled", 1);
    TuneReport report = identified();
    report.envelope.travel = limit;
    for (Proposal &proposal : report.proposals) {
        const double response = responseOf(Mode::Position, proposal.aim, report.plant);
        proposal.design = design(Mode::Position, report.plant, response, {});
        proposal.gains.made = proposal.design.gains;
    }
    return report;
}

} // namespace

class TestDesignLimits : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void underOtherLimitsTheStepOfNowIsSaidAndThatGainsAreFoundAnew();
    void theLimitsOfTheChosenSlotAreInForce();
    void setsAreDesignedAnewOnlyOnceTheMotorStandsElsewhere();
    void aVelocityLoopOfAMotorThatIsNotSimulatedNeedsASpeed();
};

void TestDesignLimits::underOtherLimitsTheStepOfNowIsSaidAndThatGainsAreFoundAnew()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    const ContinuousGains found = bench.page->chosen()->design.gains;
    const auto steps = [&bench](double to) {
        return courseOf(bench).contains(QStringLiteral("Run 4 steps of %1 ").arg(formatSignificant(to, 4)));
    };
    QVERIFY2(steps(60000.0), qPrintable(courseOf(bench)));
    enter(bench, "Envelope: Speed", "20000");
    QVERIFY2(steps(12000.0), qPrintable(courseOf(bench)));
    QVERIFY2(courseOf(bench).contains(QStringLiteral("Find the gains anew")), qPrintable(courseOf(bench)));
    QVERIFY(bench.page->chosen()->design.gains == found);
    bench.page->chooseOwn(0.3, 1.6);
    bench.workbench.publish();
    QVERIFY2(steps(12000.0) && !courseOf(bench).contains(QStringLiteral("anew")), "the sliders' are of now at once");
    enter(bench, "Envelope: Speed", "10000");
    QVERIFY2(steps(6000.0), qPrintable(courseOf(bench)));
    enter(bench, "Envelope: Speed", "");
    bench.page->chooseAim(Aim::Normal);
    bench.workbench.publish();
    QVERIFY2(steps(60000.0) && !courseOf(bench).contains(QStringLiteral("anew")), "as it was identified");
}

void TestDesignLimits::theLimitsOfTheChosenSlotAreInForce()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.workbench.device(0).parameters.edit()[named("slot1.max_forward").value].raw = 3276;
    bench.workbench.publish();
    QVERIFY(!courseOf(bench).contains(QStringLiteral("anew")));
    bench.page->chooseSlot(1);
    QVERIFY2(courseOf(bench).contains(QStringLiteral("anew")), "a tenth of the duty leaves another step");
}

void TestDesignLimits::setsAreDesignedAnewOnlyOnceTheMotorStandsElsewhere()
{
    DesignBench bench;
    const TuneReport report = identifiedBetween(bench.workbench.device(0), 5000.0);
    const auto isAt = [&bench](double position, bool moving) {
        bench.recording.skip(0.1);
        bench.recording.add("position", position);
        bench.recording.telemetry()->commit();
        bench.workbench.time = bench.recording.now();
        bench.workbench.device(0).liveness.moving = moving;
        bench.workbench.publish();
    };
    isAt(0.0, false);
    bench.page->chooseLoop(Mode::Position);
    bench.arm();
    bench.page->identify();
    bench.finish(report);
    QCOMPARE(bench.cards().size(), 3);
    QVERIFY2(!courseOf(bench).contains(QStringLiteral("anew")), qPrintable(courseOf(bench)));
    QPointer<ProposalCard> card = bench.cards().front();
    for (const double position : {500.0, 1000.0, 2000.0})
        isAt(position, true);
    QVERIFY2(card, "somebody may be pressing it, and it takes long");
    isAt(2000.0, false);
    QVERIFY(!card);
    QVERIFY2(courseOf(bench).contains(QStringLiteral("other limits, or elsewhere")), qPrintable(courseOf(bench)));
    QCOMPARE(bench.cards().size(), 3);
    card = bench.cards().front();
    isAt(2001.0, false);
    QVERIFY2(card, "a count makes no other set");
}

void TestDesignLimits::aVelocityLoopOfAMotorThatIsNotSimulatedNeedsASpeed()
{
    DesignBench bench;
    bench.workbench.device(0).link = "socketcan:can0";
    bench.workbench.publish();
    enter(bench, "Envelope: Travel", "100000");
    enter(bench, "Envelope: Duty", "0.5");
    enter(bench, "Envelope: Current", "20");
    bench.arm();
    bench.page->chooseLoop(Mode::Velocity);
    QVERIFY(!bench.page->status().mayRun);
    QVERIFY(bench.page->status().remedy.contains(QStringLiteral("Nothing bounds the motor")));
    bench.page->autotune();
    QVERIFY(bench.workbench.given<orders::RunTuning>().empty());
    bench.page->chooseLoop(Mode::Position); // which needs none
    QVERIFY2(bench.page->status().mayRun, qPrintable(bench.page->status().remedy));
    bench.page->chooseLoop(Mode::Velocity);
    enter(bench, "Envelope: Speed", "90000");
    QVERIFY2(bench.page->status().mayRun, qPrintable(bench.page->status().remedy));
}

MB_WINDOW_TEST(TestDesignLimits);
#include "tst_designlimits.moc"
