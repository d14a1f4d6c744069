// SPDX-License-Identifier: GPL-3.0-or-later
// What is on the screen can be read, reached and hit: measured on every page and dialog, at every size of text that can be chosen.
#include "app/focusorder.h"
#include "app/productionface.h"
#include "app/windowmenu.h"
#include "support/longwords.h"
#include "support/windowtests.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/noticestrip.h"
#include "widgets/parameters/parameterspage.h"
#include "widgets/parameters/parameterview.h"
#include "windowbench.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>

using namespace mb;
using namespace mb::test;

namespace {

constexpr int pageCount = 9;
constexpr int target = 32; ///< px at 96 dpi and a font of 10 pt
constexpr int slack = 3;
constexpr int mostControls = 400; ///< more than any page has
constexpr int leastRows = 4;      ///< of parameters, in sight

QString nameOf(const QWidget &widget)
{
    const auto *label = qobject_cast<const QLabel *>(&widget);
    const auto *button = qobject_cast<const QAbstractButton *>(&widget);
    const QString text = label                ? label->text()
        : button && !button->text().isEmpty() ? button->text()
                                              : widget.accessibleName();
    const QRect place(widget.mapTo(widget.window(), QPoint()), widget.size());
    return QStringLiteral("%1 '%2' %3,%4 %5x%6 of %7")
        .arg(QLatin1String(widget.metaObject()->className()), text)
        .arg(place.x())
        .arg(place.y())
        .arg(place.width())
        .arg(place.height())
        .arg(widget.sizeHint().width());
}

/// On the window as it would be without scroll bars: pages scroll while the focus goes through them.
QRect rectangleOf(const QWidget &widget)
{
    QPoint at = widget.mapTo(widget.window(), QPoint());
    for (const QWidget *around = widget.parentWidget(); around; around = around->parentWidget()) {
        if (const auto *area = qobject_cast<const QScrollArea *>(around))
            at += QPoint(area->horizontalScrollBar()->value(), area->verticalScrollBar()->value());
    }
    return {at, widget.size()};
}

/// In sight, not scrolled away and not behind an edge.
bool isSeen(const QWidget &widget)
{
    return widget.isVisible() && !widget.visibleRegion().isEmpty();
}

/// Beyond the edge of something around it that does not scroll there.
bool isOut(const QWidget &widget)
{
    QPoint at;
    for (const QWidget *one = &widget; one->parentWidget() && !one->isWindow(); one = one->parentWidget()) {
        at += one->pos();
        const QWidget &around = *one->parentWidget();
        const auto *area = qobject_cast<const QScrollArea *>(around.parentWidget());
        if (area && area->viewport() == &around) // it can be scrolled to, as far as the area does
            return area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff
                && (at.x() < -slack || at.x() + widget.width() > around.width() + slack);
        const QRect place(at, widget.size());
        if (!around.rect().adjusted(-slack, -slack, slack, slack).contains(place))
            return true;
    }
    return false;
}

/// Whether the eye would have to go back: above and not in a column further right, or left in the same row.
bool goesBack(const QRect &before, const QRect &after)
{
    const bool above = after.bottom() <= before.top() + slack;
    const int shared = std::min(after.bottom(), before.bottom()) - std::max(after.top(), before.top());
    const bool sameRow = 2 * shared > std::min(after.height(), before.height());
    return (above && after.left() < before.right() - slack) || (sameRow && after.right() <= before.left() + slack);
}

/// By pressing Tab until something comes again, beginning with what stands first.
std::vector<QWidget *> roundByTab(QWidget &window)
{
    std::vector<QWidget *> passed;
    for (int i = 0; i < mostControls; ++i) {
        QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &window, Qt::Key_Tab);
        QWidget *now = QApplication::focusWidget();
        if (!now)
            break;
        if (const auto again = std::find(passed.begin(), passed.end(), now); again != passed.end()) {
            passed.erase(passed.begin(), again); // how one came into the round does not count
            break;
        }
        passed.push_back(now);
    }
    const auto first = std::min_element(passed.begin(), passed.end(), [](const QWidget *a, const QWidget *b) {
        return std::pair(rectangleOf(*a).y(), rectangleOf(*a).x())
            < std::pair(rectangleOf(*b).y(), rectangleOf(*b).x());
    });
    std::rotate(passed.begin(), first, passed.end());
    return passed;
}

