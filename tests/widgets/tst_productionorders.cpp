// SPDX-License-Identifier: GPL-3.0-or-later
// What the hand orders at a station: nothing without the focus, nothing twice, and the unit that is there.
#include "parameterbench.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/common/holdbutton.h"
#include "widgets/service/productionhead.h"
#include "widgets/service/productionpage.h"

#include <QApplication>
#include <QComboBox>
#include <QSignalSpy>
#include <QTimer>

#include <algorithm>

using namespace mb;
using namespace mb::test;

namespace {

const QByteArray handsRecipe
    = R"({"recipe":1,"name":"drive-base rev C","family":"dmc60c","test":{"loop":"velocity","to":1500,
"limits":{"travel":50000,"speed":2000,"duty":0.3},"accept":{"overshoot":0.4}}})";

service::QueueRow failedRow(std::uint32_t id, service::RowState state, const char *serial)
{
    service::QueueRow row;
    row.id = id;
    row.state = state;
    row.visit.serial = serial;
    return row;
}

struct StationBench {
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    QTemporaryDir folder;
    std::unique_ptr<ProductionPage> page;

    StationBench()
    {
        LinkView link;
        link.address = link.name = "sim:can";
        link.state = LinkState::Open;
        workbench.shot.links.push_back(link);
        page = std::make_unique<ProductionPage>(workbench, families(), theme, nullptr);
        page->setSound(false);
        page->show();
        QApplication::setActiveWindow(page.get());
        QFile file(folder.filePath(s("recipe.json")));
        if (file.open(QIODevice::WriteOnly) && file.write(handsRecipe) > 0) {
            file.close();
            (void)page->openRecipe(file.fileName());
        }
    }
    /// What was ordered of arming, oldest first.
    [[nodiscard]] std::vector<bool> armed() const
    {
        std::vector<bool> orders;
        for (const auto &order : workbench.given<orders::ArmService>())
            orders.push_back(order.on);
        return orders;
    }
};

} // namespace

class TestProductionOrders : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QApplication::setDoubleClickInterval(0); }
    void nothingIsArmedWithoutTheFocus();
    void aHoldEndsWithTheFocus();
    void aDoubleClickStartsAndEndsNothing();
    void aPressOnEndStartsNothingWhereTheQueueEndsMeanwhile();
    void aScannedSerialIsTheUnitThatWasPutOnLast();
    void theLinkThatWasChosenStaysSoWhateverBecomesOfIt();
    void theLinkThatIsServedIsNamedAlsoWhereItIsLost();
};

void TestProductionOrders::nothingIsArmedWithoutTheFocus()
{
    StationBench bench;
    bench.page->start();
    Q_EMIT qApp->applicationStateChanged(Qt::ApplicationInactive);
    QCOMPARE(bench.armed(), std::vector<bool>{false}); // whatever the last picture says
    Q_EMIT bench.page->armButton().activated();
    QCOMPARE(bench.armed(), std::vector<bool>{false});
    Q_EMIT qApp->applicationStateChanged(Qt::ApplicationActive);
    Q_EMIT bench.page->armButton().activated();
    QCOMPARE(bench.armed(), (std::vector<bool>{false, true}));
}

void TestProductionOrders::aHoldEndsWithTheFocus()
{
    ThemeSource theme{darkTheme()};
    HoldButton button(theme, Symbol::Play, s("Arm"));
    button.setHoldNeeded(true);
    button.setHoldMilliseconds(50);
    const QSignalSpy armed(&button, &HoldButton::activated);
    button.show();
    QApplication::setActiveWindow(&button);
    QTest::mousePress(&button, Qt::LeftButton);
    QVERIFY(button.isDown());
    QApplication::setActiveWindow(nullptr);
    QVERIFY(!button.isDown());
    QTimer later; // than the hold would have ended
    later.start(150);
    QSignalSpy(&later, &QTimer::timeout).wait();
    QCOMPARE(armed.count(), 0);
}

