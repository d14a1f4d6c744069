// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/common/iconbutton.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/steplog.h"
#include "widgets/control/steptable.h"

#include <QTableWidget>
#include <QTest>

#include <random>

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

namespace {

QString s(const char *text)
{
    return QString::fromUtf8(text);
}

constexpr Instant start{100s};

/// A second-order step from 100 to 1100, sampled every 5 ms, with white noise of `sigma` of the step.
std::vector<Point> secondOrder(double damping, double omega, double sigma = 0.0)
{
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, sigma > 0.0 ? sigma : 1.0);
    std::vector<Point> points;
    for (int i = -40; i < 600; ++i) {
        const double t = i * 0.005;
        double z = 0.0;
        if (t > 0.0 && damping < 1.0) {
            const double damped = omega * std::sqrt(1.0 - damping * damping);
            z = 1.0
                - std::exp(-damping * omega * t)
                    * (std::cos(damped * t) + damping * omega / damped * std::sin(damped * t));
        } else if (t > 0.0) {
            z = 1.0 - std::exp(-omega * t) * (1.0 + omega * t);
        }
        points.push_back({start + i * 5ms, 100.0 + 1000.0 * (z + (sigma > 0.0 ? noise(random) : 0.0))});
    }
    return points;
}

} // namespace

class TestSteps : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void metricsMatchTheGoldenValues_data();
    void metricsMatchTheGoldenValues();
    void overshootWithinTheNoiseIsNone();
    void aLoopThatSettlesInTheWrongPlaceSaysSo();
    void aMotorThatDoesNotMoveHasNoNumbers();
    void oneThatNeverSettlesHasNoSettlingTime();
    void aLoopThatSwingsHasNoNumbers();
    void nonsenseInGivesNothingOut();
    void everyStepIsRecordedWithItsGains();
    void aRampedSetPointIsOneStep();
    void holdingThePresentFirstIsPartOfNoStep();
    void aStepThatIsStoppedIsCutShort();
    void whatHappenedBeforeIsNotRecorded();
    void theGainsOfAStepComeBackAsEdits();
};

/// tuning.md 3.11, "Golden (analytic)".
void TestSteps::metricsMatchTheGoldenValues_data()
{
    QTest::addColumn<double>("damping");
    QTest::addColumn<double>("omega");
    QTest::addColumn<double>("rise");
    QTest::addColumn<double>("overshoot");
    QTest::addColumn<double>("settle");
    QTest::newRow("lively") << 0.5 << 15.0 << 0.1092 << 0.1630 << 0.538;
    QTest::newRow("usual") << 0.7 << 15.0 << 0.1417 << 0.0460 << 0.399;
    QTest::newRow("critical") << 1.0 << 20.0 << 0.1679 << 0.0 << 0.292;
}

void TestSteps::metricsMatchTheGoldenValues()
{
    QFETCH(double, damping);
    QFETCH(double, omega);
    QFETCH(double, rise);
    QFETCH(double, overshoot);
    QFETCH(double, settle);
    const auto samples = secondOrder(damping, omega);
    const StepMetrics metrics = measureStep(samples, start, std::nullopt, 1100.0);
    QVERIFY(metrics.moved);
    QVERIFY(std::abs(*metrics.rise / rise - 1.0) < 0.013);
    QVERIFY(std::abs(*metrics.overshoot - overshoot) < 0.001);
    QVERIFY(std::abs(*metrics.settle - settle) <= 0.0051); // one sample
    QVERIFY(std::abs(*metrics.steadyError) < 1e-4);
    if (overshoot > 0.0)
        QVERIFY(std::abs(metrics.peak - (1100.0 + 1000.0 * overshoot)) < 1.5);
}

void TestSteps::overshootWithinTheNoiseIsNone()
{
    const auto samples = secondOrder(1.0, 20.0, 0.004);
    const StepMetrics metrics = measureStep(samples, start, std::nullopt, 1100.0);
    QVERIFY(metrics.noise > 0.003 && metrics.noise < 0.005);
    QVERIFY(*metrics.overshoot < 0.02); // the greatest of many samples, nothing more
    QVERIFY(metrics.band >= 0.02);
    QVERIFY(metrics.settle);
}

