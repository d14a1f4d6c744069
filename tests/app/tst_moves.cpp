// SPDX-License-Identifier: GPL-3.0-or-later
// Buffered moves of four nodes in the window: the real page and engine against four simulated motors on one serial line.
#include "askengine.h"
#include "model/registry.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/livetext.h"
#include "widgets/common/selection.h"
#include "widgets/control/arming.h"
#include "widgets/control/movespanel.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tunepage.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QTest>

#include <algorithm>

using namespace mb;

namespace {

constexpr int movePatience = 60000;
constexpr std::array<std::string_view, 4> units{"supermodified:4,dialect=D1", "supermodified:5,dialect=D2",
    "supermodified:6,dialect=D1", "supermodified:7,dialect=D2"};

/// The family of this build, with four units on its bench.
const Family &fourNodes()
{
    static const Family family = [] {
        Family made;
        for (const Family *candidate : families()) {
            if (candidate->capabilities.bufferedMoves)
                made = *candidate;
        }
        made.bench = units;
        return made;
    }();
    return family;
}
const std::array<const Family *, 1> onlyNodes{&fourNodes()};

} // namespace

class MovesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup();
    void fourNodesMoveTogetherOnOneCommand();
    void nothingIsPreparedUnarmed();
    void stopEndsAllOfThem();
    void aMoveThatWasStoppedBeforeItBeganIsShownUntilItIsReplaced();
    void oneThatStallsTakesTheOthersWithIt();
    void thePositionIsZeroedWithTheMotorOffAndRunStartsItAgain();
    void everyControlHasAName();
    void nothingIsWiderThanTheColumn();

private:
    [[nodiscard]] std::vector<double> positions()
    {
        return test::askEngine<std::vector<double>>(*m_engine, [](EngineCore &core) {
            std::vector<double> all;
            for (const Simulator *unit : core.session().bench(*core.session().links().front())->simulators())
                all.push_back(unit->position());
            return all;
        });
    }
    [[nodiscard]] int energized()
    {
        return test::askEngine<int>(*m_engine, [](EngineCore &core) {
            const auto all = core.session().bench(*core.session().links().front())->simulators();
            return static_cast<int>(
                std::count_if(all.begin(), all.end(), [](const Simulator *unit) { return unit->isOutputOn(); }));
        });
    }
    [[nodiscard]] CommandButton &button(const char *name)
    {
        return *m_page->findChild<CommandButton *>(QString::fromLatin1(name));
    }
    [[nodiscard]] bool isReady() const;
    void prepare(const QString &target);
    void picture(const char *name);

    ThemeSource m_theme{darkTheme()};
    std::unique_ptr<Engine> m_engine;
    std::unique_ptr<Selection> m_selection;
    std::unique_ptr<Arming> m_arming;
    std::unique_ptr<TunePage> m_page;
};

bool MovesTest::isReady() const
{
    const auto &all = m_engine->snapshot().devices;
    return all.size() == units.size() && std::all_of(all.begin(), all.end(), [](const DeviceView &d) {
        return d.liveness.heard && !d.identity->dialect.empty() && d.mayNotMove.empty();
    });
}

void MovesTest::init()
{
    applyTheme(*qApp, m_theme.theme());
    m_engine = std::make_unique<Engine>(onlyNodes, false);
    m_selection = std::make_unique<Selection>();
    m_arming = std::make_unique<Arming>(*m_engine);
    m_page = std::make_unique<TunePage>(*m_engine, *m_selection, *m_arming, m_theme, nullptr);
    m_page->showLive(true);
    m_page->resize(1208, 1000);
    m_page->show();
    QApplication::setActiveWindow(m_page.get());
    m_engine->send(orders::OpenLink{*LinkAddress::parse("sim:serial?bitrate=115200")});
    m_engine->send(orders::ScanLinks{});
    QTRY_VERIFY_WITH_TIMEOUT(isReady(), movePatience);
    m_selection->select(m_engine->snapshot().devices.front().id);
    QTRY_VERIFY(m_page->column().movesPanel().isVisibleTo(m_page.get()));
}

