// SPDX-License-Identifier: GPL-3.0-or-later
// The notices that stand until their condition is over say nothing but what is so.
#include "support/fakeworkbench.h"
#include "support/windowtests.h"

#include "app/conditions.h"
#include "app/enterkey.h"
#include "model/registry.h"
#include "widgets/common/banner.h"
#include "widgets/control/arming.h"

#include <QApplication>
#include <QImage>
#include <QPushButton>
#include <QTest>

#include <algorithm>

using namespace mb;
using namespace mb::test;

class ConditionsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QApplication::setDoubleClickInterval(0); }
    void anUpdateThatMayBeCutIsNotSaidToNeedItsPower();
    void whatAQueueWritesIsSaidLikeAnUpdate();
    void whatWasStoppedByHandIsNotDrawnAsWhatRuns();
    void aNoticeEndsWithWhatItIsOf();
    void whatWasDismissedHidesNoOtherCause();
    void whatWasDismissedIsSilentUntilItsLinkIsWell();
    void aLinkThatIsLostOnceMoreIsSaidOnceMore();
    void aSecondEnterIsNotForWhatTheButtonHasBecome();
    void gainsThatAreOwedMayBeKeptAsTheyAre();
    void gainsThatAreOwedToAPlaceAreSaidToBeSo();
};

namespace {

struct Notices {
    FakeWorkbench workbench;
    Arming arming{workbench};
    ThemeSource theme{darkTheme()};
    BannerStack stack{theme};
    Conditions conditions{workbench, arming, stack, nullptr};

    Notices()
    {
        DeviceView device;
        device.id = {1};
        device.family = findFamily(families(), "dmc60c");
        device.identity.edit().address = 5;
        device.link = "sim:can";
        device.liveness.heard = true;
        workbench.shot.devices.push_back(device);
        stack.resize(800, 40);
        stack.show();
    }
    void write(bool mayInterrupt)
    {
        OperationView operation;
        operation.id = {3};
        operation.device = {1};
        operation.status.kind = OperationKind::UpdateFirmware;
        operation.status.done = 15;
        operation.status.total = 31;
        operation.status.mayInterrupt = mayInterrupt;
        workbench.shot.operations = {operation};
        follow();
    }
    void follow()
    {
        workbench.publish();
        conditions.follow();
    }
    [[nodiscard]] Banner &standing() const
    {
        for (Banner *banner : stack.findChildren<Banner *>()) {
            if (banner->isVisible())
                return *banner;
        }
        qFatal("no notice stands");
    }
    [[nodiscard]] QImage glyph() const
    {
        const Banner &banner = standing();
        return const_cast<Banner &>(banner).grab(QRect(0, 0, 36, banner.height())).toImage();
    }
};

} // namespace

void ConditionsTest::anUpdateThatMayBeCutIsNotSaidToNeedItsPower()
{
    Notices notices;
    notices.write(true);
    QCOMPARE(notices.standing().accessibleDescription(),
        QStringLiteral("Safe to unplug: the update can be run again. 15 of 31."));
    notices.write(false);
    QCOMPARE(notices.standing().accessibleDescription(), QStringLiteral("Do not unplug. 15 of 31."));
}

void ConditionsTest::whatAQueueWritesIsSaidLikeAnUpdate()
{
    Notices notices;
    service::QueueRow row;
    row.device = {1};
    row.state = service::RowState::Running;
    row.visit.step = service::Step::Firmware;
    row.done = 15;
    row.total = 31;
    row.mayInterrupt = false;
    notices.workbench.serve({row});
    notices.follow();
    QVERIFY(notices.standing().cause().startsWith(QStringLiteral("Firmware is being written to DMC60C #5")));
    QCOMPARE(notices.standing().accessibleDescription(), QStringLiteral("Do not unplug. 15 of 31."));
    row.visit.step = service::Step::Proof;
    notices.workbench.serve({row});
    notices.follow();
    QCOMPARE(notices.stack.count(), 0);
}