void TestProductionOrders::aDoubleClickStartsAndEndsNothing()
{
    StationBench bench;
    QApplication::setDoubleClickInterval(60'000);
    auto *const head = bench.page->findChild<ProductionHead *>();
    const auto buttons = head->findChildren<CommandButton *>();
    auto *const start = *std::ranges::find(buttons, s("Start"), &QAbstractButton::text);
    QTest::mouseClick(start, Qt::LeftButton);
    QTest::mouseClick(start, Qt::LeftButton); // before the engine has answered
    QCOMPARE(bench.workbench.given<orders::ServeUnits>().size(), 1U);
    bench.workbench.serve({});
    const auto begun = bench.workbench.given<orders::ServeUnits>();
    begun.front().finished({});
    QTest::mouseClick(start, Qt::LeftButton);
    QVERIFY(bench.workbench.given<orders::FinishService>().empty());
    start->click(); // later
    QCOMPARE(bench.workbench.given<orders::FinishService>().size(), 1U);
}

void TestProductionOrders::aPressOnEndStartsNothingWhereTheQueueEndsMeanwhile()
{
    StationBench bench;
    const auto buttons = bench.page->findChild<ProductionHead *>()->findChildren<CommandButton *>();
    auto *const end = *std::ranges::find(buttons, s("Start"), &QAbstractButton::text);
    const auto begun = [&bench] { return bench.workbench.given<orders::ServeUnits>(); };
    bench.page->start();
    bench.workbench.serve({});
    begun().front().finished({});
    QCOMPARE(end->text(), s("End"));
    QTest::mousePress(end, Qt::LeftButton);
    bench.workbench.serve({}, false);
    QTest::mouseRelease(end, Qt::LeftButton);
    QCOMPARE(begun().size(), 1U);
    QTest::mouseClick(end, Qt::LeftButton);
    QCOMPARE(begun().size(), 2U);
}

void TestProductionOrders::aScannedSerialIsTheUnitThatWasPutOnLast()
{
    StationBench bench;
    bench.workbench.serve({failedRow(3, service::RowState::Failed, "2103343A7B2E"),
        failedRow(4, service::RowState::Failed, "2103343A7B2E")});
    auto *serial = bench.page->findChild<QLineEdit *>();
    QTest::keyClicks(serial, s("2103343A7B2E"));
    QTest::keyClick(serial, Qt::Key_Return);
    const auto again = bench.workbench.given<orders::RetryUnit>();
    QCOMPARE(again.size(), 1U);
    QCOMPARE(again.front().row, 4U);
    again.front().finished(fail(Fault::Refused, say("it was taken off")));
    QVERIFY2(bench.workbench.lines.back().text.contains(s("taken off")), "why nothing happens is said");
}

void TestProductionOrders::theLinkThatWasChosenStaysSoWhateverBecomesOfIt()
{
    StationBench bench;
    LinkView other = bench.workbench.shot.links.front();
    other.address = other.name = "socketcan:can1";
    bench.workbench.shot.links.push_back(other);
    bench.workbench.publish();
    auto *const box = bench.page->findChild<QComboBox *>();
    QTest::keyClick(box, Qt::Key_Down);
    QCOMPARE(box->currentText(), s("socketcan:can1"));
    const std::vector<LinkView> both = bench.workbench.shot.links;
    bench.workbench.shot.links.back().state = LinkState::Lost;
    bench.workbench.publish();
    QCOMPARE(box->currentText(), s("socketcan:can1, not open"));
    bench.workbench.shot.links.pop_back(); // nobody was on it
    bench.workbench.publish();
    QCOMPARE(box->currentText(), s("socketcan:can1, not open"));
    bench.workbench.shot.links = both;
    bench.workbench.publish();
    QCOMPARE(box->currentText(), s("socketcan:can1"));
    bench.page->start();
    QCOMPARE(bench.workbench.given<orders::ServeUnits>().at(0).links, std::vector<std::string>{"socketcan:can1"});
    const ProductionPage inAnotherLanguage(bench.workbench, families(), bench.theme, nullptr);
    QCOMPARE(inAnotherLanguage.findChild<ProductionHead *>()->link(), s("socketcan:can1"));
}

void TestProductionOrders::theLinkThatIsServedIsNamedAlsoWhereItIsLost()
{
    StationBench bench; // whose only link nobody has chosen by hand
    auto *const head = bench.page->findChild<ProductionHead *>();
    bench.page->start();
    bench.workbench.serve({});
    LinkView other = bench.workbench.shot.links.front();
    other.address = other.name = "socketcan:can1";
    bench.workbench.shot.links.front().state = LinkState::Lost;
    bench.workbench.shot.links.push_back(other);
    bench.workbench.publish();
    QCOMPARE(head->link(), s("sim:can"));
    bench.workbench.serve({}, false);
    bench.workbench.publish();
    QCOMPARE(head->link(), s("sim:can")); // for the next start
}

MB_WINDOW_TEST(TestProductionOrders);
#include "tst_productionorders.moc"
