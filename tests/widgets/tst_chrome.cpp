// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/banner.h"
#include "widgets/common/card.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/headerbar.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/noticestrip.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/common/sparkline.h"
#include "widgets/common/valuelabel.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>
#include <numeric>

using namespace mb;

class ChromeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void init() { QApplication::setDoubleClickInterval(0); }
    void chipSpeaksItsState();
    void chipsFoldWhenTheHeaderIsNarrow();
    void clickingAChipNamesItsLink();
    void everyControlHasAnAccessibleName();
    void segmentedTellsOfChangesOnly();
    void segmentedMovesByArrowKeys();
    void theWorstNoticeStandsAndTheOthersAreCounted();
    void pagesThatHaveNoRoomCanBeReached();
    void pagesStandCloserBeforeTheLastOneIsHidden();
    void theStripeGivesWayAtOnceToANotice();
    void aBannerThatPersistsDoesNotPileUp();
    void aDismissedBannerStaysSilentUntilItsConditionEnds();
    void valueFieldKeepsItsWidth();
    void aCaptionStandsBesideItsOwnNumber();
    void sparklineRangeIgnoresGaps();
    void sparklineKeepsItsCapacity();
    void aConstantIsALineAndNoBlock();
    void searchFieldLetsEscThrough();
    void cardOpensByEnterAndNotBySpace();
    void primaryButtonIsAsWideAsItsWidestText();
    void aPressThatWasMeantForTheRoleBeforeIsNone();
    void aNoticeThatComesUnderThePointerIsNotAnswered();
    void anEmptyPageShowsItsWholeSentence();

private:
    ThemeSource m_theme{darkTheme()};
};

namespace {

std::vector<LinkStatus> links(bool healthy)
{
    const auto name = [](const char *text) { return QString::fromLatin1(text); };
    return {{name("can0"), GlyphState::Online, {}, 0.14, {}, 0, true, {}},
        {name("can1"), healthy ? GlyphState::Online : GlyphState::Warning, {}, 0.06, {}, 7, healthy, {}},
        {name("ttyUSB0"), GlyphState::Online, {}, {}, name("61 Hz"), 0, true, {}},
        {name("spi0"), GlyphState::Fault, name("no permission"), {}, {}, {}, true, {}}};
}

int visibleChips(const HeaderBar &header)
{
    const auto chips = header.findChildren<LinkChip *>();
    return static_cast<int>(
        std::count_if(chips.begin(), chips.end(), [](const LinkChip *chip) { return chip->isVisible(); }));
}

/// Keys that somebody above receives: STOP is such a receiver.
class KeyCatcher : public QWidget {
public:
    int caught = 0;

protected:
    void keyPressEvent(QKeyEvent *event) override { caught += event->key() == Qt::Key_Escape ? 1 : 0; }
};

} // namespace

void ChromeTest::initTestCase()
{
    applyTheme(*qApp, m_theme.theme());
}

void ChromeTest::chipSpeaksItsState()
{
    LinkChip chip(m_theme);
    chip.setStatus(links(false).at(1));
    QVERIFY(chip.accessibleName().contains(QStringLiteral("can1")));
    QVERIFY(chip.accessibleDescription().contains(QStringLiteral("lost 7")));
    const int width = chip.sizeHint().width();
    LinkStatus fuller = links(false).at(1);
    fuller.load = 0.42;
    chip.setStatus(fuller);
    QCOMPARE(chip.sizeHint().width(), width);
}

void ChromeTest::chipsFoldWhenTheHeaderIsNarrow()
{
    HeaderBar header(m_theme);
    header.setLinks(links(true));
    header.resize(1800, header.height());
    header.show();
    QCOMPARE(visibleChips(header), 4);
    const QPoint stop = header.stopButton().geometry().topRight();
    header.resize(800, header.height());
    QTRY_COMPARE(visibleChips(header), 0);
    QCOMPARE(header.width() - header.stopButton().geometry().right(), 1800 - stop.x());
    header.resize(1800, header.height());
    QTRY_COMPARE(visibleChips(header), 4);
}

void ChromeTest::clickingAChipNamesItsLink()
{
    HeaderBar header(m_theme);
    auto shown = links(true);
    shown.at(2).address = QStringLiteral("serial:/dev/ttyUSB0");
    header.setLinks(shown);
    header.resize(1800, header.height());
    header.show();
    QSignalSpy activated(&header, &HeaderBar::linkActivated);
    header.findChildren<LinkChip *>().at(2)->click();
    QCOMPARE(activated.count(), 1);
    QCOMPARE(activated.first().first().toString(), shown.at(2).address);
}

