// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/icons.h"
#include "widgets/common/stateglyph.h"
#include "widgets/common/systemtheme.h"

#include <QApplication>
#include <QFile>
#include <QPainter>
#include <QRegularExpression>
#include <QTest>
#include <functional>
#include <set>

using namespace mb;

namespace {

QImage painted(const std::function<void(QPainter &)> &paint, int side = 24)
{
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paint(painter);
    painter.end();
    return image;
}

struct DesktopColours {
    const char *name;
    QRgb window, base, button, text, highlight, link;
};

/// As desktops have them: usual ones, those for high contrast, and some that nobody should have chosen.
constexpr DesktopColours desktops[] = {
    {"Fusion", 0xEFEFEF, 0xFFFFFF, 0xEFEFEF, 0x000000, 0x308CC6, 0x0000FF},
    {"Adwaita", 0xF6F5F4, 0xFFFFFF, 0xF6F5F4, 0x2E3436, 0x3584E4, 0x1B6ACB},
    {"Breeze dark", 0x31363B, 0x232629, 0x31363B, 0xEFF0F1, 0x3DAEE9, 0x2980B9},
    {"white on black", 0x000000, 0x000000, 0x000000, 0xFFFFFF, 0x1AEBFF, 0xFFFF00},
    {"black on white", 0xFFFFFF, 0xFFFFFF, 0xFFFFFF, 0x000000, 0x37006E, 0x00009F},
    {"yellow on black", 0x000000, 0x000000, 0x000000, 0xFFFF00, 0x00FF00, 0x00FFFF},
    {"grey on grey", 0x808080, 0x909090, 0x707070, 0x606060, 0x888888, 0x7A7A7A},
    {"dark fields in a light window", 0xF0F0F0, 0x202020, 0xD0D0D0, 0x101010, 0xFFC000, 0xC0C0FF},
};

QPalette paletteOf(const DesktopColours &desktop)
{
    QPalette palette;
    palette.setColor(QPalette::Window, QColor(desktop.window));
    for (const auto role : {QPalette::Base, QPalette::AlternateBase})
        palette.setColor(role, QColor(desktop.base));
    palette.setColor(QPalette::Button, QColor(desktop.button));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(role, QColor(desktop.text));
    palette.setColor(QPalette::Highlight, QColor(desktop.highlight));
    palette.setColor(QPalette::Link, QColor(desktop.link));
    return palette;
}

/// All that a window may have, by a name for the row of a test.
std::vector<std::pair<QString, Theme>> everyTheme()
{
    std::vector<std::pair<QString, Theme>> all;
    for (const Theme &theme : {darkTheme(), lightTheme(), contrastTheme()})
        all.emplace_back(theme.name, theme);
    for (const DesktopColours &desktop : desktops)
        all.emplace_back(QString::fromLatin1(desktop.name), systemTheme(paletteOf(desktop)));
    return all;
}

int inkedPixels(const QImage &image)
{
    int inked = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            inked += qAlpha(image.pixel(x, y)) > 128 ? 1 : 0;
    }
    return inked;
}

} // namespace

class ThemeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void contrasts_data();
    void contrasts();
    void highContrastIsHigh();
    void theDesktopsColoursAreKeptWhereTheyCanBeRead();
    void tracesStandOutFromTheCanvas();
    void sheetKnowsEveryToken();
    void lengthsFollowTheFont();
    void sourceTellsOnlyOfChanges();
    void everyStateHasAShapeAndAWord();
    void statesOfDevicesDifferInShapeNotOnlyInColour();
    void everySymbolIsDrawn();
};