void ConditionsTest::whatWasStoppedByHandIsNotDrawnAsWhatRuns()
{
    Notices notices;
    notices.write(true);
    const QImage runs = notices.glyph();
    notices.workbench.shot.operations.clear();
    notices.arming.arm({1});
    QCOMPARE(notices.arming.state(), LampState::Armed);
    notices.arming.stopAll(QStringLiteral("Esc"));
    notices.follow();
    QCOMPARE(notices.standing().cause(), QStringLiteral("Stopped: Esc"));
    QVERIFY(notices.glyph() != runs);
}

void ConditionsTest::aNoticeEndsWithWhatItIsOf()
{
    Notices notices;
    LinkView link;
    link.address = link.name = "ttyUSB0";
    link.state = LinkState::Lost;
    notices.workbench.shot.links = {link};
    notices.workbench.device(0).liveness.foreignMaster = true;
    notices.follow();
    QCOMPARE(notices.stack.count(), 2);
    notices.workbench.shot.links.clear(); // somebody has closed it
    notices.follow();
    QCOMPARE(notices.standing().cause(), QStringLiteral("Another master drives DMC60C #5"));
    notices.workbench.shot.devices.clear();
    notices.follow();
    QCOMPARE(notices.stack.count(), 0);
}

void ConditionsTest::whatWasDismissedHidesNoOtherCause()
{
    Notices notices;
    const auto dismiss = [&notices] {
        Q_EMIT notices.standing().dismissed();
        QCOMPARE(notices.stack.count(), 0);
    };
    notices.workbench.device(0).mayTurn = true;
    notices.follow();
    dismiss();
    notices.follow();
    QCOMPARE(notices.stack.count(), 0);
    DeviceView second = notices.workbench.device(0);
    second.id = {2};
    second.identity.edit().address = 6;
    notices.workbench.shot.devices.push_back(second);
    notices.follow();
    QVERIFY(notices.standing().cause().contains(QStringLiteral("6")));
    dismiss();
    LinkView link;
    link.address = link.name = "can0";
    link.state = LinkState::Open;
    for (const Ailment ailment : {Ailment::NobodyAcknowledges, Ailment::Disturbed}) {
        link.diagnosis = {ailment, say("%1 is error-passive", "can0"), {}, {}};
        notices.workbench.shot.links = {link};
        notices.follow();
        QCOMPARE(notices.stack.count(), 1);
        dismiss();
    }
    notices.workbench.shot.links.front().diagnosis.cause
        = say("%1 with %2 transmit and %3 receive errors", "can0", 9, 0);
    notices.follow();
    QCOMPARE(notices.stack.count(), 0); // a number that goes on by itself is no other cause
}

void ConditionsTest::whatWasDismissedIsSilentUntilItsLinkIsWell()
{
    Notices notices;
    const auto standing = [&notices](Ailment ailment) {
        LinkView link;
        link.address = link.name = "can0";
        link.state = LinkState::Open;
        if (ailment != Ailment::None)
            link.diagnosis = {ailment, say("%1 is not well", "can0"), {}, {}};
        notices.workbench.shot.links = {link};
        notices.follow();
        return notices.stack.count();
    };
    QCOMPARE(standing(Ailment::Losing), 1);
    Q_EMIT notices.standing().dismissed();
    for (int passing = 0; passing < 2; ++passing) {
        QCOMPARE(standing(Ailment::Disturbed), 1);
        QCOMPARE(standing(Ailment::Losing), 0);
    }
    QCOMPARE(standing(Ailment::None), 0);
    QCOMPARE(standing(Ailment::Losing), 1);
    notices.workbench.device(0).identity.edit().state = DeviceState::Duplicate;
    QCOMPARE(standing(Ailment::None), 1);
    Q_EMIT notices.standing().dismissed();
    notices.workbench.device(0).liveness.foreignMaster = true;
    QCOMPARE(standing(Ailment::None), 1);
    Q_EMIT notices.standing().dismissed();
    QCOMPARE(standing(Ailment::None), 0);
    notices.workbench.device(0).liveness.foreignMaster = false;
    QCOMPARE(standing(Ailment::None), 0);
    notices.workbench.device(0).liveness.foreignMaster = true; // of a new motion
    QCOMPARE(standing(Ailment::None), 1);
}