void ChromeTest::everyControlHasAnAccessibleName()
{
    HeaderBar header(m_theme);
    header.setLinks(links(false));
    header.setNotices(2);
    header.setRecording(QStringLiteral("REC 12:41"));
    Banner banner(m_theme, BannerKind::Caution, QStringLiteral("cause"), QStringLiteral("remedy"));
    banner.setAction(QStringLiteral("How to check"));
    banner.setOther(QStringLiteral("Leave it"));
    Segmented segments(QStringLiteral("Filter"), {QStringLiteral("All"), QStringLiteral("Errors")});
    QList<QAbstractButton *> buttons = header.findChildren<QAbstractButton *>()
        + banner.findChildren<QAbstractButton *>() + segments.findChildren<QAbstractButton *>();
    QVERIFY(buttons.size() > 10);
    for (const QAbstractButton *button : buttons)
        QVERIFY2(!button->accessibleName().isEmpty(), button->metaObject()->className());
}

void ChromeTest::segmentedTellsOfChangesOnly()
{
    Segmented segments(
        QStringLiteral("Filter"), {QStringLiteral("All"), QStringLiteral("Changed"), QStringLiteral("Errors")});
    QCOMPARE(segments.current(), 0);
    QSignalSpy changed(&segments, &Segmented::currentChanged);
    segments.setCurrent(0);
    QCOMPARE(changed.count(), 0);
    segments.setCurrent(2);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed.first().first().toInt(), 2);
}

void ChromeTest::segmentedMovesByArrowKeys()
{
    Segmented segments(
        QStringLiteral("Filter"), {QStringLiteral("All"), QStringLiteral("Changed"), QStringLiteral("Errors")});
    segments.show();
    QVERIFY(QTest::qWaitForWindowActive(&segments));
    auto *first = segments.findChildren<QToolButton *>().first();
    first->setFocus(Qt::TabFocusReason);
    QTest::keyClick(first, Qt::Key_Right);
    QCOMPARE(segments.current(), 1);
}

void ChromeTest::theWorstNoticeStandsAndTheOthersAreCounted()
{
    QWidget page;
    BannerStack stack(m_theme, &page);
    page.show();
    QSignalSpy counted(&stack, &BannerStack::countChanged);
    for (const char *key : {"a", "b", "c", "d"})
        stack.post(QString::fromLatin1(key), BannerKind::Caution, QString::fromLatin1(key), {});
    stack.post(QStringLiteral("e"), BannerKind::Danger, QStringLiteral("stopped"), {});
    stack.post(QStringLiteral("f"), BannerKind::Info, QStringLiteral("newest"), {});
    QCOMPARE(stack.count(), 6);
    QCOMPARE(counted.last().first().toInt(), 6);
    QStringList shown;
    for (const Banner *banner : stack.findChildren<Banner *>()) {
        if (banner->isVisibleTo(&page))
            shown << banner->cause();
    }
    QCOMPARE(shown, QStringList({QStringLiteral("stopped")}));
    QVERIFY(stack.findChild<QPushButton *>(QStringLiteral("moreNotices"))->text().contains(QLatin1Char('5')));
}

void ChromeTest::pagesThatHaveNoRoomCanBeReached()
{
    QWidget page;
    auto *column = new QVBoxLayout(&page);
    auto *tabs = new PageTabs(m_theme, &page);
    column->addWidget(tabs);
    for (int i = 0; i < 7; ++i)
        tabs->addTab(QStringLiteral("A page %1").arg(i));
    page.resize(300, 100);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    QVERIFY(tabs->width() < 300);
    const auto buttons = tabs->findChildren<QToolButton *>();
    QCOMPARE(buttons.size(), 2);
    for (const QToolButton *button : buttons)
        QVERIFY(button->isVisible() && tabs->rect().contains(button->geometry()));
    tabs->setCurrentIndex(6);
    QVERIFY(tabs->rect().contains(tabs->tabRect(6)));
}

void ChromeTest::pagesStandCloserBeforeTheLastOneIsHidden()
{
    PageTabs tabs(m_theme);
    for (const char *title :
        {"Übersicht", "Parameter", "Regler", "Entwurf", "Kurven", "Firmware", "Bus", "Protokoll", "Berichte"})
        tabs.addTab(QString::fromUtf8(title));
    tabs.resize(1400, 36);
    tabs.show();
    QVERIFY(QTest::qWaitForWindowExposed(&tabs));
    const int wide = tabs.tabRect(8).right();
    tabs.resize(wide - 60, 36);
    QCoreApplication::processEvents();
    QVERIFY2(tabs.tabRect(8).right() < tabs.width(), qPrintable(QString::number(tabs.tabRect(8).right())));
    for (const QToolButton *button : tabs.findChildren<QToolButton *>())
        QVERIFY(!button->isVisible());
    tabs.resize(1400, 36);
    QCoreApplication::processEvents();
    QCOMPARE(tabs.tabRect(8).right(), wide);
}