/// Where the order of Tab is not that of reading, and what Tab never comes to.
QStringList againstReading(QWidget &window, std::size_t &count)
{
    const std::vector<QWidget *> ring = roundByTab(window);
    count = ring.size();
    QStringList wrong;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        if (goesBack(rectangleOf(*ring[i - 1]), rectangleOf(*ring[i])))
            wrong += QStringLiteral("back: ") + nameOf(*ring[i - 1]) + QStringLiteral("  ->  ") + nameOf(*ring[i]);
    }
    for (QWidget *one : window.findChildren<QWidget *>()) {
        if (one->window() == &window && one->isVisible() && one->isEnabled() && (one->focusPolicy() & Qt::TabFocus) != 0
            && !one->focusProxy() && std::find(ring.begin(), ring.end(), one) == ring.end())
            wrong += QStringLiteral("Tab does not come to ") + nameOf(*one);
    }
    return wrong;
}

bool isTarget(const QWidget &widget)
{
    for (const QWidget *parent = widget.parentWidget(); parent; parent = parent->parentWidget()) {
        if (qobject_cast<const QComboBox *>(parent) || qobject_cast<const QAbstractSpinBox *>(parent)
            || qobject_cast<const QTabBar *>(parent) || qobject_cast<const QAbstractItemView *>(parent)
            || qobject_cast<const QLineEdit *>(parent))
            return false; // part of a larger one
    }
    return qobject_cast<const QAbstractButton *>(&widget) || qobject_cast<const QComboBox *>(&widget)
        || qobject_cast<const QLineEdit *>(&widget) || qobject_cast<const QAbstractSpinBox *>(&widget)
        || qobject_cast<const QSlider *>(&widget);
}

QStringList tooSmall(const QWidget &window, int least)
{
    QStringList small;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (widget->window() == &window && isSeen(*widget) && isTarget(*widget)
            && std::min(widget->width(), widget->height()) < least)
            small += nameOf(*widget);
    }
    return small;
}

/// px that its text, its symbol and its key take at least.
int neededWidth(const QPushButton &button)
{
    if (qobject_cast<const CommandButton *>(&button)) // which has air that it can do without
        return button.sizeHint().width() - QFontMetrics(button.font()).height();
    return button.minimumSizeHint().width();
}

bool holdsWords(const QWidget &widget)
{
    return qobject_cast<const QLabel *>(&widget) || qobject_cast<const QPushButton *>(&widget)
        || qobject_cast<const QLineEdit *>(&widget) || qobject_cast<const QComboBox *>(&widget);
}

/// What is narrower or lower than its text, what lies over its neighbour, and commands that no scrolling brings into sight.
QStringList cutOrOverprinted(const QWidget &window)
{
    QStringList bad;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (widget->window() != &window || !widget->isVisible())
            continue;
        const auto *button = qobject_cast<const QPushButton *>(widget);
        if (button && isOut(*button))
            bad += QStringLiteral("out of reach: ") + nameOf(*button);
        if (!isSeen(*widget))
            continue;
        const auto *label = qobject_cast<const QLabel *>(widget);
        if (label && label->wordWrap() && label->height() < label->heightForWidth(label->width()) - slack)
            bad += QStringLiteral("lower than its text: ") + nameOf(*label);
        if (label && !label->wordWrap() && !qobject_cast<const ElidedLabel *>(label) && !label->text().isEmpty()
            && label->width() < label->sizeHint().width() - slack && label->textFormat() != Qt::RichText)
            bad += QStringLiteral("narrower than its text: ") + nameOf(*label);
        if (button && !button->text().isEmpty() && button->width() < neededWidth(*button))
            bad += QStringLiteral("narrower than its text: ") + nameOf(*button);
        for (const QObject *object : holdsWords(*widget) ? widget->parentWidget()->children() : QObjectList()) {
            const auto *other = qobject_cast<const QWidget *>(object);
            if (!other || other <= widget || other->isWindow() || !isSeen(*other))
                continue;
            const QRect both = widget->geometry() & other->geometry();
            if (both.width() > slack && both.height() > slack)
                bad += QStringLiteral("over each other: ") + nameOf(*widget) + QStringLiteral(" and ") + nameOf(*other);
        }
    }
    return bad;
}