void TestSteps::aLoopThatSettlesInTheWrongPlaceSaysSo()
{
    const auto samples = secondOrder(0.7, 15.0);
    const StepMetrics metrics = measureStep(samples, start, std::nullopt, 2100.0); // it gets half way
    QVERIFY(metrics.moved);
    QVERIFY(std::abs(*metrics.steadyError - 0.5) < 1e-3);
    QVERIFY(std::abs(*metrics.overshoot - 0.046) < 0.001); // of where it went
}

void TestSteps::aMotorThatDoesNotMoveHasNoNumbers()
{
    const auto samples = secondOrder(0.7, 15.0);
    const StepMetrics metrics = measureStep(samples, start, std::nullopt, 100000.0);
    QVERIFY(!metrics.moved);
    QVERIFY(!metrics.rise && !metrics.overshoot && !metrics.settle);
    QVERIFY(*metrics.steadyError > 0.98);
}

void TestSteps::oneThatNeverSettlesHasNoSettlingTime()
{
    std::vector<Point> samples;
    for (int i = 0; i < 300; ++i)
        samples.push_back({start + i * 10ms, i * 10.0}); // still on its way at the end
    QVERIFY(!measureStep(samples, start, 0.0, 3000.0).settle);
}

void TestSteps::aLoopThatSwingsHasNoNumbers()
{
    std::vector<Point> samples;
    for (int i = -20; i < 300; ++i)
        samples.push_back({start + i * 10ms, i < 0 ? 0.0 : 1000.0 + i * 10.0 * std::sin(i * 0.3)}); // swings ever wider
    const StepMetrics metrics = measureStep(samples, start, std::nullopt, 1000.0);
    QVERIFY(metrics.unsteady);
    QVERIFY(!metrics.rise && !metrics.overshoot && !metrics.settle && !metrics.steadyError);
}

void TestSteps::nonsenseInGivesNothingOut()
{
    const auto samples = secondOrder(0.7, 15.0);
    QVERIFY(!measureStep({}, start, std::nullopt, 1.0).moved);
    QVERIFY(!measureStep(samples, start, 5.0, 5.0).moved);                                  // no step
    QVERIFY(!measureStep(std::span(samples).first(42), start, std::nullopt, 1100.0).moved); // too few
    std::vector<Point> gaps(20, Point{start, std::numeric_limits<double>::quiet_NaN()});
    QVERIFY(!measureStep(gaps, start, 0.0, 1.0).moved);
}

namespace {

/// The drive as a snapshot tells of it while a velocity is commanded.
struct Commanded {
    Recording recording{Instant(1000s)};
    DeviceView device = tunableDrive(recording.telemetry());
    StepLog log;

    Commanded()
    {
        recording.run(0.5, 0.0);
        log.follow(device, recording.now());
        recording.setCommanded(true);
        device.motion.running = true;
        device.motion.setPoint.mode = Mode::Velocity;
    }
    void run(double seconds, double target)
    {
        recording.run(seconds, target);
        log.follow(device, recording.now());
    }
};

} // namespace

void TestSteps::everyStepIsRecordedWithItsGains()
{
    Commanded drive;
    drive.run(4.0, 60000.0);
    drive.device.parameters[named("slot0.p").value].raw = 65536;
    drive.run(4.0, 20000.0);
    QCOMPARE(drive.log.records().size(), 2U);
    const StepRecord &first = drive.log.records()[0];
    QVERIFY(first.finished && !first.cut);
    QCOMPARE(first.from, 0.0);
    QCOMPARE(first.to, 60000.0);
    QCOMPARE(*first.gains[0], rawOf("slot0.p", 1.165));
    QVERIFY(first.metrics.moved);
    QVERIFY(std::abs(*first.metrics.overshoot - 0.068) < 0.01); // of damping 0.65
    QVERIFY(first.peakCurrent > 10.0);
    const StepRecord &second = drive.log.records()[1];
    QCOMPARE(second.from, 60000.0);
    QCOMPARE(second.to, 20000.0);
    QCOMPARE(*second.gains[0], 65536);
    QVERIFY(second.metrics.moved);
}