void ThemeTest::contrasts_data()
{
    QTest::addColumn<QColor>("ink");
    QTest::addColumn<QColor>("ground");
    QTest::addColumn<double>("least");
    for (const auto &[called, t] : everyTheme()) {
        const auto row = [&called = called](const char *name, const QColor &ink, const QColor &ground, double least) {
            QTest::addRow("%s: %s", qPrintable(called), name) << ink << ground << least;
        };
        const std::pair<const char *, QColor> grounds[]
            = {{"canvas", t.canvas}, {"window", t.window}, {"head", t.head}, {"panel", t.panel}};
        for (const auto &[place, ground] : grounds) {
            for (const Tone tone :
                {Tone::Text, Tone::Dim, Tone::Faint, Tone::Accent, Tone::Ok, Tone::Caution, Tone::Danger})
                row(qPrintable(QStringLiteral("tone %1 on %2").arg(int(tone)).arg(QLatin1String(place))), t.tone(tone),
                    ground, 4.5);
            row(qPrintable(QStringLiteral("outline on %1").arg(QLatin1String(place))), t.outline, ground, 3.0);
        }
        for (const QColor &banner : {t.bannerCaution, t.bannerDanger, t.bannerOk, t.bannerInfo}) {
            row("text on banner", t.text, banner, 4.5);
            row("dim on banner", t.dim, banner, 4.5);
        }
        row("caution on its banner", t.caution, t.bannerCaution, 4.5);
        row("text on selection", t.text, t.sel, 4.5);
        row("text on control", t.text, t.control, 4.5);
        row("text on hover", t.text, t.hover, 4.5);
        row("text on edited row", t.text, t.editedTint, 4.5);
        row("danger on error row", t.danger, t.errorTint, 4.5);
        row("primary", t.onFill, t.fill, 4.5);
        row("stop", t.onFill, t.stop, 4.5);
        row("armed", t.onArmed, t.armed, 4.5);
        row("stripe", t.onFill, t.demo, 4.5);
        row("stripe alternate", t.onFill, t.demoAlternate, 4.5);
    }
}

void ThemeTest::contrasts()
{
    QFETCH(QColor, ink);
    QFETCH(QColor, ground);
    QFETCH(double, least);
    const double found = contrast(ink, ground);
    QVERIFY2(found >= least,
        qPrintable(QStringLiteral("%1 on %2: %3").arg(ink.name(), ground.name()).arg(found, 0, 'f', 2)));
}

/// Text 7:1 on everything that carries text, and edges of controls as text elsewhere.
void ThemeTest::highContrastIsHigh()
{
    double least = 21.0;
    int high = 0;
    for (const auto &[called, t] : everyTheme()) {
        const bool own = t.name == QLatin1String("contrast");
        if (!own && !called.contains(QStringLiteral(" on black")) && !called.contains(QStringLiteral("black on ")))
            continue;
        ++high;
        for (const QColor &ground : {t.canvas, t.window, t.head, t.panel, t.control, t.hover, t.sel}) {
            for (const QColor &ink : {t.text, t.dim, t.faint, t.ok, t.caution, t.danger}) {
                const bool onSelection = ground == t.sel && ink != t.text;
                if (onSelection && ground != t.canvas)
                    continue;
                least = std::min(least, contrast(ink, ground));
                QVERIFY2(contrast(ink, ground) >= 7.0,
                    qPrintable(QStringLiteral("%1: %2 on %3").arg(called, ink.name(), ground.name())));
            }
        }
        QVERIFY(contrast(t.outline, t.window) >= 4.5 && contrast(t.onFill, t.stop) >= 7.0);
    }
    QCOMPARE(high, 4);
    qInfo("least contrast of text in high contrast: %.1f", least);
}

void ThemeTest::theDesktopsColoursAreKeptWhereTheyCanBeRead()
{
    const Theme theme = systemTheme(paletteOf(desktops[3]));
    QCOMPARE(theme.window, QColor(Qt::black));
    QCOMPARE(theme.canvas, QColor(Qt::black));
    QCOMPARE(theme.text, QColor(Qt::white));
    QCOMPARE(theme.accent, QColor(Qt::yellow));
    QVERIFY(isHighContrast(paletteOf(desktops[3])) && isHighContrast(paletteOf(desktops[4])));
    QVERIFY(!isHighContrast(paletteOf(desktops[0])) && !isHighContrast(paletteOf(desktops[1])));
    QCOMPARE(themeNamed({}, paletteOf(desktops[3]), 10).name, systemThemeName()); // asked for by the desktop
    QCOMPARE(themeNamed({}, paletteOf(desktops[1]), 10).name, QStringLiteral("dark"));
}