/// Each once, whole: what QVERIFY2 says is cut at a thousand letters.
void verifyNone(QStringList found)
{
    found.removeDuplicates();
    for (const QString &one : std::as_const(found))
        qInfo("%s", qPrintable(one));
    QVERIFY2(found.isEmpty(), qPrintable(QStringLiteral("%1 found").arg(found.size())));
}

void settle()
{
    for (int i = 0; i < 3; ++i)
        QCoreApplication::processEvents();
}

/// Calls of each dialog that the window opens by itself, by name.
std::vector<std::pair<QString, std::function<void()>>> dialogsOf(MainWindow &window)
{
    auto *menu = window.findChild<WindowMenu *>();
    return {{QStringLiteral("preferences"), [menu] { menu->askPreferences(); }},
        {QStringLiteral("add link"), [menu] { menu->addLink(); }},
        {QStringLiteral("keys"), [&window] { window.listKeys(); }},
        {QStringLiteral("commands"), [menu] { Q_EMIT menu->commandsRequested(); }},
        {QStringLiteral("about"), [menu] { menu->menu().actions().at(menu->menu().actions().size() - 2)->trigger(); }},
        {QStringLiteral("battery"), [&window] {
             window.showPage(PageId::Tune);
             QTest::keyClick(&window, Qt::Key_F7);
         }}};
}

void forEachFace(WindowBench &bench, const std::function<void(const QString &, QWidget &)> &look)
{
    MainWindow &window = bench.window();
    for (int i = 0; i < pageCount; ++i) {
        window.showPage(static_cast<PageId>(i));
        settle();
        look(window.findChild<QTabBar *>()->tabText(i), window);
    }
    for (const auto &[name, open] : dialogsOf(window)) {
        QApplication::setActiveWindow(&window);
        open();
        settle();
        QDialog *dialog = nullptr;
        for (QDialog *one : window.findChildren<QDialog *>())
            dialog = one->isVisible() ? one : dialog;
        QVERIFY2(dialog, qPrintable(name));
        QApplication::setActiveWindow(dialog);
        look(name, *dialog);
        dialog->reject();
        delete dialog;
    }
}

} // namespace

class ReadingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void tabGoesAsOneReads_data();
    void tabGoesAsOneReads();
    void everyTargetCanBeHit();
    void nothingIsCutOrOverprinted_data();
    void nothingIsCutOrOverprinted();
    void parametersAreInSight_data();
    void parametersAreInSight();
    void noPageScrollsSideways_data() { parametersAreInSight_data(); }
    void noPageScrollsSideways();
    void theStripeIsNoHigherThanTwoLines_data() { parametersAreInSight_data(); }
    void theStripeIsNoHigherThanTwoLines();
};

void ReadingTest::tabGoesAsOneReads_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("1440x900") << QSize(1440, 900);
    QTest::newRow("1280x800") << QSize(1280, 800);
}

void ReadingTest::tabGoesAsOneReads()
{
    QFETCH(QSize, size);
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.window().resize(size);
    QStringList wrong;
    forEachFace(bench, [&wrong](const QString &name, QWidget &window) {
        std::size_t count = 0;
        const QStringList found = againstReading(window, count);
        if (count == mostControls)
            wrong += name + QStringLiteral(": Tab does not come round");
        qInfo("%s: %zu controls by Tab, %d against the order of reading", qPrintable(name), count, found.size());
        for (const QString &one : found)
            wrong += name + QStringLiteral(": ") + one;
    });
    verifyNone(wrong);
}

void ReadingTest::everyTargetCanBeHit()
{
    WindowBench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.window().resize(1440, 900);
    QStringList small;
    forEachFace(bench, [&small](const QString &name, QWidget &window) {
        for (const QString &one : tooSmall(window, target))
            small += name + QStringLiteral(": ") + one;
    });
    verifyNone(small);
}

void ReadingTest::nothingIsCutOrOverprinted_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<double>("fontScale");
    QTest::addColumn<bool>("longWords");
    for (const QSize size : {QSize(1280, 800), QSize(1366, 768)}) {
        for (const int percent : {100, 125, 150, 175, 200}) {
            QTest::addRow("%dx%d at %d %%", size.width(), size.height(), percent) << size << percent / 100.0 << false;
            QTest::addRow("%dx%d at %d %%, words +40 %%", size.width(), size.height(), percent)
                << size << percent / 100.0 << true;
        }
    }
}