void TestSteps::aRampedSetPointIsOneStep()
{
    Commanded drive;
    for (int i = 1; i <= 25; ++i)
        drive.run(0.02, i * 2000.0);
    drive.run(4.0, 50000.0);
    QCOMPARE(drive.log.records().size(), 1U);
    QCOMPARE(drive.log.records()[0].to, 50000.0);
    QVERIFY(std::abs(drive.log.records()[0].ramp - 0.48) < 0.021);
}

void TestSteps::holdingThePresentFirstIsPartOfNoStep()
{
    Commanded drive;
    drive.run(0.02, 0.0);
    const Instant before = drive.recording.now();
    drive.run(4.0, 50000.0);
    QCOMPARE(drive.log.records().size(), 1U);
    QCOMPARE(drive.log.records()[0].ramp, 0.0);
    QVERIFY(drive.log.records()[0].begin == before);
}

void TestSteps::aStepThatIsStoppedIsCutShort()
{
    Commanded drive;
    drive.run(0.6, 60000.0);
    drive.recording.setCommanded(false);
    drive.device.motion.running = false;
    drive.run(1.0, 0.0);
    QCOMPARE(drive.log.records().size(), 1U);
    QVERIFY(drive.log.records()[0].finished);
    QVERIFY(drive.log.records()[0].cut);
    drive.recording.setCommanded(true); // and again: a new one
    drive.device.motion.running = true;
    drive.run(4.0, 60000.0);
    QCOMPARE(drive.log.records().size(), 2U);
    QCOMPARE(drive.log.records()[1].number, 2);
}

void TestSteps::whatHappenedBeforeIsNotRecorded()
{
    Recording recording{Instant(1000s)};
    recording.setCommanded(true);
    recording.run(4.0, 60000.0);
    DeviceView device = tunableDrive(recording.telemetry());
    StepLog log;
    log.follow(device, recording.now());
    recording.run(4.0, 60000.0);
    device.motion.setPoint.mode = Mode::Velocity;
    device.motion.running = true;
    log.follow(device, recording.now());
    QVERIFY(log.records().empty() || !log.records()[0].metrics.moved);
}

void TestSteps::theGainsOfAStepComeBackAsEdits()
{
    TuneBench bench;
    bench.pass(0.5, 0.0);
    bench.arm();
    SetPoint setPoint;
    setPoint.mode = Mode::Velocity;
    setPoint.target = 60000.0;
    bench.arming.run(setPoint);
    bench.confirmMotion();
    bench.recording.setCommanded(true);
    for (int i = 0; i < 40; ++i)
        bench.pass(0.1, 60000.0);
    auto *table = bench.find<QTableWidget>("Steps of this session");
    QCOMPARE(table->rowCount(), 1);
    QCOMPARE(table->item(0, 0)->text(), s("#1"));
    bench.device().parameters[named("slot0.p").value].raw = 65536;
    ++bench.device().parameterRevision;
    bench.workbench.publish();
    QVERIFY(bench.page->gainsPanel().toWrite().empty());
    table->selectRow(0);
    for (auto *button : bench.page->findChildren<CommandButton *>()) {
        if (button->text() == s("Use these gains"))
            button->click();
    }
    const auto changes = bench.page->gainsPanel().toWrite();
    QCOMPARE(changes.size(), 1U);
    QCOMPARE(changes[0].raw, rawOf("slot0.p", 1.165));
    QVERIFY(bench.workbench.callsOf("writeParameters").empty());
}

MB_WINDOW_TEST(TestSteps);
#include "tst_steps.moc"