/// Without a turn of the event loop: as it is seen first.
void ChromeTest::theStripeGivesWayAtOnceToANotice()
{
    NoticeStrip strip(m_theme);
    strip.resize(1280, 36);
    strip.show();
    QCoreApplication::processEvents();
    QCOMPARE(strip.stripe().width(), 1280);
    strip.banners().post(QStringLiteral("a"), BannerKind::Danger, QStringLiteral("Stopped"), QStringLiteral("again"));
    QVERIFY2(strip.stripe().width() < 200, qPrintable(QString::number(strip.stripe().width())));
}

void ChromeTest::aBannerThatPersistsDoesNotPileUp()
{
    BannerStack stack(m_theme);
    for (int i = 0; i < 5; ++i)
        stack.post(QStringLiteral("errors"), BannerKind::Caution, QStringLiteral("%1 errors").arg(i), {});
    QCOMPARE(stack.count(), 1);
    QCOMPARE(stack.findChildren<Banner *>().first()->cause(), QStringLiteral("4 errors"));
}

void ChromeTest::aDismissedBannerStaysSilentUntilItsConditionEnds()
{
    BannerStack stack(m_theme);
    const auto post = [&stack] {
        stack.post(QStringLiteral("k"), BannerKind::Caution, QStringLiteral("cause"), {}, QStringLiteral("Fix"));
    };
    post();
    Q_EMIT stack.findChildren<Banner *>().first()->dismissed();
    QCOMPARE(stack.count(), 0);
    post();
    QCOMPARE(stack.count(), 0);
    stack.clear(QStringLiteral("k"));
    post();
    QCOMPARE(stack.count(), 1);
}

void ChromeTest::valueFieldKeepsItsWidth()
{
    for (const auto look : {ValueLabel::Look::Card, ValueLabel::Look::Line}) {
        ValueLabel label(m_theme, look, QStringLiteral("velocity"), QStringLiteral("rpm"));
        QCOMPARE(label.value(), QString(UnknownMark));
        const int width = label.sizeHint().width();
        for (const double value : {0.0, 7.0, -1500.0, 88888.0}) {
            label.setValue(formatNumber(value));
            QCOMPARE(label.sizeHint().width(), width);
        }
        label.clear();
        QCOMPARE(label.value(), QString(UnknownMark));
    }
}

void ChromeTest::aCaptionStandsBesideItsOwnNumber()
{
    ValueLabel label(m_theme, ValueLabel::Look::Line, QStringLiteral("velocity"), {});
    label.setWidest(formatNumber(-8888888));
    label.setValue(formatNumber(-60000)); // for a moment
    for (int i = 0; i < 100; ++i)
        label.setValue(QStringLiteral("0"));
    label.resize(label.sizeHint());
    const QImage image = label.grab().toImage();
    const QRgb ground = image.pixel(0, 0);
    int empty = 0;
    int widest = 0; // of the columns without a stroke behind the first stroke
    bool begun = false;
    for (int x = 0; x < image.width(); ++x) {
        bool inked = false;
        for (int y = 0; y < image.height() && !inked; ++y)
            inked = image.pixel(x, y) != ground;
        if (inked && begun)
            widest = std::max(widest, empty);
        begun = begun || inked;
        empty = inked ? 0 : empty + 1;
    }
    QVERIFY(begun);
    QVERIFY2(widest < m_theme.theme().u(14), qPrintable(QString::number(widest)));
}

void ChromeTest::sparklineRangeIgnoresGaps()
{
    Sparkline line(m_theme, TraceRole::Velocity);
    QVERIFY(!line.range());
    line.setValues({std::nan("")});
    QVERIFY(!line.range());
    line.setValues({std::nan(""), 3, -2});
    QCOMPARE(line.range()->first, -2.0);
    QCOMPARE(line.range()->second, 3.0);
}

void ChromeTest::sparklineKeepsItsCapacity()
{
    Sparkline line(m_theme, TraceRole::Velocity);
    line.setCapacity(10);
    std::deque<double> values(100);
    std::iota(values.begin(), values.end(), 0.0);
    line.setValues(values);
    QCOMPARE(line.range()->first, 90.0);
    line.resize(80, 30);
    QVERIFY(line.grab().toImage() != Sparkline(m_theme, TraceRole::Velocity).grab(QRect(0, 0, 80, 30)).toImage());
}

