// SPDX-License-Identifier: GPL-3.0-or-later
// A desktop whose colours change while the program runs: window, plots and icons follow at once, and nothing follows itself.
#include "support/windowtests.h"
#include "widgets/common/systemtheme.h"
#include "windowbench.h"

#include <QImage>
#include <QPalette>
#include <QProxyStyle>

#include <memory>

using namespace mb;
using namespace mb::test;

namespace {

constexpr double leastShare = 0.5; ///< of a window that has these surfaces; the rest is text, edges and curves

QPalette desktop(const QColor &window, const QColor &view, const QColor &text)
{
    QPalette palette;
    for (const auto role : {QPalette::Window, QPalette::Button, QPalette::AlternateBase, QPalette::ToolTipBase})
        palette.setColor(role, window);
    palette.setColor(QPalette::Base, view);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
        palette.setColor(role, text);
    palette.setColor(QPalette::Highlight, QColor(0x3D6EC4));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(0x3D6EC4));
    palette.setColor(QPalette::Shadow, text);
    return palette;
}

QPalette darkDesktop()
{
    return desktop(QColor(0x241434), QColor(0x1A0C28), QColor(0xF0ECF4));
}

QPalette lightDesktop()
{
    return desktop(QColor(0xF4ECD6), QColor(0xFFFAEC), QColor(0x1E180A));
}

QPalette contrastDesktop()
{
    return desktop(Qt::black, Qt::black, Qt::white);
}

/// How much of what is painted is a surface of a desktop: its window, its views, and the panels half way between them.
double share(QWidget &part, const QPalette &palette)
{
    const QImage image = part.grab().toImage().convertToFormat(QImage::Format_RGB32);
    const QColor window = palette.color(QPalette::Window);
    const QColor view = palette.color(QPalette::Base);
    const QRgb panel = systemTheme(palette).panel.rgb();
    int found = 0;
    for (int y = 0; y < image.height(); ++y) {
        const auto *line = reinterpret_cast<const QRgb *>(image.constScanLine(y));
        for (int x = 0; x < image.width(); ++x)
            found += line[x] == window.rgb() || line[x] == view.rgb() || line[x] == panel ? 1 : 0;
    }
    return static_cast<double>(found) / (image.width() * image.height());
}

/// Counts what the application is told of its palette.
class Told : public QObject {
public:
    Told() { qApp->installEventFilter(this); }
    [[nodiscard]] int count() const { return m_count; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (watched == qApp && event->type() == QEvent::ApplicationPaletteChange)
            ++m_count;
        return false;
    }

private:
    int m_count = 0;
};

/// What lies below the palette of a program: its style has the last word about it.
class DesktopBelow : public QProxyStyle {
public:
    DesktopBelow()
        : QProxyStyle(QStringLiteral("fusion"))
    {
    }
    void polish(QPalette &palette) override { palette = colours; }
    using QProxyStyle::polish;

    QPalette colours;
};

std::unique_ptr<Application> started(const QString &theme)
{
    Options options;
    options.demo = true;
    options.language = QStringLiteral("en");
    options.theme = theme;
    auto application = std::make_unique<Application>(*qApp, options);
    application->start();
    return application;
}

} // namespace

class DesktopColoursTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QApplication::setPalette(QPalette()); }
    void cleanup() { QApplication::setPalette(QPalette()); }
    void windowAndPlotsFollowTheDesktop();
    void whoHasAThemeOfTheProgramKeepsIt();
    void whoHasLeftTheDesktopsColoursByTheKeyKeepsThat_data();
    void whoHasLeftTheDesktopsColoursByTheKeyKeepsThat();
    void aDesktopOfHighContrastIsFollowedUnasked();
    void nothingFollowsItself();
    void aChangeBelowOurColoursIsNoticed();
};

