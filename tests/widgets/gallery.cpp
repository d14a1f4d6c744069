// SPDX-License-Identifier: GPL-3.0-or-later
// gallery DIR: renders every building block in both themes and at 200 % font into DIR.
#include "gallery.h"
#include "support/utf8.h"

#include "widgets/common/applytheme.h"
#include "widgets/common/banner.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/headerbar.h"
#include "widgets/common/labels.h"
#include "widgets/common/noticestrip.h"
#include "widgets/common/segmented.h"

#include <QApplication>
#include <QDir>
#include <QGridLayout>
#include <QMenu>
#include <QTest>

using namespace mb;

namespace {

HeaderBar *header(const ThemeSource &theme, const LampStatus &lamp, int notices, bool recording)
{
    auto *bar = new HeaderBar(theme);
    LinkStatus can{s("can0"), GlyphState::Online, {}, 0.14, {}, 0, true, {}};
    LinkStatus sick{s("can1"), GlyphState::Warning, {}, 0.06, {}, 7, false, {}};
    LinkStatus serial{s("ttyUSB0"), GlyphState::Online, {}, {}, s("61 Hz"), 0, true, {}};
    LinkStatus down{s("spi0"), GlyphState::Online, {}, {}, s("182 Hz"), 0, true, {}};
    bar->setLinks({can, notices > 0 ? sick : can, serial, down});
    bar->setMenu(new QMenu(bar));
    bar->setNotices(notices);
    bar->setRecording(recording ? s("REC 12:41") : QString());
    bar->setLampStatus(lamp);
    return bar;
}

void render(QWidget *page, const QSize &size, const QString &path)
{
    page->setAttribute(Qt::WA_StyledBackground);
    page->setProperty("surface", s("window"));
    page->resize(size);
    page->show();
    QTest::qWait(60);
    page->grab().save(path);
    delete page;
}

void renderAll(const Theme &theme, const QString &prefix, double zoom)
{
    applyTheme(*qApp, theme);
    const ThemeSource source(theme);
    const auto size = [zoom](int w, int h) { return QSize(static_cast<int>(w * zoom), static_cast<int>(h * zoom)); };
    render(chromePage(source), size(1440, 760), prefix + s("-chrome.png"));
    render(lampPage(source), size(1440, 172), prefix + s("-lamp.png"));
    render(controlsPage(source), size(1440, 700), prefix + s("-controls.png"));
    render(statesPage(source), size(1000, 560), prefix + s("-states.png"));
    render(doctorPage(source, false), size(1280, 560), prefix + s("-doctor.png"));
    render(doctorPage(source, true), size(1280, 560), prefix + s("-doctor-empty.png"));
    render(livePlotPage(source), size(1000, 760), prefix + s("-live.png"));
    render(trialPlotPage(source), size(700, 560), prefix + s("-trial.png"));
    render(responsePage(source), size(1240, 740), prefix + s("-response.png"));
    render(batteryPage(source), size(900, 860), prefix + s("-battery.png"));
}

} // namespace

QWidget *chromePage(const ThemeSource &theme)
{
    auto *page = new QWidget;
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    using namespace std::chrono_literals;
    column->addWidget(header(theme, {LampState::Safe, {}, {}, true}, 0, false));
    column->addWidget(header(theme, {LampState::Safe, {}, {}, false}, 0, false));
    column->addWidget(header(theme, {LampState::Armed, s("#5 velocity"), 272s, true}, 2, false));
    auto *stripe = new DemoStripe(theme);
    stripe->setSources(s("simulated bench, seed 7"), {});
    column->addWidget(stripe);
    auto *replayed = new DemoStripe(theme);
    replayed->setSources({}, {s("run.log")});
    column->addWidget(replayed);
    column->addWidget(header(theme, {LampState::Moving, s("4 motors"), {}, true}, 1, true));
    auto *stopped = header(theme, {LampState::Stopped, {}, {}, true}, 0, false);
    column->addWidget(stopped);
    column->addWidget(header(theme, {LampState::Stopping, s("until it is seen"), {}, true}, 0, false));
    column->addWidget(header(theme, {LampState::MayTurn, s("#3: cut its power"), {}, false}, 1, false));
    auto *folded = header(theme, {LampState::Safe, {}, {}, true}, 2, false);
    folded->setFixedWidth(theme.theme().u(860));
    column->addWidget(folded);
    auto *holding = header(theme, {LampState::Safe, {}, {}, true}, 0, false);
    holding->lamp().setHoldMilliseconds(150);
    column->addWidget(holding);
    QMetaObject::invokeMethod(
        &holding->lamp(), [lamp = &holding->lamp()] { lamp->click(); }, Qt::QueuedConnection);
    auto *tabs = new PageTabs(theme);
    for (const char *name : {"Overview", "Parameters", "Tune", "Design", "Plots", "Firmware", "Bus", "Log", "Reports"})
        tabs->addTab(s(name));
    tabs->setCurrentIndex(2);
    tabs->setUnavailable(3, s("Select a device"));
    column->addWidget(tabs);
    column->addWidget(new Banner(theme, BannerKind::Danger,
        s("Stopped: travel guard, predicted 4 310 of 4 096 counts."), s("Gains are back to trial #18.")));
    column->addStretch();
    return page;
}

/// What the lamp says of a motor that is not seen to stand.
QWidget *lampPage(const ThemeSource &theme)
{
    auto *page = new QWidget;
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(header(theme, {LampState::Stopped, {}, {}, true}, 0, false));
    column->addWidget(header(theme, {LampState::Stopping, s("until it is seen"), {}, true}, 0, false));
    column->addWidget(header(theme, {LampState::MayTurn, s("#3: cut its power"), {}, false}, 1, false));
    return page;
}

QWidget *statesPage(const ThemeSource &theme)
{
    auto *page = new QWidget;
    auto *column = new QVBoxLayout(page);
    auto *grid = new QGridLayout;
    for (int i = 0; i < GlyphStateCount; ++i) {
        const auto state = static_cast<GlyphState>(i);
        grid->addWidget(new StateGlyph(theme, state), i / 6, i % 6 * 2);
        grid->addWidget(textLabel(glyphWord(state), TextRole::Body, glyphTone(state), nullptr), i / 6, i % 6 * 2 + 1);
    }
    column->addLayout(grid);
    auto *icons = new QGridLayout;
    for (int i = 0; i < SymbolCount; ++i) {
        const auto symbol = static_cast<Symbol>(i);
        icons->addWidget(new IconButton(theme, symbol, symbolFile(symbol)), i / 19, i % 19);
    }
    column->addLayout(icons);
    auto *empty = new EmptyState(theme, Symbol::Wave, s("No signal yet"), s("Double click a signal, or drag it here."));
    empty->addAction(Symbol::Add, s("Add link"));
    empty->addAction(Symbol::Motor, s("Simulate"));
    column->addWidget(empty, 1);
    return page;
}

int main(int argc, char **argv)
{
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    const QString directory = argc > 1 ? QString::fromLocal8Bit(argv[1]) : s("gallery");
    QDir().mkpath(directory);
    QFont font = app.font();
    if (argc > 2)
        font.setFamily(QString::fromLocal8Bit(argv[2]));
    font.setPointSizeF(10);
    app.setFont(font);
    reportPicture().save(directory + s("/report.png"));
    renderAll(darkTheme(), directory + s("/dark"), 1);
    renderAll(lightTheme(), directory + s("/light"), 1);
    font.setPointSizeF(20);
    app.setFont(font);
    renderAll(darkTheme(20), directory + s("/dark200"), 2);
    return 0;
}