void ChromeTest::aConstantIsALineAndNoBlock()
{
    const auto inked = [this](std::deque<double> values) {
        Sparkline line(m_theme, TraceRole::Velocity);
        line.setCapacity(20);
        line.resize(80, 30);
        const QImage empty = line.grab().toImage();
        line.setValues(std::move(values));
        const QImage drawn = line.grab().toImage();
        int count = 0;
        for (int y = 0; y < drawn.height(); ++y)
            count += drawn.pixel(40, y) != empty.pixel(40, y) ? 1 : 0;
        return count;
    };
    QVERIFY2(inked(std::deque<double>(20, 0.0)) <= 4, "the line alone");
    std::deque<double> rising(20);
    std::iota(rising.begin(), rising.end(), 0.0);
    QVERIFY(inked(rising) > 8);
}

void ChromeTest::searchFieldLetsEscThrough()
{
    KeyCatcher window;
    SearchField field(m_theme, QStringLiteral("Search 55 parameters"), &window);
    field.setText(QStringLiteral("gain"));
    QTest::keyClick(&field, Qt::Key_Escape);
    QVERIFY(field.text().isEmpty());
    QCOMPARE(window.caught, 1);
}

void ChromeTest::cardOpensByEnterAndNotBySpace()
{
    Card card(m_theme, QStringLiteral("DMC60C #5"));
    card.setActivatable(true);
    QSignalSpy activated(&card, &Card::activated);
    QTest::keyClick(&card, Qt::Key_Space);
    QCOMPARE(activated.count(), 0);
    QTest::keyClick(&card, Qt::Key_Return);
    QTest::mouseClick(&card, Qt::LeftButton, {}, QPoint(5, 5));
    QCOMPARE(activated.count(), 2);
}

void ChromeTest::primaryButtonIsAsWideAsItsWidestText()
{
    CommandButton button(m_theme, Symbol::Play, QStringLiteral("Run"));
    button.setPrimary(true);
    button.setKeyHint(QStringLiteral("F5"));
    button.setTextVariants({QStringLiteral("Run"), QStringLiteral("Write and run")});
    const int width = button.sizeHint().width();
    button.setText(QStringLiteral("Write and run"));
    QCOMPARE(button.sizeHint().width(), width);
}

void ChromeTest::aPressThatWasMeantForTheRoleBeforeIsNone()
{
    CommandButton button(m_theme, QStringLiteral("Start"));
    const QSignalSpy clicked(&button, &QPushButton::clicked);
    button.show();
    QApplication::setDoubleClickInterval(60'000);
    button.setRole(QStringLiteral("Start"));
    QTest::mouseClick(&button, Qt::LeftButton);
    QCOMPARE(clicked.count(), 1);
    button.setRole(QStringLiteral("End"));
    QCOMPARE(button.accessibleName(), QStringLiteral("End"));
    QTest::mouseClick(&button, Qt::LeftButton);
    QTest::mouseDClick(&button, Qt::LeftButton);
    QCOMPARE(clicked.count(), 1);
    QApplication::setDoubleClickInterval(1);
    button.changeRole();
    QTRY_VERIFY(!button.isFresh());
    QTest::mouseClick(&button, Qt::LeftButton);
    QCOMPARE(clicked.count(), 2);
}

void ChromeTest::aNoticeThatComesUnderThePointerIsNotAnswered()
{
    BannerStack stack(m_theme);
    stack.show();
    QSignalSpy acted(&stack, &BannerStack::actionTriggered);
    for (const char *key : {"b", "a"})
        stack.post(QString::fromLatin1(key), BannerKind::Caution, QString::fromLatin1(key), {}, QStringLiteral("Fix"));
    const auto click = [&stack](const char *text) {
        for (QPushButton *button : stack.findChildren<QPushButton *>()) {
            if (button->isVisible() && button->text() == QLatin1String(text))
                return QTest::mouseClick(button, Qt::LeftButton);
        }
        QFAIL(text);
    };
    click("Fix");
    QCOMPARE(acted.count(), 1);
    QApplication::setDoubleClickInterval(60'000);
    stack.post(QStringLiteral("a"), BannerKind::Caution, QStringLiteral("a"), {}, QStringLiteral("Cancel"));
    click("Cancel");
    QCOMPARE(acted.count(), 1);
    stack.clear(QStringLiteral("a"));
    click("Fix");
    click("Dismiss");
    QCOMPARE(acted.count(), 1);
    QCOMPARE(stack.count(), 1);
}

void ChromeTest::anEmptyPageShowsItsWholeSentence()
{
    const QString sentence(
        QStringLiteral("Open a link, or the simulated bench from the menu; its signals appear here. "));
    EmptyState page(m_theme, Symbol::Play, QStringLiteral("No device yet"), sentence.repeated(3));
    page.resize(1200, 600);
    page.show();
    const QLabel *text = page.findChildren<QLabel *>().back();
    QCOMPARE(text->text(), sentence.repeated(3));
    QVERIFY(text->height() >= text->heightForWidth(text->width()));
}

MB_WINDOW_TEST(ChromeTest);
#include "tst_chrome.moc"
