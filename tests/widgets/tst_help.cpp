// SPDX-License-Identifier: GPL-3.0-or-later
// The help: every page is there, its links and drawings lead somewhere, and it wears the theme.
#include "model/family.h"
#include "model/registry.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/help/helpbrowser.h"
#include "widgets/help/helptopics.h"
#include "widgets/help/helpwindow.h"

#include <QApplication>
#include <QListWidget>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <QTextDocument>

using namespace mb;

class HelpTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyTopicHasAPage();
    void everyFamilyHasAHardwarePage();
    void hardwarePagesSayWhatTheyMust();
    void linksBetweenPagesLeadSomewhere();
    void drawingsWearTheTheme();
    void oneWindowIsOpenedOnce();
    void aPictureForPeople_data();
    void aPictureForPeople();
};

void HelpTest::everyTopicHasAPage()
{
    const ThemeSource theme{darkTheme()};
    HelpBrowser browser(theme);
    for (const HelpTopic &topic : helpTopics()) {
        QVERIFY2(browser.showPage(topic.key), qPrintable(topic.key));
        QVERIFY2(browser.toPlainText().size() > 500, qPrintable(topic.key));
    }
    QVERIFY(!browser.showPage(QStringLiteral("nothing")));
}

void HelpTest::everyFamilyHasAHardwarePage()
{
    for (const Family *family : families())
        QVERIFY2(!hardwareTopic(family->key).isEmpty(), std::string(family->key).c_str());
}

void HelpTest::hardwarePagesSayWhatTheyMust()
{
    const ThemeSource theme{darkTheme()};
    HelpBrowser browser(theme);
    for (const Family *family : families()) {
        QVERIFY(browser.showPage(hardwareTopic(family->key)));
        const QString text = browser.toPlainText();
        for (const char *word : {"Wiring", "damages", "Bootloader", "ounts"})
            QVERIFY2(text.contains(QLatin1String(word)), (std::string(family->key) + ": " + word).c_str());
    }
    QVERIFY(browser.showPage(QStringLiteral("hardware/quadquad2drv")));
    QVERIFY(browser.toPlainText().contains(QStringLiteral("3.3 V only")));
    QVERIFY(browser.toPlainText().contains(QStringLiteral("M1 and M2 only")));
}

void HelpTest::linksBetweenPagesLeadSomewhere()
{
    const ThemeSource theme{darkTheme()};
    HelpBrowser browser(theme);
    const QRegularExpression link(QStringLiteral("\\]\\(([^)#]+\\.md)\\)"));
    for (const HelpTopic &topic : helpTopics()) {
        QVERIFY(browser.showPage(topic.key));
        const QString source = browser.document()->toMarkdown();
        auto found = link.globalMatch(source);
        while (found.hasNext()) {
            const QString target = found.next().captured(1);
            (void)browser.showPage(topic.key);
            QSignalSpy shown(&browser, &HelpBrowser::pageShown);
            Q_EMIT browser.anchorClicked(QUrl(target));
            const bool ofProgrammers = target.startsWith(QLatin1String("../")) || target == QLatin1String("bench.md");
            QVERIFY2(shown.count() == 1 || ofProgrammers, qPrintable(topic.key + QStringLiteral(": ") + target));
        }
    }
}

void HelpTest::drawingsWearTheTheme()
{
    for (const bool dark : {true, false}) {
        const ThemeSource theme{dark ? darkTheme() : lightTheme()};
        HelpBrowser browser(theme);
        browser.resize(900, 700);
        QVERIFY(browser.showPage(QStringLiteral("hardware/dmc60c")));
        const auto image = browser.document()
                               ->resource(QTextDocument::ImageResource, QUrl(QStringLiteral("dmc60c.svg")))
                               .value<QImage>();
        QVERIFY(!image.isNull());
        QCOMPARE(QColor(image.pixel(1, 1)), theme.theme().canvas);
    }
}

void HelpTest::oneWindowIsOpenedOnce()
{
    const ThemeSource theme{darkTheme()};
    QWidget window;
    HelpWindow &first = HelpWindow::open(theme, window, QStringLiteral("safety"));
    QCOMPARE(first.topic(), QStringLiteral("safety"));
    HelpWindow &second = HelpWindow::open(theme, window, QStringLiteral("hardware/dmc60c"));
    QCOMPARE(&first, &second);
    QCOMPARE(second.topic(), QStringLiteral("hardware/dmc60c"));
    QCOMPARE(window.findChildren<HelpWindow *>().size(), 1);
}

void HelpTest::aPictureForPeople_data()
{
    QTest::addColumn<double>("points");
    QTest::newRow("100 %") << 10.0;
    QTest::newRow("200 %") << 20.0;
}

/// The list shows its titles whole, and the window stays on the screen.
void HelpTest::aPictureForPeople()
{
    QFETCH(double, points);
    const QFont before = QApplication::font();
    QFont font = before;
    font.setPointSizeF(points);
    QApplication::setFont(font);
    for (const bool dark : {true, false}) {
        const ThemeSource theme{dark ? darkTheme(points) : lightTheme(points)};
        applyTheme(*qApp, theme.theme());
        QWidget window;
        window.resize(1280, 800);
        HelpWindow &help = HelpWindow::open(theme, window, QStringLiteral("hardware/quadquad2drv"));
        QTest::qWait(0);
        auto *list = help.findChild<QListWidget *>();
        QVERIFY(list->sizeHintForColumn(0) <= list->viewport()->width());
        QVERIFY(help.width() <= 1280 && help.height() <= 800);
        const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
        if (!folder.isEmpty())
            help.grab().save(folder
                + QStringLiteral("/help-%1-%2.png")
                      .arg(points)
                      .arg(dark ? QStringLiteral("dark") : QStringLiteral("light")));
    }
    QApplication::setFont(before);
}

MB_WINDOW_TEST(HelpTest);
#include "tst_help.moc"