void DesktopColoursTest::windowAndPlotsFollowTheDesktop()
{
    const auto application = started(QStringLiteral("system"));
    MainWindow &window = application->window();
    for (const PageId page : {PageId::Overview, PageId::Plots, PageId::Tune}) {
        window.showPage(page);
        for (const QPalette &palette : {darkDesktop(), lightDesktop(), contrastDesktop(), darkDesktop()}) {
            QApplication::setPalette(palette); // as the platform theme of Plasma does
            QTRY_VERIFY2(share(window, palette) > leastShare, qPrintable(QString::number(share(window, palette))));
            QVERIFY2(share(*window.page(page), palette) > leastShare,
                qPrintable(
                    QStringLiteral("%1: %2").arg(static_cast<int>(page)).arg(share(*window.page(page), palette))));
        }
    }
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (!folder.isEmpty()) {
        window.grab().save(folder + QStringLiteral("/desktop-dark.png"));
        QApplication::setPalette(lightDesktop());
        QTRY_VERIFY(share(window, lightDesktop()) > leastShare);
        window.grab().save(folder + QStringLiteral("/desktop-light.png"));
    }
}

void DesktopColoursTest::whoHasAThemeOfTheProgramKeepsIt()
{
    const auto application = started(QStringLiteral("dark"));
    MainWindow &window = application->window();
    const QPalette ours = QApplication::palette();
    QTRY_VERIFY(share(window, ours) > 0.3); // its panels are of other colours
    QApplication::setPalette(lightDesktop());
    QTRY_COMPARE(QApplication::palette().color(QPalette::Window), ours.color(QPalette::Window));
    QTRY_VERIFY(share(window, ours) > 0.3);
}

void DesktopColoursTest::whoHasLeftTheDesktopsColoursByTheKeyKeepsThat_data()
{
    QTest::addColumn<QString>("theme");
    QTest::newRow("as the desktop") << QStringLiteral("system");
    QTest::newRow("nothing chosen") << QString();
}

void DesktopColoursTest::whoHasLeftTheDesktopsColoursByTheKeyKeepsThat()
{
    QFETCH(const QString, theme);
    const auto application = started(theme);
    MainWindow &window = application->window();
    QApplication::setPalette(contrastDesktop());
    QTRY_VERIFY(share(window, contrastDesktop()) > leastShare);
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, Qt::Key_T, Qt::ControlModifier);
    const QColor ours = QApplication::palette().color(QPalette::Window);
    QVERIFY(ours != contrastDesktop().color(QPalette::Window));
    for (const QPalette &palette : {darkDesktop(), contrastDesktop()}) {
        QApplication::setPalette(palette);
        QTRY_COMPARE(QApplication::palette().color(QPalette::Window), ours);
    }
}

void DesktopColoursTest::aDesktopOfHighContrastIsFollowedUnasked()
{
    const auto application = started({});
    MainWindow &window = application->window();
    const QPalette ours = QApplication::palette();
    QApplication::setPalette(contrastDesktop());
    QTRY_VERIFY(share(window, contrastDesktop()) > leastShare);
    QApplication::setPalette(lightDesktop()); // and back to what was chosen
    QTRY_VERIFY(share(window, ours) > 0.3);
}

/// As GTK's platform theme exchanges the colours below those that a program has set: Qt resolves the program's palette anew, and says
/// so where one of its roles is another colour now.
void DesktopColoursTest::aChangeBelowOurColoursIsNoticed()
{
    auto *below = new DesktopBelow;
    below->colours = darkDesktop();
    qApp->setProperty("mbFusion", true); // this is the style
    QApplication::setStyle(below);
    const auto application = started(QStringLiteral("system"));
    MainWindow &window = application->window();
    QVERIFY(share(window, darkDesktop()) > leastShare);
    for (const QPalette &palette : {lightDesktop(), contrastDesktop(), darkDesktop()}) {
        below->colours = palette;
        QApplication::setPalette(QApplication::palette());
        QTRY_VERIFY2(share(window, palette) > leastShare, qPrintable(QString::number(share(window, palette))));
    }
    const Told told;
    QTest::qWait(200);
    QCOMPARE(told.count(), 0);
    qApp->setProperty("mbFusion", false);
}

void DesktopColoursTest::nothingFollowsItself()
{
    const auto application = started(QStringLiteral("system"));
    Told told;
    QApplication::setPalette(darkDesktop());
    QTRY_VERIFY(share(application->window(), darkDesktop()) > leastShare);
    const int after = told.count();
    QTest::qWait(200);
    QCOMPARE(told.count(), after);
    QCOMPARE(after, 2); // the desktop's, and ours made of it
}

MB_WINDOW_TEST(DesktopColoursTest);
#include "tst_desktopcolours.moc"
