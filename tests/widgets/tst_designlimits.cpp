// SPDX-License-Identifier: GPL-3.0-or-later
// What the page Design announces is of the limits that are in force, whichever a set was found for.
#include "designbench.h"
#include "support/windowtests.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/design/designpage.h"

#include <QLineEdit>
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

} // namespace

class TestDesignLimits : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void underOtherLimitsTheStepOfNowIsSaidAndThatGainsAreFoundAnew();
    void theLimitsOfTheChosenSlotAreInForce();
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
