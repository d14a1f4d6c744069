// SPDX-License-Identifier: GPL-3.0-or-later
// The help: every page is there in every language, its links, pictures and drawings lead somewhere, and it wears the theme.
#include "model/family.h"
#include "model/registry.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/help/helpbrowser.h"
#include "widgets/help/helpdrawing.h"
#include "widgets/help/helppages.h"
#include "widgets/help/helptopics.h"
#include "widgets/help/helpwindow.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFontMetricsF>
#include <QGlyphRun>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTranslator>

#include <algorithm>
#include <map>

using namespace mb;

namespace {

constexpr double leastLetters = 8.0; ///< of a drawing, in its own pixels: three quarters of the usual size

/// A language of the window while this lives, with the glyphs that its readers need.
class Spoken {
public:
    explicit Spoken(const QString &code)
        : m_font(QApplication::font())
    {
        if (!m_translator.load(QStringLiteral("motorbench_%1").arg(code), QStringLiteral(":/translations")))
            qFatal("no such language");
        const std::map<QString, QString> glyphs{{QStringLiteral("ja"), QStringLiteral("Noto Sans CJK JP")},
            {QStringLiteral("zh"), QStringLiteral("Noto Sans CJK SC")}};
        if (const auto found = glyphs.find(code); found != glyphs.end()) {
            QFont font = m_font;
            font.setFamilies({font.family(), found->second});
            QApplication::setFont(font);
        }
        QCoreApplication::installTranslator(&m_translator);
    }
    Spoken(const Spoken &) = delete;
    Spoken &operator=(const Spoken &) = delete;
    ~Spoken()
    {
        QCoreApplication::removeTranslator(&m_translator);
        QApplication::setFont(m_font);
    }

private:
    QTranslator m_translator;
    QFont m_font;
};

/// Says of itself that it is a language for which nobody has translated a page.
class Unheard : public QTranslator {
public:
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        const bool code = qstrcmp(context, "Languages") == 0 && qstrcmp(source, "en") == 0;
        return code ? QStringLiteral("xx") : QString();
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

void addLanguages()
{
    QTest::addColumn<QString>("code");
    for (const QString &file : QDir(QStringLiteral(":/translations")).entryList(QDir::Files, QDir::Name)) {
        const QString code = file.section(QLatin1Char('_'), 1).section(QLatin1Char('.'), 0, 0);
        QTest::newRow(qPrintable(code)) << code;
    }
}

QString headingOf(const HelpBrowser &browser)
{
    return browser.document()->firstBlock().text();
}

/// Of its words, without code.
QString proseOf(const QTextDocument &document)
{
    QString prose;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            if (!part.fragment().charFormat().fontFixedPitch())
                prose += part.fragment().text();
        }
        prose += QLatin1Char('\n');
    }
    return prose;
}

/// Characters for which no font has a shape.
QString shapeless(const QTextDocument &document)
{
    QString missing;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        for (const QGlyphRun &run : block.layout()->glyphRuns()) {
            if (run.glyphIndexes().contains(0))
                missing += block.text() + QLatin1Char('\n');
        }
    }
    return missing;
}

QStringList targetsIn(const QTextDocument &document, const char *pattern)
{
    QStringList targets;
    const QRegularExpression link{QLatin1String(pattern)};
    for (auto found = link.globalMatch(document.toMarkdown()); found.hasNext();)
        targets += found.next().captured(1);
    return targets;
}

} // namespace

class HelpTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyTopicHasAPage();
    void everyFamilyHasAHardwarePage();
    void hardwarePagesSayWhatTheyMust();
    void linksBetweenPagesLeadSomewhere_data() { addLanguages(); }
    void linksBetweenPagesLeadSomewhere();
    void thePageSpeaksTheLanguageOfTheWindow();
    void aPageThatNobodyHasTranslatedIsInEnglish();
    void aLinkToTheEnglishFiguresLeadsThere();
    void pagesAreSetInEachLanguage_data() { addLanguages(); }
    void pagesAreSetInEachLanguage();
    void picturesAreThere_data() { addLanguages(); }
    void picturesAreThere();
    void drawingsWearTheTheme();
    void labelsOfDrawingsFitInEachLanguage_data() { addLanguages(); }
    void labelsOfDrawingsFitInEachLanguage();
    void pagesThatWereShownAreForgotten();
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
    QFETCH(QString, code);
    const Spoken spoken(code);
    const ThemeSource theme{darkTheme()};
    HelpBrowser browser(theme);
    int followed = 0;
    for (const HelpTopic &topic : helpTopics()) {
        QVERIFY(browser.showPage(topic.key));
        for (const QString &target : targetsIn(*browser.document(), "\\]\\(([^) ]+\\.md(?:#[^) ]*)?)[) ]")) {
            if (target.contains(QLatin1String("://")))
                continue;
            (void)browser.showPage(topic.key);
            QSignalSpy shown(&browser, &HelpBrowser::pageShown);
            Q_EMIT browser.anchorClicked(QUrl(target));
            QVERIFY2(shown.count() == 1, qPrintable(topic.key + QStringLiteral(": ") + target));
            const QString there = browser.file();
            const bool own = helpFile(browser.topic()) == there;
            QVERIFY2(own, qPrintable(there));
            ++followed;
        }
    }
    QVERIFY(followed > 12);
}

