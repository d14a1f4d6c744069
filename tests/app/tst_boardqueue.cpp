// SPDX-License-Identifier: GPL-3.0-or-later
// Three boards in the queue of the page Firmware: what hands have to do is shown with its drawing, for one board after the other.
#include "cable.h"
#include "support/windowtests.h"
#include "unitbench.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/iconbutton.h"
#include "widgets/firmware/drawingview.h"
#include "widgets/firmware/queuebar.h"

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

using namespace mb;
using namespace mb::test;
using service::RowState;

namespace {

constexpr int boardPatience = 120000;
constexpr int boardCount = 3;

/// Boards on links of their own, one serial adapter for all, and somebody who does what the page asks for.
class BoardRack {
public:
    BoardRack()
        : bench("quadquad2drv", unitsIn(m_folder))
    {
        applyTheme(*qApp, bench.theme.theme());
        for (int i = 0; i < boardCount; ++i) {
            bench.show({bench.texts.at(static_cast<std::size_t>(i))});
            bench.open(linkOf(i).toStdString());
            const auto here = static_cast<std::size_t>(i) + 1;
            if (!QTest::qWaitFor([&] { return bench.found() == here; }, boardPatience))
                qFatal("no board");
        }
    }
    [[nodiscard]] QString write(const QString &name, const QByteArray &text) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::WriteOnly) && file.write(text) > 0 ? file.fileName() : QString();
    }
    [[nodiscard]] QString recipe() const
    {
        (void)write(QStringLiteral("board.hex"), ":0400000001020304F2\n:0400040005060708DE\n:00000001FF\n");
        return write(QStringLiteral("recipe.json"),
            R"({"recipe":1,"name":"boardCount","family":"quadquad2drv","firmware":{"file":"board.hex","via":"serial:)"
                + QByteArray::fromStdString(m_cable.path()) + "\"}}");
    }
    /// Looks at the page, and does what it asks for.
    void help()
    {
        const auto running = bench.in(RowState::Running);
        mostAtOnce = std::max(mostAtOnce, running.size());
        for (const QueueLine &line : running) {
            const int board = placeOf(line);
            if (line.step.contains(QLatin1String("close the jumper")) && isNew(board, "close", "the jumper connects")) {
                m_cable.plug(lineOf(m_folder, board));
                disturb(board, "jumper", 1.0);
                disturb(board, "reset", 1.0);
            }
            if (line.step.contains(QLatin1String("take the jumper out")) && isNew(board, "open", "is taken out"))
                disturb(board, "jumper", 0.0);
        }
    }

private:
    [[nodiscard]] static std::string lineOf(const QTemporaryDir &folder, int board)
    {
        return folder.filePath(QStringLiteral("boot%1").arg(board)).toStdString();
    }
    [[nodiscard]] static std::vector<std::string> unitsIn(const QTemporaryDir &folder)
    {
        std::vector<std::string> units;
        for (int i = 0; i < boardCount; ++i)
            units.push_back("quadquad2drv:0,boot=pty:" + lineOf(folder, i));
        return units;
    }
    [[nodiscard]] static QString linkOf(int board) { return QStringLiteral("sim:spi?seed=%1").arg(board + 1); }
    [[nodiscard]] int placeOf(const QueueLine &line) const
    {
        const DeviceView *device = bench.engine->snapshot().device(line.device);
        for (int i = 0; device && i < boardCount; ++i) {
            if (QString::fromStdString(device->link) == linkOf(i))
                return i;
        }
        qFatal("whose row is that?");
    }
    /// Once for each time that it is asked for, as soon as the drawing shows it.
    [[nodiscard]] bool isNew(int board, const char *what, const char *drawn)
    {
        const QString entry = QStringLiteral("%1 %2").arg(board).arg(QLatin1String(what));
        const auto *drawing = bench.board().findChild<DrawingView *>();
        if (done.endsWith(entry) || !drawing || drawing->visibleRegion().isEmpty()
            || !drawing->accessibleName().contains(QLatin1String(drawn)))
            return false;
        done += entry;
        const QString pictures = qEnvironmentVariable("MOTORBENCH_PICTURES");
        if (!pictures.isEmpty())
            bench.page->grab().save(QDir(pictures).filePath(QStringLiteral("boards-%1.png").arg(entry)));
        return true;
    }
    void disturb(int board, const char *what, double value)
    {
        bench.engine->post([link = linkOf(board).toStdString(), what, value](EngineCore &core) {
            for (const Link *each : core.session().links()) {
                if (each->address().text() == link)
                    (void)core.session().bench(*each)->simulators().front()->disturb(what, value);
            }
        });
    }

    QTemporaryDir m_folder;
    Cable m_cable;

public:
    UnitBench bench;
    QStringList done; ///< board and what was asked for, in order
    std::size_t mostAtOnce = 0;
};

} // namespace

class BoardQueueTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void threeBoardsAreGuidedOneAfterTheOther();
};

void BoardQueueTest::initTestCase()
{
    QFont font = QApplication::font();
    font.setPointSizeF(10.0);
    QApplication::setFont(font);
}

void BoardQueueTest::threeBoardsAreGuidedOneAfterTheOther()
{
    BoardRack rack;
    QueueBoard &board = rack.bench.board();
    QVERIFY(board.openRecipe(rack.recipe()));
    auto *every = board.findChild<QCheckBox *>();
    QVERIFY(every->isVisible() && every->isEnabled());
    every->click();
    QCOMPARE(board.model().ticked().size(), std::size_t(boardCount));
    QTRY_VERIFY_WITH_TIMEOUT(board.canStart(), boardPatience);
    QTest::mouseClick(&board.bar().start(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(rack.bench.engine->service().running, boardPatience);
    QTRY_VERIFY_WITH_TIMEOUT((rack.help(), !rack.bench.engine->service().running), boardPatience);
    for (const service::QueueRow &row : rack.bench.engine->service().rows)
        QVERIFY2(row.state == RowState::Passed, row.visit.cause.english().c_str());
    QCOMPARE(rack.bench.in(RowState::Passed).size(), std::size_t(boardCount));
    QCOMPARE(rack.mostAtOnce, std::size_t(1)); // one cable, one pair of hands
    QCOMPARE(rack.done.size(), 2 * boardCount);
    for (int i = 0; i < rack.done.size(); i += 2) {
        QVERIFY(rack.done.at(i).endsWith(QLatin1String(" close")));
        QCOMPARE(rack.done.at(i + 1), rack.done.at(i).section(QLatin1Char(' '), 0, 0) + QStringLiteral(" open"));
    }
    for (const QueueLine &line : rack.bench.in(RowState::Passed))
        QCOMPARE(line.firmware, QStringLiteral("1.3 → 1.4"));
    QStringList links; // all are #0
    for (int i = 0; i < boardCount; ++i)
        links += board.model().index(i, QueueModel::Serial).data().toString();
    links.sort();
    QCOMPARE(links.join(QLatin1Char(' ')), QStringLiteral("sim:spi?seed=1 sim:spi?seed=2 sim:spi?seed=3"));
}

MB_WINDOW_TEST(BoardQueueTest);
#include "tst_boardqueue.moc"
