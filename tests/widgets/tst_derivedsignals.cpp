// SPDX-License-Identifier: GPL-3.0-or-later
// Signals by formulas: whose samples they are computed from, whatever comes, goes and is renumbered.
#include "plotbench.h"
#include "support/windowtests.h"
#include "widgets/common/devicetext.h"

using namespace mb;
using namespace mb::test;

class TestDerivedSignals : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void goesOnWhereItsDeviceBeginsAnew();
    void isMarkedAndTimedAsWhatItIsMadeOf();
    void staysWithItsDeviceThoughAnotherLinkHasOneOfTheSameNumber();
    void followsAUnitThatGetsAnotherNumber();
    void namesNeitherOfTwoUnitsByANumberThatBothHave();
};

void TestDerivedSignals::goesOnWhereItsDeviceBeginsAnew()
{
    PlotBench bench;
    bench.pass(1.0, 60000.0);
    QVERIFY(bench.board().addDerived(s("twice"), s("counts/s"), s("2 * d5_velocity")));
    bench.pass(0.5, 60000.0);
    QTRY_VERIFY(bench.trace("twice").source->telemetry().size({0}) > 100);
    Recording anew{bench.workbench.time}; // as after a jump in a recording
    bench.workbench.shot.devices[0].telemetry = anew.telemetry();
    anew.run(1.0, 60000.0);
    bench.workbench.publish();
    bench.pass(0.1, 60000.0);
    QTRY_COMPARE(bench.trace("twice").source->telemetry().size({0}), std::size_t{100});
    DeviceView again = bench.workbench.shot.devices[0]; // as after its link was opened again
    Recording third{bench.workbench.time};
    again.telemetry = third.telemetry();
    again.id = {3};
    bench.workbench.shot.devices.erase(bench.workbench.shot.devices.begin());
    bench.workbench.publish();
    third.run(0.5, 60000.0);
    bench.workbench.shot.devices.push_back(again);
    bench.workbench.publish();
    bench.pass(0.1, 60000.0);
    QTRY_COMPARE(bench.trace("twice").source->telemetry().size({0}), std::size_t{50});
}

void TestDerivedSignals::isMarkedAndTimedAsWhatItIsMadeOf()
{
    PlotBench bench;
    LinkView link;
    link.address = link.name = bench.workbench.device(0).link;
    link.simulated = true;
    bench.workbench.shot.links = {link};
    bench.pass(1.0, 60000.0);
    QVERIFY(bench.board().addDerived(s("twice"), s("counts/s"), s("2 * d5_velocity")));
    while (bench.board().traces().size() > 1)
        bench.board().choose(Signal(bench.board().traces().front().signal), false);
    QCOMPARE(bench.board().traces().front().style.name, s("twice"));
    QCOMPARE(bench.stack().strips().watermark(), s("DEMO"));
    bench.workbench.shot.links[0].simulated = false;
    bench.workbench.shot.links[0].replay = ReplayState();
    bench.workbench.shot.links[0].time = bench.workbench.time - std::chrono::hours(24);
    bench.workbench.device(1).link = "socketcan:can0";
    bench.workbench.publish();
    QCOMPARE(bench.board().link(), link.address);
    QVERIFY(bench.board().present() == bench.workbench.shot.links[0].time);
    bench.page->addSignal({{2}, channel("velocity")});
    QCOMPARE(bench.stack().strips().watermark(), s("REPLAY"));
    const auto &rows = bench.page->findChild<TraceList *>()->rows();
    QCOMPARE(rows.size(), std::size_t{2});
    QVERIFY2(
        !rows[0].source.contains(s("another")) && rows[1].source.contains(s("another")), qPrintable(rows[1].source));
}