void HelpTest::thePageSpeaksTheLanguageOfTheWindow()
{
    const ThemeSource theme{darkTheme()};
    QWidget window;
    HelpWindow &help = HelpWindow::open(theme, window, QStringLiteral("troubleshooting"));
    const auto &browser = *help.findChild<HelpBrowser *>();
    const auto &list = *help.findChild<QListWidget *>();
    const QString english = headingOf(browser);
    const QString englishRow = list.currentItem()->text();
    QCOMPARE(english, QStringLiteral("Troubleshooting"));
    {
        const Spoken german(QStringLiteral("de"));
        QTRY_VERIFY(headingOf(browser) != english);
        QCOMPARE(browser.file(), QStringLiteral(":/help/de/troubleshooting.md"));
        QCOMPARE(list.currentItem()->data(Qt::UserRole).toString(), QStringLiteral("troubleshooting"));
        QVERIFY(list.currentItem()->text() != englishRow);
        QCOMPARE(help.windowTitle(), QStringLiteral("Hilfe"));
    }
    const QString german = headingOf(browser);
    {
        const Spoken french(QStringLiteral("fr"));
        QTRY_COMPARE(browser.file(), QStringLiteral(":/help/fr/troubleshooting.md"));
        QVERIFY(headingOf(browser) != english && headingOf(browser) != german);
    }
    QTRY_COMPARE(headingOf(browser), english);
}

void HelpTest::aPageThatNobodyHasTranslatedIsInEnglish()
{
    Unheard translator;
    QCoreApplication::installTranslator(&translator);
    const ThemeSource theme{darkTheme()};
    HelpBrowser browser(theme);
    QVERIFY(browser.showPage(QStringLiteral("safety")));
    QCOMPARE(browser.file(), QStringLiteral(":/help/safety.md"));
    QCOMPARE(headingOf(browser).isEmpty(), false);
    QVERIFY(!hardwareTopic("dmc60c").isEmpty());
    QCoreApplication::removeTranslator(&translator);
}

/// Method and measurements are there once, and in no list.
void HelpTest::aLinkToTheEnglishFiguresLeadsThere()
{
    const Spoken german(QStringLiteral("de"));
    const ThemeSource theme{darkTheme()};
    QWidget window;
    HelpWindow &help = HelpWindow::open(theme, window, QStringLiteral("safety"));
    help.showTopic(QStringLiteral("tuning"));
    auto &browser = *help.findChild<HelpBrowser *>();
    auto &list = *help.findChild<QListWidget *>();
    QCOMPARE(browser.file(), QStringLiteral(":/help/de/tuning.md"));
    QCOMPARE(list.currentItem()->data(Qt::UserRole).toString(), QStringLiteral("tuning"));
    Q_EMIT browser.anchorClicked(QUrl(QStringLiteral("../tuning-results.md#where-it-stays-behind")));
    QCOMPARE(browser.file(), QStringLiteral(":/help/tuning-results.md"));
    QCOMPARE(browser.textCursor().block().text(), QStringLiteral("Where it stays behind"));
    QVERIFY(browser.verticalScrollBar()->value() > 0);
    QVERIFY(!list.currentItem());
    Q_EMIT browser.anchorClicked(
        QUrl(QStringLiteral("tuning.md"))); // no dead end, and in the language of the window again
    QCOMPARE(browser.file(), QStringLiteral(":/help/de/tuning.md"));
    QCOMPARE(list.currentItem()->data(Qt::UserRole).toString(), QStringLiteral("tuning"));
}