void ThemeTest::tracesStandOutFromTheCanvas()
{
    for (const auto &[called, theme] : everyTheme()) {
        std::set<QRgb> different;
        for (const QColor &trace : theme.traces) {
            QVERIFY2(contrast(trace, theme.canvas) >= 3.4, qPrintable(called + QLatin1Char(' ') + trace.name()));
            different.insert(trace.rgb());
        }
        QCOMPARE(different.size(), theme.traces.size());
        if (theme.name != systemThemeName())
            QVERIFY(different.count(theme.accent.rgb()) == 0);
    }
}

void ThemeTest::sheetKnowsEveryToken()
{
    QFile file(QStringLiteral(":/style.qss"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString filled = fillStyleSheet(QString::fromUtf8(file.readAll()), darkTheme());
    const QString rules = QString(filled).remove(
        QRegularExpression(QStringLiteral("/\\*.*?\\*/"), QRegularExpression::DotMatchesEverythingOption));
    QVERIFY2(!rules.contains(QLatin1Char('@')), qPrintable(rules.mid(rules.indexOf(QLatin1Char('@')), 30)));
    static const QRegularExpression picture(QStringLiteral("url\\((:[^)]+)\\)"));
    for (auto it = picture.globalMatch(rules); it.hasNext();) {
        const QString path = it.next().captured(1);
        QVERIFY2(QFile::exists(path), qPrintable(path));
    }
}

void ThemeTest::lengthsFollowTheFont()
{
    QCOMPARE(darkTheme(10).u(32), 32);
    QCOMPARE(darkTheme(20).u(32), 64);
    QCOMPARE(darkTheme(6).u(1), 1);
    QCOMPARE(fillStyleSheet(QStringLiteral("a { width: 12u; font-size: 0.85f; color: #0F2u; }"), darkTheme(20)),
        QStringLiteral("a { width: 24px; font-size: 17.00pt; color: #0F2u; }"));
}

void ThemeTest::sourceTellsOnlyOfChanges()
{
    ThemeSource source(darkTheme());
    int told = 0;
    connect(&source, &ThemeSource::changed, this, [&told] { ++told; });
    source.setTheme(darkTheme());
    QCOMPARE(told, 0);
    source.setTheme(lightTheme());
    source.setTheme(lightTheme(12));
    QCOMPARE(told, 2);
}

void ThemeTest::everyStateHasAShapeAndAWord()
{
    for (int i = 0; i < GlyphStateCount; ++i) {
        const auto state = static_cast<GlyphState>(i);
        const QImage image = painted([&](QPainter &p) { paintGlyph(p, QRectF(0, 0, 24, 24), state, Qt::white); });
        QVERIFY2(inkedPixels(image) > 20, qPrintable(QString::number(i)));
        QVERIFY(!glyphWord(state).isEmpty());
        QVERIFY(inkedPixels(glyphIcon(state, lightTheme()).pixmap(24, 24).toImage()) > 20);
    }
}

void ThemeTest::statesOfDevicesDifferInShapeNotOnlyInColour()
{
    std::vector<QImage> shapes;
    for (const GlyphState state :
        {GlyphState::Online, GlyphState::Moving, GlyphState::Bootloader, GlyphState::Duplicate, GlyphState::Unassigned,
            GlyphState::Fault, GlyphState::Gone, GlyphState::Stored, GlyphState::Edited, GlyphState::Assumed})
        shapes.push_back(painted([&](QPainter &p) { paintGlyph(p, QRectF(0, 0, 24, 24), state, Qt::white); }));
    for (std::size_t a = 0; a < shapes.size(); ++a) {
        for (std::size_t b = a + 1; b < shapes.size(); ++b)
            QVERIFY(shapes[a] != shapes[b]);
    }
}

void ThemeTest::everySymbolIsDrawn()
{
    std::set<QString> files;
    for (int i = 0; i < SymbolCount; ++i) {
        const auto symbol = static_cast<Symbol>(i);
        const QImage image = painted([&](QPainter &p) { paintSymbol(p, QRectF(0, 0, 24, 24), symbol, Qt::red); });
        QVERIFY2(inkedPixels(image) > 8, qPrintable(symbolFile(symbol)));
        files.insert(symbolFile(symbol));
    }
    QCOMPARE(int(files.size()), SymbolCount);
    QVERIFY(inkedPixels(applicationIcon().pixmap(32, 32).toImage()) > 300);
}

MB_WINDOW_TEST(ThemeTest);
#include "tst_theme.moc"
