// SPDX-License-Identifier: GPL-3.0-or-later
// A speed loop of a drive that cannot be read back, tuned by hand in the real window on a simulated motor.
#include "windowbench.h"

#include "support/windowtests.h"
#include "widgets/control/gainrow.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/triallist.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tunepage.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

using namespace mb;
using namespace mb::test;

class HandTuningTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void theInspectorTakesWhatOnlyTheUserKnows();
    void aSluggishLoopIsTunedUntilItStepsWell();
    void cleanupTestCase() { m_bench.reset(); }

private:
    [[nodiscard]] const DeviceView *drive() const { return m_bench->device(3, "abstractdc"); }
    void type(const char *name, const char *text);
    void picture(const char *name);
    tuning::Trial step(double p, double i);

    std::unique_ptr<WindowBench> m_bench;
    double m_latest = 0.0; ///< s, of the last step
};

void HandTuningTest::initTestCase()
{
    m_bench = std::make_unique<WindowBench>();
    QTRY_VERIFY_WITH_TIMEOUT(m_bench->isFound(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(drive()->mayNotMove.empty(), patience);
    m_bench->window().selection().select(drive()->id);
}

void HandTuningTest::type(const char *name, const char *text)
{
    const QString wanted = QString::fromUtf8(name);
    for (QLineEdit *field : m_bench->window().findChildren<QLineEdit *>()) {
        if (field->accessibleName() != wanted || !field->isVisible())
            continue;
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QString::fromUtf8(text));
        QTest::keyClick(field, Qt::Key_Return);
        return;
    }
    QFAIL(name);
}

/// For people who want to look: MOTORBENCH_PICTURES names a folder.
void HandTuningTest::picture(const char *name)
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (!folder.isEmpty())
        QVERIFY(m_bench->window().grab().save(folder + QLatin1Char('/') + QLatin1String(name)));
}

void HandTuningTest::theInspectorTakesWhatOnlyTheUserKnows()
{
    QTest::qWait(200);
    type("Counts per revolution", "48");
    QTRY_COMPARE_WITH_TIMEOUT(drive()->profile->calibrated(countsPerRevolutionKey), 48.0, patience);
    type("Ampere per count", "0,05");
    QTRY_COMPARE_WITH_TIMEOUT(drive()->profile->calibrated("amperes_per_count"), 0.05, patience);
    const auto current = drive()->telemetry->find("current");
    QVERIFY(drive()->telemetry->channels()[current->value].unit == "A");
    QVERIFY(drive()->identity->dialect == "F");
}

/// Types the gains, presses the one key, and yields what the page then shows as B.
tuning::Trial HandTuningTest::step(double p, double i)
{
    auto &page = m_bench->page<TunePage>(PageId::Tune);
    const auto text = [](double number) { return QByteArray::number(number, 'f', 0); };
    const auto waited = [&](auto condition) { return QTest::qWaitFor(condition, patience); };
    type("P", text(p));
    type("I", text(i));
    const std::int64_t before = page.trials().b() ? page.trials().b()->number : 0;
    if (!waited([&] { return drive()->mayNotMove.empty() && drive()->liveness.heard; }))
        qWarning("it may not be armed");
    m_bench->arming().arm(drive()->id);
    if (!waited([&] { return page.status().mayRun; }))
        qWarning("%s: %s", qPrintable(page.status().cause), qPrintable(page.status().remedy));
    page.setFocus();
    std::optional<double> late; // s from the last set-point of the hold to its metrics
    const auto listening = connect(&page.trials(), &TrialsView::changed, &page, [this, &page, &late, before] {
        if (late || !m_bench->arming().isOnTrial() || !page.trials().b() || page.trials().b()->number <= before)
            return;
        const auto channel = *drive()->telemetry->find("setpoint");
        const Instant now = m_bench->engine().now();
        Instant held{};
        drive()->telemetry->forEach(channel, now - std::chrono::seconds(10), now, [&held](const Point &point) {
            if (!point.isGap() && point.value > 0.0)
                held = point.time;
        });
        late = std::chrono::duration<double>(now - held).count();
    });
    QTest::keyClick(&page, Qt::Key_F5);
    const auto isMeasured = [&] { return page.trials().b() && page.trials().b()->number > before; };
    if (!waited(isMeasured) || !waited([&] { return !m_bench->arming().isOnTrial(); }))
        qWarning("no trial came back");
    disconnect(listening);
    qInfo("metrics stand in the window %.0f ms after the hold has ended", late.value_or(-1.0) * 1e3);
    m_latest = late.value_or(1e9);
    picture(p < 10000.0 ? "tune-before.png" : "tune-after.png");
    return page.trials().b() ? page.trials().b()->trial : tuning::Trial();
}

void HandTuningTest::aSluggishLoopIsTunedUntilItStepsWell()
{
    auto &page = m_bench->page<TunePage>(PageId::Tune);
    QTRY_VERIFY_WITH_TIMEOUT(page.column().gainsPanel().row(Role::Proportional) != nullptr, patience);
    StimulusChoice stimulus;
    stimulus.to = 5000.0;
    page.form().chooseStimulus(Mode::Velocity, stimulus);
    std::optional<Result<void>> written;
    m_bench->engine().send(orders::WriteParameters{drive()->id,
                               {{*findParameter(drive()->family->parameters, "velocity.divisor"), 1'000'000}}},
        [&written](const Result<void> &result) { written = result; });
    QTRY_VERIFY_WITH_TIMEOUT(written.has_value(), patience); // until then the drive is busy
    QVERIFY2(written->has_value(), written->has_value() ? "" : written->error().text().c_str());
    const tuning::Trial sluggish = step(2000.0, 60.0);
    const tuning::Trial tuned = step(17700.0, 300.0);
    QVERIFY(sluggish.reason == tuning::EndReason::Done);
    QVERIFY(tuned.reason == tuning::EndReason::Done);
    const auto number = [](const std::optional<double> &value) { return value.value_or(-1.0); };
    qInfo("rise %.3f s -> %.3f s, steady error %.1f %% -> %.1f %%, overshoot %.1f %% -> %.1f %%",
        number(sluggish.metrics.rise), number(tuned.metrics.rise), number(sluggish.metrics.sse) * 100.0,
        number(tuned.metrics.sse) * 100.0, number(sluggish.metrics.overshoot) * 100.0,
        number(tuned.metrics.overshoot) * 100.0);
    QVERIFY(tuned.metrics.sse && std::abs(*tuned.metrics.sse) < 0.06);
    QVERIFY(sluggish.metrics.sse);
    QVERIFY(std::abs(*tuned.metrics.sse) < std::abs(*sluggish.metrics.sse) / 2.0);
    QVERIFY(tuned.metrics.overshoot && *tuned.metrics.overshoot < 0.15);
    QVERIFY(tuned.simulated);
    QVERIFY(m_latest <= 0.3);
    QVERIFY(page.trials().a() && page.trials().isComparable());                      // the one before, beside it
    QTRY_COMPARE_WITH_TIMEOUT(page.trials().list().model().rowCount(), 2, patience); // and both are kept
}

MB_WINDOW_TEST(HandTuningTest);
#include "tst_handtuning.moc"
