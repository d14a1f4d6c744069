// SPDX-License-Identifier: GPL-3.0-or-later
// A board that keeps nothing and tells little, in the real window against the simulated one.
#include "windowbench.h"

#include "support/windowtests.h"
#include "widgets/common/banner.h"
#include "widgets/common/holdbutton.h"
#include "widgets/connection/experimentdialog.h"

#include <QComboBox>
#include <QDir>
#include <QPointer>
#include <QPushButton>

using namespace mb;
using namespace mb::test;

namespace {

constexpr auto boardFamily = "quadquad2drv";

} // namespace

class BoardTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup() { m_bench.reset(); }
    void aResetIsToldAndAClickWritesTheSettingsAgain();
    void writingAgainCanBeCancelled();
    void anExperimentThatMovesNeedsAHeldButtonAndEndsWithItsDialog();
    void anExperimentKeepsWhatItFound();
    void gainScalesAreFoundInRealTimeToo();
    void readingsAreChosenInTheInspector();

private:
    [[nodiscard]] const DeviceView *board() { return m_bench->device(0, boardFamily); }
    [[nodiscard]] std::size_t lost() { return board()->profile->lost.size(); }
    /// Settings that are not the board's own, and then a power cycle.
    void writeAndReset(std::size_t settings);
    [[nodiscard]] ExperimentDialog *openExperiment(const char *key);
    [[nodiscard]] Banner *banner(const QString &words);
    [[nodiscard]] static QPushButton *button(const QWidget &in, const QString &text);
    static void saveDialog(QWidget &dialog, const char *name);
    /// Saved in the folder that MOTORBENCH_PICTURES names, in both themes and two sizes, with fonts scaled by
    /// MOTORBENCH_FONT_SCALE.
    void picture(const char *name);

    std::unique_ptr<WindowBench> m_bench;
};

void BoardTest::init()
{
    const double scale = qEnvironmentVariable("MOTORBENCH_FONT_SCALE").toDouble();
    m_bench = std::make_unique<WindowBench>(scale > 0.0 ? scale : 1.0);
    QTRY_VERIFY_WITH_TIMEOUT(board() && board()->liveness.heard, patience);
    m_bench->window().selection().select(board()->id);
}

void BoardTest::writeAndReset(std::size_t settings)
{
    std::vector<ParameterChange> changes;
    const auto table = board()->family->parameters;
    for (std::uint16_t i = 0; i < table.size() && changes.size() < settings; ++i) {
        if (table[i].access == Access::WriteOnly && table[i].key.find(".velocity.") != std::string_view::npos)
            changes.push_back({{i}, 120});
    }
    QCOMPARE(changes.size(), settings);
    bool written = false;
    m_bench->engine().send(orders::WriteParameters{board()->id, changes},
        [&written](const Result<void> &result) { written = result.has_value(); });
    QTRY_VERIFY_WITH_TIMEOUT(written, patience);
    m_bench->engine().post([](EngineCore &core) {
        for (const Link *link : core.session().links()) {
            for (Simulator *unit : core.session().bench(*link)->simulators()) {
                if (unit->name() != "quadquad2drv:0")
                    continue;
                unit->setPowered(false);
                unit->setPowered(true);
            }
        }
    });
    QTRY_COMPARE_WITH_TIMEOUT(lost(), settings, patience);
}

Banner *BoardTest::banner(const QString &words)
{
    for (Banner *candidate : m_bench->window().findChildren<Banner *>()) {
        if (candidate->isVisible() && candidate->cause().contains(words))
            return candidate;
    }
    return nullptr;
}

QPushButton *BoardTest::button(const QWidget &in, const QString &text)
{
    for (QPushButton *candidate : in.findChildren<QPushButton *>()) {
        if (candidate->isVisibleTo(&in) && candidate->text().contains(text))
            return candidate;
    }
    return nullptr;
}