void MovesTest::cleanup()
{
    m_page.reset();
    m_arming.reset();
    m_selection.reset();
    m_engine.reset();
}

void MovesTest::prepare(const QString &target)
{
    m_arming->arm(m_engine->snapshot().devices.front().id);
    QVERIFY(m_arming->isArmed(m_engine->snapshot().devices.front().id));
    for (QLineEdit *field : m_page->column().movesPanel().findChildren<QLineEdit *>())
        field->setText(target);
    for (QCheckBox *box : m_page->column().movesPanel().findChildren<QCheckBox *>()) {
        if (box->text().startsWith(QLatin1Char('#')))
            box->setChecked(true);
    }
    QTest::mouseClick(&button("prepareMoves"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button("startMoves").isEnabled(), movePatience);
    QCOMPARE(energized(), 4);
}

void MovesTest::picture(const char *name)
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (!folder.isEmpty())
        m_page->grab().save(QDir(folder).filePath(QString::fromLatin1(name)));
}

void MovesTest::fourNodesMoveTogetherOnOneCommand()
{
    m_page->column().movesPanel().findChild<QComboBox *>()->setCurrentIndex(0);
    prepare(QStringLiteral("1500"));
    picture("moves-prepared.png");
    for (const double position : positions())
        QVERIFY2(std::abs(position) < 30.0, "nothing turns before the start");
    QTest::mouseClick(&button("startMoves"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(positions().front() > 300.0, movePatience);
    picture("moves-started.png");
    const auto under = positions();
    const auto [least, most] = std::minmax_element(under.begin(), under.end());
    QVERIFY2(*most - *least < 60.0, "they are side by side on the way");
    QTRY_VERIFY_WITH_TIMEOUT(
        [this] {
            const auto all = positions();
            return std::all_of(all.begin(), all.end(), [](double p) { return std::abs(p - 1500.0) < 40.0; });
        }(),
        movePatience);
    QCOMPARE(energized(), 4);
    m_arming->disarm();
    QTRY_COMPARE_WITH_TIMEOUT(energized(), 0, movePatience);
}

void MovesTest::nothingIsPreparedUnarmed()
{
    QVERIFY(!button("prepareMoves").isEnabled());
    m_page->column().movesPanel().prepare();
    m_page->column().movesPanel().startTogether();
    m_page->column().movesPanel().hold();
    QTest::qWait(200);
    QCOMPARE(energized(), 0);
}

void MovesTest::stopEndsAllOfThem()
{
    prepare(QStringLiteral("0"));
    m_arming->stopAll(QStringLiteral("test"));
    QTRY_COMPARE_WITH_TIMEOUT(energized(), 0, movePatience);
    QVERIFY(!button("startMoves").isEnabled());
}

void MovesTest::aMoveThatWasStoppedBeforeItBeganIsShownUntilItIsReplaced()
{
    const auto shown = [this](const QString &word) {
        const auto labels = m_page->column().movesPanel().findChildren<QLabel *>();
        return std::count_if(labels.begin(), labels.end(), [&word](const QLabel *l) { return l->text() == word; });
    };
    const auto first = [this]() -> const DeviceView & { return m_engine->snapshot().devices.front(); };
    prepare(QStringLiteral("1500"));
    QCOMPARE(shown(QStringLiteral("keeps a move")), 0);
    m_arming->stopAll(QStringLiteral("test"));
    QTRY_COMPARE_WITH_TIMEOUT(shown(QStringLiteral("keeps a move")), 4, movePatience);
    QVERIFY(lineOf(first()).contains(QStringLiteral("keeps a move")));
    QVERIFY(tooltipOf(first()).contains(QStringLiteral("would begin it with the next start")));
    picture("moves-kept.png");
    prepare(QStringLiteral("500"));
    QTest::mouseClick(&button("startMoves"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(positions().front() - 500.0) < 40.0, movePatience);
    m_arming->disarm();
    QTRY_COMPARE_WITH_TIMEOUT(energized(), 0, movePatience);
    QTRY_COMPARE_WITH_TIMEOUT(shown(QStringLiteral("keeps a move")), 0, movePatience);
    QVERIFY(!lineOf(first()).contains(QStringLiteral("keeps a move")));
}

void MovesTest::oneThatStallsTakesTheOthersWithIt()
{
    m_page->column().movesPanel().findChild<QCheckBox *>(QString())->setChecked(true);
    prepare(QStringLiteral("1500"));
    QVERIFY(test::askEngine<bool>(*m_engine, [](EngineCore &core) {
        return core.session().bench(*core.session().links().front())->simulators().back()->disturb("stall", 1);
    }));
    QTest::mouseClick(&button("startMoves"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(energized(), 0, movePatience);
}

void MovesTest::thePositionIsZeroedWithTheMotorOffAndRunStartsItAgain()
{
    const DeviceId first = m_engine->snapshot().devices.front().id;
    const auto shown = [this] { return liveValue(m_engine->snapshot().devices.front(), "position", m_engine->now()); };
    m_arming->arm(first);
    SetPoint setPoint;
    setPoint.mode = Mode::Position;
    setPoint.target = 1500.0;
    m_arming->run(setPoint);
    QTRY_VERIFY_WITH_TIMEOUT(shown() && std::abs(*shown() - 1500.0) < 40.0, movePatience);
    auto *zero = m_page->findChild<QPushButton *>(QStringLiteral("zeroPosition"));
    QVERIFY(zero->isVisibleTo(m_page.get()));
    QVERIFY(!zero->toolTip().isEmpty());
    QTest::mouseClick(zero, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(shown() && std::abs(*shown()) < 40.0, movePatience);
    QCOMPARE(energized(), 0);
    QVERIFY2(std::abs(positions().front() - 1500.0) < 60.0, "the shaft stays where it was");
    QVERIFY2(m_arming->isArmed(first), "it may be started again");
    setPoint.target = 0.0;
    m_arming->run(setPoint);
    QTRY_COMPARE_WITH_TIMEOUT(energized(), 1, movePatience);
    QTest::qWait(500);
    QVERIFY2(std::abs(positions().front() - 1500.0) < 60.0, "and does not jump");
    m_arming->disarm();
    QTRY_COMPARE_WITH_TIMEOUT(energized(), 0, movePatience);
}

void MovesTest::everyControlHasAName()
{
    for (QWidget *widget : m_page->column().movesPanel().findChildren<QWidget *>()) {
        if (widget->focusPolicy() != Qt::NoFocus && qobject_cast<QAbstractButton *>(widget))
            QVERIFY2(!widget->accessibleName().isEmpty() || !qobject_cast<QAbstractButton *>(widget)->text().isEmpty(),
                qPrintable(widget->objectName()));
        if (qobject_cast<QLineEdit *>(widget) || qobject_cast<QComboBox *>(widget))
            QVERIFY(!widget->accessibleName().isEmpty());
    }
}

void MovesTest::nothingIsWiderThanTheColumn()
{
    const QFont usual = QApplication::font();
    for (const double size : {10.0, 20.0}) {
        m_theme.setTheme(lightTheme(size));
        QFont font = QApplication::font();
        font.setPointSizeF(size);
        QApplication::setFont(font);
        applyTheme(*qApp, m_theme.theme());
        m_page = std::make_unique<TunePage>(*m_engine, *m_selection, *m_arming, m_theme, nullptr);
        m_page->showLive(true);
        m_page->resize(m_theme.theme().u(1208), m_theme.theme().u(1000));
        m_page->show();
        QTRY_VERIFY(m_page->column().movesPanel().isVisibleTo(m_page.get()));
        auto *area = m_page->findChild<QScrollArea *>();
        QVERIFY(area->isAncestorOf(&m_page->column().movesPanel()));
        QTRY_VERIFY2(area->widget()->width() <= area->viewport()->width(),
            qPrintable(QStringLiteral("%1 in %2").arg(area->widget()->width()).arg(area->viewport()->width())));
        picture(size > 15.0 ? "moves-200.png" : "moves-light.png");
    }
    m_theme.setTheme(darkTheme());
    QApplication::setFont(usual);
}

MB_WINDOW_TEST(MovesTest);
#include "tst_moves.moc"
