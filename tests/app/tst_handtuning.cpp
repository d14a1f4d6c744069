// SPDX-License-Identifier: GPL-3.0-or-later
// A speed loop of a drive that cannot be read back, tuned by hand in the real window on a simulated motor.
#include "windowbench.h"

#include "support/windowtests.h"
#include "widgets/control/gainrow.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/steplog.h"
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
    StepRecord step(double p, double i);

    std::unique_ptr<WindowBench> m_bench;
    StepLog m_log;
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
    QTRY_COMPARE_WITH_TIMEOUT(drive()->profile.calibrated(countsPerRevolutionKey), 48.0, patience);
    type("Ampere per count", "0,05");
    QTRY_COMPARE_WITH_TIMEOUT(drive()->profile.calibrated("amperes_per_count"), 0.05, patience);
    const auto current = drive()->telemetry->find("current");
    QVERIFY(drive()->telemetry->channels()[current->value].unit == "A");
    QVERIFY(drive()->identity.dialect == "F");
}

/// Types the gains, writes them, lets the motor step from rest to 5000 counts/s, and says what the step was like.
StepRecord HandTuningTest::step(double p, double i)
{
    auto &page = m_bench->page<TunePage>(PageId::Tune);
    const auto text = [](double number) { return QByteArray::number(number, 'f', 0); };
    type("P", text(p));
    type("I", text(i));
    page.write();
    const auto raw = [this](const char *key) {
        return drive()->parameters[findParameter(drive()->family->parameters, key)->value].raw;
    };
    const auto waited = [&](auto condition) { return QTest::qWaitFor(condition, patience); };
    if (!waited([&] {
            return raw("velocity.p") == static_cast<std::int64_t>(p)
                && raw("velocity.i") == static_cast<std::int64_t>(i);
        }))
        qWarning("the gains were not written");
    m_bench->arming().arm(drive()->id);
    type("Set-point", "5000");
    page.run();
    const std::size_t before = m_log.records().size();
    waited([&] {
        m_log.follow(*drive(), m_bench->engine().now());
        return m_log.records().size() > before
            && m_bench->engine().now() - m_log.records().back().begin > std::chrono::seconds(3);
    });
    picture(p < 10000.0 ? "tune-before.png" : "tune-after.png");
    m_bench->arming().disarm();
    waited([&] {
        m_log.follow(*drive(), m_bench->engine().now());
        return !m_log.records().empty() && m_log.records().back().finished && !drive()->liveness.moving;
    });
    return m_log.records().empty() ? StepRecord{} : m_log.records().back();
}

void HandTuningTest::aSluggishLoopIsTunedUntilItStepsWell()
{
    auto &page = m_bench->page<TunePage>(PageId::Tune);
    QTRY_VERIFY_WITH_TIMEOUT(page.gainsPanel().row("p") != nullptr, patience);
    for (QComboBox *box : page.findChildren<QComboBox *>()) {
        if (box->accessibleName() == QStringLiteral("How fast the set-point moves")) {
            box->setCurrentIndex(0); // at once
            Q_EMIT box->activated(0);
        }
    }
    m_bench->engine().writeParameters(
        drive()->id, {{*findParameter(drive()->family->parameters, "velocity.divisor"), 1'000'000}}, {});
    const StepRecord sluggish = step(2000.0, 60.0);
    QVERIFY(sluggish.metrics.moved);
    const StepRecord tuned = step(17700.0, 300.0);
    QVERIFY(tuned.metrics.moved);
    QVERIFY(!tuned.metrics.unsteady);
    const auto number = [](const std::optional<double> &value) { return value.value_or(-1.0); };
    qInfo("rise %.3f s -> %.3f s, steady error %.1f %% -> %.1f %%, overshoot %.1f %% -> %.1f %%",
        number(sluggish.metrics.rise), number(tuned.metrics.rise), number(sluggish.metrics.steadyError) * 100.0,
        number(tuned.metrics.steadyError) * 100.0, number(sluggish.metrics.overshoot) * 100.0,
        number(tuned.metrics.overshoot) * 100.0);
    QVERIFY(tuned.metrics.steadyError && std::abs(*tuned.metrics.steadyError) < 0.06);
    QVERIFY(sluggish.metrics.steadyError);
    QVERIFY(std::abs(*tuned.metrics.steadyError) < std::abs(*sluggish.metrics.steadyError) / 2.0);
    QVERIFY(tuned.metrics.overshoot && *tuned.metrics.overshoot < 0.15);
}

MB_WINDOW_TEST(HandTuningTest);
#include "tst_handtuning.moc"