void ReadingTest::nothingIsCutOrOverprinted()
{
    QFETCH(QSize, size);
    QFETCH(double, fontScale);
    QFETCH(bool, longWords);
    LongWords words;
    if (longWords)
        QCoreApplication::installTranslator(&words);
    WindowBench bench(fontScale);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.window().resize(size);
    QStringList bad;
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    forEachFace(bench, [&](const QString &name, QWidget &window) {
        QStringList found = cutOrOverprinted(window);
        for (int i = 0; i < patience / 100 && !found.isEmpty();
             ++i) { // what was made just now has its place in a moment
            QTest::qWait(10);
            found = cutOrOverprinted(window);
        }
        for (const QString &one : found)
            bad += name + QStringLiteral(": ") + one;
        if (!found.isEmpty() && !folder.isEmpty()) // for looking at it
            window.grab().save(
                QDir(folder).filePath(QStringLiteral("%1-%2-%3.png")
                                          .arg(name,
                                              longWords ? QStringLiteral("long-") + QString::number(size.width())
                                                        : QString::number(size.width()))
                                          .arg(fontScale)));
    });
    verifyNone(bad);
}

void ReadingTest::parametersAreInSight_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<double>("fontScale");
    QTest::newRow("1280x800 at 200 %") << QSize(1280, 800) << 2.0;
    QTest::newRow("1366x768 at 150 %") << QSize(1366, 768) << 1.5;
    QTest::newRow("1280x800 at 125 %") << QSize(1280, 800) << 1.25;
}

/// Whole rows with a value, and no column that has to be scrolled for.
void ReadingTest::parametersAreInSight()
{
    QFETCH(QSize, size);
    QFETCH(double, fontScale);
    WindowBench bench(fontScale);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    bench.window().resize(size);
    ParameterView &view = bench.page<ParametersPage>(PageId::Parameters).view();
    QTRY_VERIFY_WITH_TIMEOUT(view.shownRows() > leastRows, patience);
    settle();
    const auto rowsInSight = [&view] {
        const QRect seen = view.viewport()->visibleRegion().boundingRect();
        int rows = 0;
        for (int group = 0; group < view.model()->rowCount(); ++group) {
            const QModelIndex head = view.model()->index(group, 0);
            for (int row = 0; row < view.model()->rowCount(head); ++row)
                rows
                    += seen.contains(view.visualRect(view.model()->index(row, 0, head)).adjusted(1, 1, -1, -1)) ? 1 : 0;
        }
        return rows;
    };
    QTRY_VERIFY_WITH_TIMEOUT(
        rowsInSight() >= leastRows, patience); // what is told of the unit can still take or give a line
    qInfo("%d rows", rowsInSight());
    QCOMPARE(view.horizontalScrollBar()->maximum(), 0);
}

/// What is beyond the right edge is not seen by who reads, whatever can be scrolled.
void ReadingTest::noPageScrollsSideways()
{
    QFETCH(QSize, size);
    QFETCH(double, fontScale);
    WindowBench bench(fontScale);
    QTRY_VERIFY_WITH_TIMEOUT(bench.isFound(), patience);
    bench.select(WindowBench::tuned);
    MainWindow &window = bench.window();
    window.resize(size);
    QStringList wide;
    for (int i = 0; i < pageCount; ++i) {
        const auto id = static_cast<PageId>(i);
        window.showPage(id);
        settle();
        const auto *area = qobject_cast<QScrollArea *>(window.page(id)->parentWidget()->parentWidget());
        QVERIFY(area);
        if (area->horizontalScrollBar()->maximum() > 0)
            wide += QStringLiteral("%1 is %2 px wider than its place")
                        .arg(window.findChild<QTabBar *>()->tabText(i))
                        .arg(area->horizontalScrollBar()->maximum());
    }
    verifyNone(wide);
}

void ReadingTest::theStripeIsNoHigherThanTwoLines()
{
    QFETCH(QSize, size);
    QFETCH(double, fontScale);
    WindowBench bench(fontScale);
    bench.window().resize(size);
    settle();
    const auto *strip = bench.window().findChild<NoticeStrip *>();
    const int line = QFontMetrics(strip->font()).height();
    QVERIFY2(strip->height() <= 2 * line + 2 * line / 3, qPrintable(QString::number(strip->height())));
}

MB_WINDOW_TEST(ReadingTest);
#include "tst_reading.moc"