void BoardTest::saveDialog(QWidget &dialog, const char *name)
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (!folder.isEmpty())
        dialog.grab().save(QDir(folder).filePath(QLatin1String(name) + QStringLiteral(".png")));
}

void BoardTest::picture(const char *name)
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (folder.isEmpty())
        return;
    MainWindow &window = m_bench->window();
    for (const QSize size : {QSize(1280, 800), QSize(3840, 2160)}) {
        window.resize(size);
        for (const char *theme : {"dark", "light"}) {
            QTest::qWait(300);
            window.grab().save(QDir(folder).filePath(
                QStringLiteral("%1-%2-%3.png").arg(QLatin1String(name), QLatin1String(theme)).arg(size.width())));
            QTest::keyClick(&window, Qt::Key_T, Qt::ControlModifier);
        }
    }
    window.resize(1280, 800);
    QTest::qWait(300);
}

void BoardTest::aResetIsToldAndAClickWritesTheSettingsAgain()
{
    writeAndReset(12);
    m_bench->window().showPage(PageId::Parameters);
    QTRY_VERIFY_WITH_TIMEOUT(banner(QStringLiteral("was reset: 12 settings")), patience);
    picture("board-reset");
    const auto gain = findParameter(board()->family->parameters, "ch1.velocity.p").value();
    QVERIFY(!(*board()->parameters)[gain.value].raw);
    QPushButton *again = button(*banner(QStringLiteral("was reset")), QStringLiteral("Write them again"));
    QVERIFY(again);
    const auto idle = [this] {
        const OperationView *last = m_bench->engine().snapshot().operation(board()->id);
        return !last || last->status.state != OperationStatus::State::Running;
    };
    QTRY_VERIFY_WITH_TIMEOUT(idle(), patience);
    again->click();
    QTRY_COMPARE_WITH_TIMEOUT(lost(), std::size_t{0}, patience);
    QTRY_VERIFY_WITH_TIMEOUT(!banner(QStringLiteral("was reset")), patience);
    QTRY_VERIFY_WITH_TIMEOUT((*board()->parameters)[gain.value].raw == 120, patience);
    QVERIFY((*board()->parameters)[gain.value].state == ParameterState::Assumed);
}

void BoardTest::writingAgainCanBeCancelled()
{
    writeAndReset(12);
    QTRY_VERIFY_WITH_TIMEOUT(banner(QStringLiteral("was reset: 12 settings")), patience);
    const auto running = [this] { return banner(QStringLiteral("Writing the settings of")); };
    const auto idle = [this] {
        const OperationView *last = m_bench->engine().snapshot().operation(board()->id);
        return !last || last->status.state != OperationStatus::State::Running;
    };
    QTRY_VERIFY_WITH_TIMEOUT(idle(), patience);
    button(*banner(QStringLiteral("was reset")), QStringLiteral("Write them again"))->click();
    const DeviceId id = board()->id;
    m_bench->engine().post([id](EngineCore &core) { // before it has ended, which on a simulated board is at once
        for (const OperationView &job : core.snapshot().operations) {
            if (job.device == id && job.status.state == OperationStatus::State::Running)
                core.send(orders::CancelOperation{job.id});
        }
    });
    QTRY_VERIFY_WITH_TIMEOUT(!running(), patience);
    QVERIFY(lost() > 0);
    QTRY_VERIFY_WITH_TIMEOUT(banner(QStringLiteral("was reset")), patience);
}

ExperimentDialog *BoardTest::openExperiment(const char *key)
{
    m_bench->window().showPage(PageId::Overview);
    auto *open = m_bench->window().findChild<QPushButton *>(QString::fromLatin1(key));
    if (!open)
        return nullptr;
    open->click();
    return m_bench->window().findChild<ExperimentDialog *>();
}