void HelpTest::pagesAreSetInEachLanguage()
{
    QFETCH(QString, code);
    const ThemeSource theme{darkTheme()};
    for (const HelpTopic &topic : helpTopics()) {
        HelpBrowser english(theme);
        english.resize(760, 600);
        english.show();
        QVERIFY(english.showPage(topic.key));
        const double widest = english.document()->documentLayout()->documentSize().width(); // of its blocks of code
        const Spoken spoken(code);
        HelpBrowser browser(theme);
        browser.resize(760, 600);
        browser.show();
        QVERIFY(browser.showPage(topic.key));
        QVERIFY2(browser.file().startsWith(QStringLiteral(":/help/%1/").arg(code)) || code == QLatin1String("en"),
            qPrintable(browser.file()));
        const QTextDocument &page = *browser.document();
        QVERIFY(page.documentLayout()->documentSize().height() > 300);
        const QString prose = proseOf(page);
        for (const char *mark : {"**", "](", "`"})
            QVERIFY2(
                !prose.contains(QLatin1String(mark)), qPrintable(topic.key + QLatin1Char(' ') + QLatin1String(mark)));
        QCOMPARE(shapeless(page), QString());
        const double width = page.documentLayout()->documentSize().width();
        QVERIFY2(width <= std::max(widest, 760.0) + 1.0,
            qPrintable(QStringLiteral("%1: %2 px, %3 in English").arg(topic.key).arg(width).arg(widest)));
    }
}

void HelpTest::picturesAreThere()
{
    QFETCH(QString, code);
    const Spoken spoken(code);
    const ThemeSource theme{lightTheme()};
    HelpBrowser browser(theme);
    browser.resize(700, 600);
    int seen = 0;
    auto topics = helpTopics();
    topics.push_back({QStringLiteral("bench"), {}});
    for (const HelpTopic &topic : topics) {
        QVERIFY(browser.showPage(topic.key));
        for (const QString &target : targetsIn(*browser.document(), "!\\[[^\\]]*\\]\\(([^) ]+)")) {
            const auto image = browser.document()->resource(QTextDocument::ImageResource, QUrl(target)).value<QImage>();
            QVERIFY2(!image.isNull(), qPrintable(topic.key + QStringLiteral(": ") + target));
            QVERIFY2(image.width() <= 700, qPrintable(target));
            ++seen;
        }
    }
    QCOMPARE(seen, 18); // four drawings, eight pictures, six of the page about the bench
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

void HelpTest::labelsOfDrawingsFitInEachLanguage()
{
    QFETCH(QString, code);
    const Spoken spoken(code);
    const QRegularExpression label(QStringLiteral("font-family=\"([^\"]*)\" font-size=\"([0-9.]+)\"( "
                                                  "font-weight=\"700\")? data-room=\"([0-9.]+)\"[^>]*>([^<]*)<"));
    int seen = 0;
    for (const QString &name : QDir(QStringLiteral(":/help/hardware")).entryList({QStringLiteral("*.svg")})) {
        QFile file(QStringLiteral(":/help/hardware/") + name);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString dressed = QString::fromUtf8(dressedDrawing(file.readAll(), lightTheme(), QApplication::font()));
        for (auto found = label.globalMatch(dressed); found.hasNext();) {
            const auto match = found.next();
            const double size = match.captured(2).toDouble();
            QFont font(match.captured(1));
            font.setPixelSize(100);
            font.setBold(!match.captured(3).isEmpty());
            const QString words = match.captured(5);
            const double width = QFontMetricsF(font).horizontalAdvance(words) * size / 100.0;
            QVERIFY2(width <= match.captured(4).toDouble() + 0.5, qPrintable(words));
            QVERIFY2(size >= leastLetters, qPrintable(QStringLiteral("%1: %2 px").arg(words).arg(size)));
            ++seen;
        }
    }
    QVERIFY(seen > 40);
}

void HelpTest::pagesThatWereShownAreForgotten()
{
    ThemeSource theme{lightTheme()};
    HelpBrowser browser(theme);
    for (const char *topic : {"first-hour", "safety", "tuning"})
        QVERIFY(browser.showPage(QString::fromLatin1(topic)));
    theme.setTheme(darkTheme());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCOMPARE(browser.findChildren<QTextDocument *>().size(), 1);
    QVERIFY(browser.findChildren<QTextDocument *>().contains(browser.document()));
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
    QTest::addColumn<QString>("code");
    QTest::addColumn<double>("points");
    for (const char *code : {"en", "de", "fr", "es", "ja", "zh"}) {
        QTest::addRow("%s, 100 %%", code) << QString::fromLatin1(code) << 10.0;
        QTest::addRow("%s, 200 %%", code) << QString::fromLatin1(code) << 20.0;
    }
}

/// The list shows its titles whole, and the window stays on the screen.
void HelpTest::aPictureForPeople()
{
    QFETCH(QString, code);
    QFETCH(double, points);
    const QFont before = QApplication::font();
    QFont font = before;
    font.setPointSizeF(points);
    QApplication::setFont(font);
    for (const bool dark : {true, false}) {
        const Spoken spoken(code);
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
                + QStringLiteral("/help-%1-%2-%3.png")
                      .arg(code)
                      .arg(points)
                      .arg(dark ? QStringLiteral("dark") : QStringLiteral("light")));
    }
    QApplication::setFont(before);
}

MB_WINDOW_TEST(HelpTest);
#include "tst_help.moc"
