// SPDX-License-Identifier: GPL-3.0-or-later
// The guided update of a board on the Firmware page, over the bootloader's pseudo terminal.
#include "app/engine.h"
#include "model/registry.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/firmware/drawingview.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/routepanel.h"
#include "widgets/firmware/stepspanel.h"
#include "widgets/firmware/unitupdate.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

using namespace mb;

namespace {

constexpr int updatePatience = 60000;

bool shows(const DrawingView &view, const char *words)
{
    return view.accessibleName().contains(QLatin1String(words));
}

/// The board of this build, with a bootloader on a pseudo terminal.
struct Known {
    explicit Known(const std::string &terminal)
        : unit("quadquad2drv:0,boot=pty:" + terminal)
        , units{unit}
        , family(*findFamily(families(), "quadquad2drv"))
    {
        family.bench = units;
    }
    std::string unit;
    std::array<std::string_view, 1> units;
    Family family;
    std::array<const Family *, 1> only{&family};
};

} // namespace

class BoardUpdateTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup();
    void handsAreGuidedAndTheVersionIsCompared();
    void itCanBeCancelledWhileItWaitsForTheJumper();
    void everyControlHasAName();

private:
    void disturb(const char *what, double value);
    void begin();
    [[nodiscard]] const DeviceView *board();
    [[nodiscard]] const OperationView *operation();
    [[nodiscard]] bool holds(const QString &words);
    void picture(const char *name);

    QTemporaryDir m_folder;
    std::unique_ptr<Known> m_known;
    std::unique_ptr<Engine> m_engine;
    std::unique_ptr<ThemeSource> m_theme;
    Selection m_selection;
    std::unique_ptr<FirmwarePage> m_page;
};