void TestDerivedSignals::staysWithItsDeviceThoughAnotherLinkHasOneOfTheSameNumber()
{
    PlotBench bench;
    Recording far{bench.workbench.time};
    DeviceView twin = tunableDrive(far.telemetry(), 3, 5);
    twin.selector = "socketcan:can1/dmc60c:5";
    twin.link = "socketcan:can1";
    bench.workbench.shot.devices[0].link = "sim:can";
    bench.workbench.shot.devices.push_back(twin);
    bench.pass(1.0, 60000.0);
    QVERIFY(bench.board().addDerived(s("twice"), s("counts/s"), s("2 * dmc60c5_can_velocity")));
    bench.pass(0.1, 60000.0);
    const DeviceView own = bench.workbench.shot.devices[0];
    bench.workbench.shot.devices.erase(bench.workbench.shot.devices.begin()); // its link was closed
    far.run(1.0, 100.0);
    bench.workbench.publish();
    bench.pass(0.1, 60000.0);
    const SignalBook::Derived &derived = bench.board().book().derived().front();
    QVERIFY(&derived.signal->input(0) == own.telemetry.get());
    bench.workbench.shot.devices.push_back(own); // and is open again, behind the other
    bench.workbench.publish();
    bench.pass(0.1, 60000.0);
    QVERIFY(&derived.signal->input(0) == own.telemetry.get());
}

void TestDerivedSignals::followsAUnitThatGetsAnotherNumber()
{
    PlotBench bench;
    bench.pass(0.5, 60000.0);
    QVERIFY(bench.board().addDerived(s("twice"), s("counts/s"), s("2 * d5_velocity")));
    bench.pass(0.1, 60000.0);
    const auto own = bench.workbench.shot.devices[0].telemetry;
    const auto number = [&bench](std::size_t place, int address) {
        DeviceView &device = bench.workbench.device(place);
        device.identity.edit().address = address;
        device.selector = "sim:can/dmc60c:" + std::to_string(address);
    };
    number(0, 9);
    bench.workbench.publish();
    number(1, 5); // another one has its number now
    bench.pass(0.1, 60000.0);
    const SignalBook::Derived &derived = bench.board().book().derived().front();
    QVERIFY(&derived.signal->input(0) == own.get());
    QCOMPARE(qt(derived.meanings.front().address.device), s("sim:can/dmc60c:9"));
    const DeviceView gone = bench.workbench.shot.devices[0];
    bench.workbench.shot.devices.erase(bench.workbench.shot.devices.begin());
    bench.pass(0.1, 60000.0);
    QVERIFY(&derived.signal->input(0) == own.get()); // what has its old number is not meant
    bench.workbench.shot.devices.push_back(gone);
    bench.pass(0.1, 60000.0);
    QVERIFY(&derived.signal->input(0) == own.get());
}

void TestDerivedSignals::namesNeitherOfTwoUnitsByANumberThatBothHave()
{
    PlotBench bench;
    auto &devices = bench.workbench.shot.devices;
    const auto wrong = [&](const char *formula) { return bench.board().book().whatIsWrong(s("x"), s(formula)); };
    devices[0].link = "socketcan:can0";
    devices[1].link = "socketcan:can1";
    devices[1].identity.edit().address = 5;
    bench.workbench.publish();
    QCOMPARE(wrong("2 * d5_velocity"), s("d5_velocity may be one of dmc60c5_can0_velocity, dmc60c5_can1_velocity"));
    QCOMPARE(wrong("dmc60c5_can0_velocity - dmc60c5_can1_velocity"), QString());
    devices[0].link = "sim:can";
    devices[1].link = "sim:can?seed=2";
    bench.workbench.publish();
    QCOMPARE(wrong("dmc60c5_can_velocity - dmc60c5_can_seed_2_velocity"), QString());
    devices[1].family = findFamily(families(), "abstractdc");
    bench.workbench.publish();
    QCOMPARE(wrong("2 * d5_velocity"), s("d5_velocity may be one of dmc60c5_velocity, abstractdc5_velocity"));
    QVERIFY(bench.board().addDerived(s("twice"), {}, s("2 * dmc60c5_velocity")));
    const SignalBook::Derived &twice = bench.board().book().derived().front();
    QCOMPARE(twice.inputs.front().device, devices[0].id);
}

MB_WINDOW_TEST(TestDerivedSignals);
#include "tst_derivedsignals.moc"
