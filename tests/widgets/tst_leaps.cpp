// SPDX-License-Identifier: GPL-3.0-or-later
// A gain that changes by more than ten times is looked at once more; the end of a range is no remedy for a gain.
#include "support/windowtests.h"
#include "tunehand.h"
#include "widgets/common/banner.h"
#include "widgets/control/gainspanel.h"
#include "widgets/parameters/changespanel.h"
#include "widgets/parameters/editdesk.h"
#include "widgets/parameters/faultline.h"
#include "widgets/parameters/leap.h"

#include <QLabel>
#include <QPushButton>

using namespace mb;
using namespace mb::test;

class LeapsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aGainLeapsBeyondTenTimesEitherWay();
    void theEndOfTheRangeIsNoRemedyForAGain();
    void theEndOfTheRangeIsOneForALimit();
    void aLeapIsWrittenOnlyAfterOneMoreLook();
    void theTunePageAsksToo();
    void whatIsStagedOnOnePageIsStagedOnTheOther();
    void writeOnlyFamiliesAreNotToldThatValuesAreCompared();
};

namespace {

std::optional<double> leapOf(const char *key, double from, double to)
{
    return leap(dmc60c().parameters[named(key).value], rawOf(key, from), rawOf(key, to));
}

template <class Widget> Widget *visible(QWidget &page, const QString &start)
{
    for (auto *widget : page.findChildren<Widget *>()) {
        if (widget->isVisible() && widget->text().startsWith(start))
            return widget;
    }
    return nullptr;
}

} // namespace

void LeapsTest::aGainLeapsBeyondTenTimesEitherWay()
{
    QVERIFY(!leapOf("slot0.p", 1.2, 12.0));
    QVERIFY(!leapOf("slot0.p", 1.2, 0.12));
    QCOMPARE(std::round(leapOf("slot0.p", 1.0, 27.0).value()), 27.0);
    QVERIFY(leapOf("slot0.p", 27.0, 1.0).value() < 0.1);
    QVERIFY(!leapOf("slot0.i", 0.0, 5.0)); // switched on
    QVERIFY(!leapOf("slot0.p", 5.0, 0.0)); // switched off
    QVERIFY(!leapOf("current_limit.peak", 2.0, 60.0));
}

void LeapsTest::theEndOfTheRangeIsNoRemedyForAGain()
{
    ParameterBench bench;
    bench.set("slot0.p", 1.2, ParameterState::Stored);
    bench.stage("slot0.p", "40000");
    QVERIFY(visible<QLabel>(*bench.page, s("40000 is above")));
    QVERIFY(!visible<QPushButton>(*bench.page, s("Use ")));
    QVERIFY(visible<QPushButton>(*bench.page, s("Revert to 1.200")));
}

void LeapsTest::theEndOfTheRangeIsOneForALimit()
{
    ParameterBench bench;
    bench.stage("slot0.max_forward", "40000");
    QVERIFY(visible<QPushButton>(*bench.page, s("Use 32767")));
}

void LeapsTest::aLeapIsWrittenOnlyAfterOneMoreLook()
{
    ParameterBench bench;
    bench.set("slot0.p", 1.0, ParameterState::Stored);
    bench.stage("slot0.p", "27");
    QVERIFY(visible<QLabel>(*bench.page, s("27 × as large as now, 1")));
    QVERIFY(bench.edits().toWrite().empty());
    bench.page->write();
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
    auto *use = visible<QPushButton>(*bench.page, s("Use 27"));
    QVERIFY(use);
    use->click();
    QVERIFY(!visible<QLabel>(*bench.page, s("27 × as large")));
    bench.page->write();
    QCOMPARE(bench.workbench.given<orders::WriteParameters>().size(), 1U);
    bench.stage("slot0.p", "99"); // another value is another look
    QVERIFY(bench.edits().toWrite().empty());
}

void LeapsTest::theTunePageAsksToo()
{
    TuneBench bench;
    bench.arm();
    type(bench.find<QLineEdit>("P"), "40");
    QVERIFY2(problemOf(bench).startsWith(s("Look at a gain again | P: 34 × as large")), qPrintable(problemOf(bench)));
    bench.page->run();
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
    auto *use = visible<QPushButton>(*bench.page, s("Use it"));
    QVERIFY(use);
    use->click();
    bench.page->run();
    QCOMPARE(bench.workbench.given<orders::WriteParameters>().size(), 1U);
}

void LeapsTest::whatIsStagedOnOnePageIsStagedOnTheOther()
{
    TuneBench bench;
    BannerStack banners(bench.theme);
    ParametersPage parameters(bench.workbench, bench.selection, bench.theme, banners, nullptr);
    parameters.resize(1208, 760);
    parameters.show();
    type(bench.find<QLineEdit>("P"), "2");
    QCOMPARE(parameters.model().edits()->find(named("slot0.p"))->text, s("2"));
    parameters.model().edits()->stage(named("slot0.i"), s("0.005"));
    QCOMPARE(bench.find<QLineEdit>("I")->text(), s("0.005"));
    parameters.model().edits()->discard();
    QVERIFY(bench.page->column().gainsPanel().toWrite().empty());
}

void LeapsTest::writeOnlyFamiliesAreNotToldThatValuesAreCompared()
{
    const Family &family = *findFamily(families(), "abstractdc");
    DeviceView drive;
    drive.id = {1};
    drive.family = &family;
    drive.identity.edit().address = 3;
    drive.liveness.heard = true;
    drive.parameters.edit().resize(family.parameters.size());
    drive.parameterRevision = 1;
    ParameterBench blind(drive);
    blind.workbench.publish();
    QVERIFY(!visible<QLabel>(*blind.page, s("Each value is written, read back")));
    QVERIFY(visible<QLabel>(*blind.page, s("Each value is written. None can be read back")));
    ParameterBench seeing;
    seeing.workbench.publish();
    QVERIFY(visible<QLabel>(*seeing.page, s("Each value is written, read back and compared.")));
}

MB_WINDOW_TEST(LeapsTest);
#include "tst_leaps.moc"