void BoardUpdateTest::init()
{
    m_known = std::make_unique<Known>(m_folder.filePath(QStringLiteral("boot")).toStdString());
    m_engine = std::make_unique<Engine>(m_known->only, false);
    const double scale = std::max(1.0, qEnvironmentVariable("MOTORBENCH_FONT_SCALE").toDouble());
    const QFont body = QApplication::font();
    QFont larger = body;
    larger.setPointSizeF(10.0 * scale);
    QApplication::setFont(larger);
    m_theme = std::make_unique<ThemeSource>(darkTheme(10.0 * scale));
    applyTheme(*qApp, m_theme->theme());
    m_engine->post([folder = m_folder.filePath(QStringLiteral("logs")).toStdString()](
                       EngineCore &core) { core.keepTranscripts(folder); });
    m_engine->send(orders::OpenLink{*LinkAddress::parse("sim:spi")});
    m_page = std::make_unique<FirmwarePage>(*m_engine, m_selection, families(), *m_theme);
    m_page->resize(1280, 720);
    m_page->show();
    QTRY_VERIFY_WITH_TIMEOUT(board() && board()->liveness.heard, updatePatience);
    m_selection.select(board()->id);
    QFile file(m_folder.filePath(QStringLiteral("board.hex")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    for (int i = 0; i < 8; ++i)
        file.write(":0400000001020304F2\n");
    file.write(":00000001FF\n");
    file.close();
    m_page->loadImage(file.fileName());
}

void BoardUpdateTest::cleanup()
{
    m_page.reset();
    m_selection.select({});
    m_engine.reset();
    m_theme.reset();
    m_known.reset();
}

const DeviceView *BoardUpdateTest::board()
{
    const auto &all = m_engine->snapshot().devices;
    return all.empty() ? nullptr : &all.front();
}

const OperationView *BoardUpdateTest::operation()
{
    return m_engine->snapshot().operation(board()->id);
}

void BoardUpdateTest::disturb(const char *what, double value)
{
    m_engine->post([what, value](EngineCore &core) {
        for (Simulator *unit : core.session().bench(*core.session().links().front())->simulators())
            (void)unit->disturb(what, value);
    });
}

bool BoardUpdateTest::holds(const QString &words)
{
    const auto all = m_page->findChildren<QLabel *>();
    return std::any_of(all.begin(), all.end(), [&words](const QLabel *label) { return label->text().contains(words); });
}

void BoardUpdateTest::picture(const char *name)
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (folder.isEmpty())
        return;
    const double size = m_theme->theme().bodyPointSize;
    for (const QSize page : {QSize(1056, 660), QSize(3600, 2000)}) { // of a window of 1280x800 and 3840x2160
        m_page->resize(page);
        for (const bool dark : {true, false}) {
            m_theme->setTheme(dark ? darkTheme(size) : lightTheme(size));
            applyTheme(*qApp, m_theme->theme());
            QTest::qWait(200);
            m_page->grab().save(QDir(folder).filePath(
                QStringLiteral("%1-%2-%3.png")
                    .arg(QLatin1String(name), dark ? QStringLiteral("dark") : QStringLiteral("light"))
                    .arg(page.width())));
        }
    }
    m_page->resize(1280, 720);
}

void BoardUpdateTest::begin()
{
    m_page->unit().findChild<RoutePanel *>()->setVia(
        QStringLiteral("serial:") + m_folder.filePath(QStringLiteral("boot")));
    QTRY_VERIFY_WITH_TIMEOUT(m_page->canStart(), updatePatience);
    m_page->startUpdate();
    QTRY_VERIFY_WITH_TIMEOUT(holds(QStringLiteral("close the jumper")), updatePatience);
}

void BoardUpdateTest::handsAreGuidedAndTheVersionIsCompared()
{
    auto *drawing = m_page->unit().findChild<DrawingView *>();
    QVERIFY(drawing);
    begin();
    QVERIFY(drawing->isVisible() && shows(*drawing, "the jumper connects AUX1 and AUX2"));
    picture("update-jumper");
    disturb("jumper", 1.0);
    disturb("reset", 1.0);
    QTRY_VERIFY_WITH_TIMEOUT(operation() && operation()->status.done >= 2, updatePatience);
    QVERIFY(shows(*drawing, "the jumper connects AUX1 and AUX2"));
    disturb("jumper", 0.0);
    QTRY_VERIFY_WITH_TIMEOUT(operation()->update.has_value(), updatePatience);
    const UpdateReport report = *operation()->update;
    QVERIFY2(report.outcome == UpdateOutcome::Done, report.evidence.english().c_str());
    QCOMPARE(report.to, std::string("1.4"));
    QTRY_VERIFY_WITH_TIMEOUT(shows(*drawing, "AUX1 and AUX2 is taken out"), updatePatience);
    QTRY_VERIFY_WITH_TIMEOUT(holds(QStringLiteral("Verified")), updatePatience);
    picture("update-done");
    const QDir logs(m_folder.filePath(QStringLiteral("logs")));
    QTRY_COMPARE_WITH_TIMEOUT(logs.entryList(QDir::Files).size(), 1, updatePatience);
    QFile log(logs.filePath(logs.entryList(QDir::Files).front()));
    QVERIFY(log.open(QIODevice::ReadOnly));
    const QByteArray text = log.readAll();
    QVERIFY2(
        text.contains("> :0400000001020304F2") && text.contains("< ok") && text.contains("# done"), text.constData());
}

void BoardUpdateTest::itCanBeCancelledWhileItWaitsForTheJumper()
{
    begin();
    m_engine->send(orders::CancelOperation{operation()->id});
    QTRY_VERIFY_WITH_TIMEOUT(
        operation()->update && operation()->update->outcome == UpdateOutcome::Cancelled, updatePatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_page->canStart(), updatePatience);
}

void BoardUpdateTest::everyControlHasAName()
{
    auto *route = m_page->unit().findChild<RoutePanel *>();
    for (auto *button : route->findChildren<QPushButton *>()) {
        if (button->isCheckable())
            button->click();
    }
    QTRY_VERIFY_WITH_TIMEOUT(holds(QStringLiteral("line ending")), updatePatience);
    picture("update-unknowns");
    for (const QWidget *widget : m_page->findChildren<QWidget *>()) {
        const bool control = widget->inherits("QAbstractButton") || widget->inherits("QComboBox");
        if (control && widget->isVisible() && widget->accessibleName().isEmpty()
            && widget->property("text").toString().isEmpty())
            QFAIL(widget->metaObject()->className());
    }
}

MB_WINDOW_TEST(BoardUpdateTest);
#include "tst_boardupdate.moc"
