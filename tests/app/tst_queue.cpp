// SPDX-License-Identifier: GPL-3.0-or-later
// The queue of the page Firmware and the armed station in the real window, on simulated controllers.
#include "support/windowtests.h"
#include "windowbench.h"

#include "app/productionface.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/segmented.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/queuebar.h"
#include "widgets/firmware/queueboard.h"
#include "widgets/firmware/queuemodel.h"
#include "widgets/firmware/unitsteps.h"
#include "widgets/firmware/updatelog.h"
#include "widgets/report/reportspage.h"
#include "widgets/service/counttiles.h"
#include "widgets/service/productionpage.h"
#include "widgets/service/verdictview.h"

#include <QFile>
#include <QListWidget>
#include <QTemporaryDir>

using namespace mb;
using namespace mb::test;
using service::RowState;

namespace {

constexpr int longPatience = 120000; // three updates in real time on a busy computer

struct QueueWindow : WindowBench {
    using WindowBench::WindowBench;
    QTemporaryDir folder;

    [[nodiscard]] QueueBoard &board()
    {
        auto &page = this->page<FirmwarePage>(PageId::Firmware);
        page.showQueue(true);
        return page.queue();
    }
    [[nodiscard]] const QueueLine *line(int address)
    {
        for (const QueueLine &line : board().model().lines()) {
            if (device(address) && line.device == device(address)->id)
                return &line;
        }
        return nullptr;
    }
    [[nodiscard]] bool is(int address, RowState state)
    {
        const QueueLine *found = line(address);
        return found && found->row != 0 && found->state == state;
    }
    void power(int address, bool on)
    {
        engine().post([name = "dmc60c:" + std::to_string(address), on](EngineCore &core) {
            for (const Link *link : core.session().links()) {
                for (Simulator *unit : core.session().bench(*link)->simulators()) {
                    if (unit->name() == name)
                        unit->setPowered(on);
                }
            }
        });
    }
    /// Units of the queue that are done with, one way or another.
    [[nodiscard]] int ended()
    {
        const QStringList figures = part<CountTiles>().texts();
        int sum = 0;
        for (const QString &outcome : {figures.at(0), figures.at(1), figures.at(2)}) // passed, failed, refused
            sum += outcome.section(QLatin1Char(' '), 0, 0).toInt();
        return sum;
    }
    [[nodiscard]] QString write(const QByteArray &recipe)
    {
        QFile file(folder.filePath(QStringLiteral("recipe.json")));
        return file.open(QIODevice::WriteOnly) && file.write(recipe) > 0 ? file.fileName() : QString();
    }
};

} // namespace

class QueueWindowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void threeUnitsOneOfWhichIsPulledOutInTheMiddle();
    void theHeaderSaysThatAStationIsArmed();
};

void QueueWindowTest::threeUnitsOneOfWhichIsPulledOutInTheMiddle()
{
    QueueWindow bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    QueueBoard &board = bench.board();
    QVERIFY(board.openImage(QStringLiteral(":/firmware/dmc60c-demo.hex")));
    for (const int address : {5, 7, 9})
        board.model().tick(bench.device(address)->id, true);
    QVERIFY(board.canStart());
    board.start();
    QTRY_VERIFY_WITH_TIMEOUT(bench.is(5, RowState::Running) && bench.line(5)->done.value_or(0) > 20, longPatience);
    QVERIFY(!board.canStart());
    bench.power(5, false);
    QTRY_VERIFY_WITH_TIMEOUT(bench.is(5, RowState::Failed), longPatience);
    bench.power(5, true);
    QTRY_VERIFY_WITH_TIMEOUT(bench.is(7, RowState::Running) && bench.line(7)->done.value_or(0) > 10, longPatience);
    board.bar().cancel().click(); // it stays in its bootloader, and the journal knows
    QTRY_VERIFY_WITH_TIMEOUT(!board.bar().cancel().isEnabled(), longPatience);
    QVERIFY(!bench.is(7, RowState::Passed));
    QTRY_VERIFY_WITH_TIMEOUT(board.mayGoOn(), patience);
    board.goOn();
    QTRY_VERIFY_WITH_TIMEOUT(bench.is(7, RowState::Passed) && bench.is(9, RowState::Passed), longPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!board.bar().cancel().isEnabled(), longPatience);
    board.bar().retry().click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.is(5, RowState::Passed), longPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!board.bar().cancel().isEnabled(), longPatience);
    QVERIFY(board.log().count() > 10);
    const QString table = bench.folder.filePath(QStringLiteral("queue.csv"));
    board.save(table);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(table), patience);
    auto &reports = bench.page<ReportsPage>(PageId::Reports);
    reports.setFilter(ReportsPage::Journal);
    QTRY_VERIFY_WITH_TIMEOUT(reports.list().count() >= 4, patience); // 5 twice: it failed, and passed
}

void QueueWindowTest::theHeaderSaysThatAStationIsArmed()
{
    QueueWindow bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    const QString recipe
        = bench.write(R"({"recipe":1,"name":"turn","family":"dmc60c","test":{"loop":"velocity","to":2000,
"limits":{"travel":20000,"speed":20000,"duty":0.5,"current":40},"accept":{"overshoot":9}}})");
    Lamp &lamp = bench.part<Lamp>();
    bench.window().production().show(true);
    auto &page = bench.part<ProductionPage>();
    page.setSound(false);
    QVERIFY(page.openRecipe(recipe));
    QCOMPARE(lamp.status().state, LampState::Safe);
    page.start();
    QTRY_VERIFY_WITH_TIMEOUT(lamp.status().armable && lamp.status().detail.isEmpty(), patience);
    // What is there before the station is armed waits for that, and goes on by itself.
    const auto says = [&page](const QString &words) { return page.verdict().accessibleDescription().contains(words); };
    QTRY_VERIFY_WITH_TIMEOUT(says(QStringLiteral("waits until the station is armed")), longPatience);
    QVERIFY2(says(QStringLiteral("Hold Arm")), qPrintable(page.verdict().accessibleDescription()));
    QCOMPARE(bench.ended(), 0);
    QVERIFY(!bench.isOutputOn());
    Q_EMIT lamp.armRequested(); // held
    QTRY_COMPARE_WITH_TIMEOUT(lamp.status().state, LampState::Armed, patience);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isOutputOn(), longPatience);
    QTRY_COMPARE_WITH_TIMEOUT(lamp.status().state, LampState::Moving, patience);
    Q_EMIT lamp.disarmRequested();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.isOutputOn(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(
        lamp.status().state != LampState::Armed && lamp.status().state != LampState::Moving, patience);
}

MB_WINDOW_TEST(QueueWindowTest);
#include "tst_queue.moc"