void BoardTest::anExperimentThatMovesNeedsAHeldButtonAndEndsWithItsDialog()
{
    m_bench->window().showPage(PageId::Overview);
    picture("board-inspector");
    QPointer<ExperimentDialog> dialog = openExperiment("gain-scales");
    QVERIFY(dialog);
    auto *begin = dialog->findChild<HoldButton *>(QStringLiteral("beginExperiment"));
    QVERIFY(begin && begin->isHoldNeeded());
    begin->click();
    QTest::qWait(50);
    QVERIFY2(!dialog->isRunning(), "a click is not enough");
    begin->setHoldMilliseconds(100);
    QTest::mousePress(begin, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(dialog->isRunning(), patience);
    QTest::mouseRelease(begin, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_bench->isOutputOn(), patience);
    QTest::qWait(1500); // longer than the lease, which the dialog renews
    QVERIFY(dialog->isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(m_bench->arming().status(board()->id).state == LampState::Moving, patience);
    saveDialog(*dialog, "experiment-running");
    dialog->reject();
    QTRY_VERIFY_WITH_TIMEOUT(!m_bench->isOutputOn(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(
        m_bench->engine().snapshot().operation(board()->id)->status.state == OperationStatus::State::Cancelled,
        patience);
    QVERIFY(board()->profile->calibration.empty());
}

void BoardTest::anExperimentKeepsWhatItFound()
{
    QPointer<ExperimentDialog> dialog = openExperiment("input-reading");
    QVERIFY(dialog);
    saveDialog(*dialog, "experiment-input");
    auto *begin = dialog->findChild<HoldButton *>(QStringLiteral("beginExperiment"));
    QVERIFY(begin && !begin->isHoldNeeded());
    begin->click();
    QTRY_VERIFY_WITH_TIMEOUT(dialog->result().contains(QStringLiteral("Found")), patience);
    saveDialog(*dialog, "experiment-found");
    QTRY_VERIFY_WITH_TIMEOUT(board()->profile->calibration.contains("input_reading"), patience);
    QCOMPARE(board()->profile->calibrated("input_reading", -1.0), 0.0);
    dialog->close();
}

/// On virtual time it is held to its tolerance (test_quadquad2drv_scales); here threads and sockets have their say.
void BoardTest::gainScalesAreFoundInRealTimeToo()
{
    if (qEnvironmentVariableIsEmpty("MOTORBENCH_SOAK"))
        QSKIP("two minutes of a turning motor; set MOTORBENCH_SOAK");
    QPointer<ExperimentDialog> dialog = openExperiment("gain-scales");
    QVERIFY(dialog);
    dialog->start();
    QTRY_VERIFY_WITH_TIMEOUT(!dialog->isRunning(), 400000);
    saveDialog(*dialog, "experiment-scales");
    QVERIFY2(dialog->result().contains(QStringLiteral("Found")), qPrintable(dialog->result()));
    QTRY_VERIFY_WITH_TIMEOUT(board()->profile->calibration.size() >= 4, patience);
    for (const auto &[key, scale] : board()->profile->calibration)
        qInfo("%s %g", key.c_str(), scale);
    m_bench->window().showPage(PageId::Overview);
    picture("board-scales");
    dialog->close();
}

void BoardTest::readingsAreChosenInTheInspector()
{
    m_bench->window().showPage(PageId::Overview);
    QComboBox *target = nullptr;
    const auto find = [&] {
        for (auto *box : m_bench->window().findChildren<QComboBox *>()) {
            if (box->accessibleName() == QStringLiteral("velocity target"))
                target = box;
        }
        return target != nullptr;
    };
    QTRY_VERIFY_WITH_TIMEOUT(find(), patience);
    QCOMPARE(target->currentIndex(), 0);
    target->setCurrentIndex(1);
    Q_EMIT target->activated(1);
    QTRY_COMPARE_WITH_TIMEOUT(board()->profile->calibrated("velocity_target_shift"), 12.0, patience);
}

MB_WINDOW_TEST(BoardTest);
#include "tst_board.moc"
