// SPDX-License-Identifier: GPL-3.0-or-later
// While units are served the Arm button never says safe over a motor that a self-test turns, and pressing it ends that test.
#include "support/fakeworkbench.h"
#include "support/windowtests.h"

#include "app/closing.h"
#include "app/stationlamp.h"
#include "model/registry.h"
#include "widgets/common/headerbar.h"
#include "widgets/control/arming.h"

#include <QSignalSpy>
#include <QTest>

using namespace mb;
using namespace mb::test;

class StationLampTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aTestThatGoesOnAfterAFailElsewhereIsShownAndCanBeEnded();
    void aTestWhoseArmingWasTakenBackIsShownUntilItRests();
    void aMotorThatTurnsIsNotHiddenByTheNoticeOfTheNext();
    void aTestThatIsAnnouncedTurnsNothingYet();
    void unitsThatWaitForArmingOrAreAnnouncedSideBySideTurnNothing();
    void whatIsHeldForOneDeviceArmsNoOther();
    void nothingIsArmedWhileTheWindowCloses();
};

namespace {

struct LampBench {
    FakeWorkbench workbench;
    ThemeSource theme{lightTheme()};
    HeaderBar header{theme};
    Arming arming{workbench};
    Closing closing{workbench, arming, header};
    Selection selection;
    StationLamp lamp{workbench, arming, closing, selection, header};

    /// Rows whose units are in their self-test.
    void serveTests(std::size_t count)
    {
        service::QueueRow row;
        row.state = service::RowState::Running;
        row.visit.step = service::Step::Test;
        workbench.serve(std::vector<service::QueueRow>(count, row));
    }
    /// Two devices that can be armed; the first is selected.
    void find()
    {
        for (const std::uint32_t id : {1U, 2U}) {
            DeviceView device;
            device.id = {id};
            device.family = findFamily(families(), "dmc60c");
            device.liveness.heard = true;
            workbench.shot.devices.push_back(device);
        }
        selection.select({1});
        lamp.follow();
    }
    [[nodiscard]] LampState state() { return header.lamp().status().state; }
};

} // namespace

void StationLampTest::aTestThatGoesOnAfterAFailElsewhereIsShownAndCanBeEnded()
{
    LampBench station;
    station.workbench.served.mayTurn = MayTurn::WhatTurns;
    station.serveTests(1);
    QCOMPARE(station.state(), LampState::Moving);
    Q_EMIT station.header.lamp().disarmRequested();
    QCOMPARE(station.workbench.stops.size(), std::size_t{1});
    const auto orders = station.workbench.given<orders::ArmService>();
    QCOMPARE(orders.size(), std::size_t{1});
    QVERIFY(!orders.front().on);
}

void StationLampTest::aTestWhoseArmingWasTakenBackIsShownUntilItRests()
{
    LampBench station;
    station.workbench.served.mayTurn = MayTurn::Nothing;
    station.serveTests(1);
    QCOMPARE(station.state(), LampState::Moving);
}

void StationLampTest::aMotorThatTurnsIsNotHiddenByTheNoticeOfTheNext()
{
    LampBench station;
    station.workbench.served.mayTurn = MayTurn::Every;
    station.workbench.served.announced = 1;
    station.serveTests(2);
    QCOMPARE(station.state(), LampState::Moving);
}

void StationLampTest::aTestThatIsAnnouncedTurnsNothingYet()
{
    LampBench station;
    station.workbench.served.mayTurn = MayTurn::Every;
    station.workbench.served.announced = 1;
    station.serveTests(1);
    QCOMPARE(station.state(), LampState::Armed);
}

void StationLampTest::unitsThatWaitForArmingOrAreAnnouncedSideBySideTurnNothing()
{
    LampBench station;
    station.workbench.served.mayTurn = MayTurn::WhatTurns; // that has ended since
    station.workbench.served.waiting = 1;
    station.serveTests(1);
    QCOMPARE(station.state(), LampState::Safe);
    station.workbench.served.mayTurn = MayTurn::Every;
    station.workbench.served.waiting = 0;
    station.workbench.served.announced = 2;
    station.serveTests(2);
    QCOMPARE(station.state(), LampState::Armed);
}

void StationLampTest::whatIsHeldForOneDeviceArmsNoOther()
{
    LampBench station;
    station.find();
    Lamp &button = station.header.lamp();
    QVERIFY(button.status().armable);
    const QSignalSpy holding(&button, &Lamp::holdingChanged);
    button.hold();
    station.lamp.follow();
    QCOMPARE(holding.size(), 1);
    station.selection.select({2});
    station.lamp.follow();
    QCOMPARE(holding.size(), 2);
    QCOMPARE(button.holdProgress(), 0.0);
}

void StationLampTest::nothingIsArmedWhileTheWindowCloses()
{
    LampBench station;
    station.find();
    station.workbench.shot.devices.front().motion.running = true;
    QVERIFY(!station.closing.mayClose());
    station.workbench.shot.devices.front().motion = {};
    station.workbench.shot.devices.front().stopsMotion = true;
    station.workbench.publish();
    station.lamp.follow();
    Lamp &button = station.header.lamp();
    QVERIFY(!button.status().armable);
    const QSignalSpy holding(&button, &Lamp::holdingChanged);
    button.hold();
    QCOMPARE(holding.size(), 0);
}

MB_WINDOW_TEST(StationLampTest);
#include "tst_stationlamp.moc"