void ConditionsTest::aLinkThatIsLostOnceMoreIsSaidOnceMore()
{
    Notices notices;
    const auto standing = [&notices](LinkState state, Ailment ailment) {
        LinkView link;
        link.address = link.name = "can0";
        link.state = state;
        link.diagnosis = {ailment, say("%1 is not well", "can0"), {}, {}};
        notices.workbench.shot.links = {link};
        notices.follow();
        return notices.stack.count();
    };
    QCOMPARE(standing(LinkState::Open, Ailment::Losing), 1);
    Q_EMIT notices.standing().dismissed();
    for (int loss = 0; loss < 2; ++loss) {
        QCOMPARE(standing(LinkState::Lost, Ailment::Down), 1);
        QCOMPARE(notices.standing().cause(), QStringLiteral("can0 is lost"));
        Q_EMIT notices.standing().dismissed();
        QCOMPARE(standing(LinkState::Lost, Ailment::Down), 0);
        QCOMPARE(standing(LinkState::Open, Ailment::Losing), 0);
    }
}

void ConditionsTest::aSecondEnterIsNotForWhatTheButtonHasBecome()
{
    Notices notices;
    EnterKey enter;
    qApp->installEventFilter(&enter);
    auto &profile = notices.workbench.device(0).profile.edit();
    profile.written["slot0.p"] = 1;
    profile.lost.insert("slot0.p");
    notices.follow();
    QPushButton *action = nullptr;
    for (QPushButton *button : notices.standing().findChildren<QPushButton *>())
        action = button->text() == QLatin1String("Write them again") ? button : action;
    QVERIFY(action);
    QApplication::setActiveWindow(&notices.stack);
    action->setFocus();
    QTest::keyClick(action, Qt::Key_Return);
    QTRY_COMPARE(notices.workbench.given<orders::RewriteSettings>().size(), std::size_t{1});
    QApplication::setDoubleClickInterval(60'000);
    OperationView operation;
    operation.id = {3};
    operation.device = {1};
    operation.status.kind = OperationKind::RewriteSettings;
    notices.workbench.shot.operations = {operation};
    notices.follow();
    QCOMPARE(action->text(), QStringLiteral("Cancel"));
    QTest::keyClick(action, Qt::Key_Return);
    QCoreApplication::processEvents();
    QVERIFY(notices.workbench.given<orders::CancelOperation>().empty());
    action->click(); // later
    QCOMPARE(notices.workbench.given<orders::CancelOperation>().size(), std::size_t{1});
}

void ConditionsTest::gainsThatAreOwedMayBeKeptAsTheyAre()
{
    Notices notices;
    tuning::OwedGains owed;
    owed.trial = 41;
    notices.workbench.owed[{1}] = {owed};
    notices.follow();
    const auto click = [&notices](const char *name) {
        for (QPushButton *button : notices.standing().findChildren<QPushButton *>()) {
            if (button->isVisible() && button->text() == QLatin1String(name))
                button->click();
        }
    };
    click("Put them back");
    QCOMPARE(notices.workbench.given<orders::PayGains>().size(), std::size_t{1});
    QVERIFY(notices.workbench.given<orders::DismissGains>().empty());
    click("Keep what it has");
    const auto kept = notices.workbench.given<orders::DismissGains>();
    QCOMPARE(kept.size(), std::size_t{1});
    QVERIFY(kept.front().device == DeviceId{1} && kept.front().trial == 41);
    QCOMPARE(notices.workbench.given<orders::PayGains>().size(), std::size_t{1});
}

void ConditionsTest::gainsThatAreOwedToAPlaceAreSaidToBeSo()
{
    Notices notices;
    tuning::OwedGains owed;
    for (const bool isPlace : {true, false}) {
        owed.unit = isPlace ? "place usb-1.2 supermodified:4" : "dmc60c 210334000001";
        notices.workbench.owed[{1}] = {owed};
        notices.follow();
        QCOMPARE(notices.standing().accessibleDescription().startsWith(QStringLiteral("this place, not this unit")),
            isPlace);
    }
}

MB_WINDOW_TEST(ConditionsTest);
#include "tst_conditions.moc"
