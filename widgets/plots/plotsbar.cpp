// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotsbar.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"
#include "widgets/plots/recordingcontrol.h"

#include <QComboBox>
#include <QMenu>

#include <array>

namespace mb {
namespace {

constexpr std::array windowChoices{0.1, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 300.0, 1800.0, 3600.0, 28800.0, 86400.0};

QString windowText(double seconds)
{
    if (seconds < 1.0)
        return PlotsBar::tr("window %1 ms").arg(formatNumber(seconds * 1000.0));
    if (seconds < 60.0)
        return PlotsBar::tr("window %1 s").arg(formatNumber(seconds));
    return seconds < 3600.0 ? PlotsBar::tr("window %1 min").arg(formatNumber(seconds / 60.0))
                            : PlotsBar::tr("window %1 h").arg(formatNumber(seconds / 3600.0));
}

void popUpFrom(QAbstractButton *button, const PlotsBar::Fill &fill)
{
    QObject::connect(button, &QAbstractButton::clicked, button, [button, fill] {
        auto *menu = new QMenu(button);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        fill(*menu);
        menu->popup(button->mapToGlobal(QPoint(0, button->height())));
    });
}

} // namespace

PlotsBar::PlotsBar(
    Workbench &workbench, PlotStack &stack, const ThemeSource &theme, Fill layouts, Fill exports, QWidget *parent)
    : QWidget(parent)
    , m_stack(stack)
    , m_theme(theme)
    , m_pause(new CommandButton(theme, Symbol::Pause, tr("Pause view"), this))
    , m_recording(new RecordingControl(workbench, theme, this))
{
    const Theme &now = theme.theme();
    m_row = layoutIn<WrapLayout>(this, now.u(8), {now.u(12), now.u(6), now.u(12), now.u(6)});
    m_pause->setKeyHint(QStringLiteral("P"));
    m_pause->setTextVariants({tr("Pause view"), tr("Follow live")});
    m_pause->setToolTip(tr("The recording goes on."));
    m_row->addWidget(m_pause);
    m_row->addWidget(m_recording);
    m_row->addSpring();
    buildView();
    buildTools(layouts, exports);
    connect(m_pause, &QPushButton::clicked, this, [this] { m_stack.view().setLive(!m_stack.view().isLive()); });
    connect(&stack.view(), &PlotView::liveChanged, this, [this](bool live) {
        m_pause->setText(live ? tr("Pause view") : tr("Follow live"));
        m_pause->setSymbol(live ? Symbol::Pause : Symbol::Play);
    });
}

void PlotsBar::buildView()
{
    m_view = new Segmented(tr("View"), {tr("Time"), tr("X-Y"), tr("Spectrum")}, this);
    m_view->setToolTip(
        tr("Against time, one signal against another, or amplitude against frequency of what is seen or of A … B"));
    m_window = new QComboBox(this);
    m_window->setObjectName(QStringLiteral("plotsWindow"));
    for (const double seconds : windowChoices)
        m_window->addItem(windowText(seconds), seconds);
    m_window->setCurrentIndex(m_window->findData(m_stack.view().window()));
    m_window->setAccessibleName(tr("Length of the time axis"));
    m_row->addWidget(m_view);
    m_row->addWidget(m_window);
    connect(m_view, &Segmented::currentChanged, this, &PlotsBar::viewChosen);
    connect(m_window, qOverload<int>(&QComboBox::activated), this,
        [this](int place) { m_stack.view().setWindow(windowChoices.at(static_cast<std::size_t>(place))); });
    connect(&m_stack.view(), &PlotView::windowChanged, this,
        [this](double seconds) { m_window->setCurrentIndex(m_window->findData(seconds)); });
}

void PlotsBar::buildTools(const Fill &layouts, const Fill &exports)
{
    m_trigger = new IconButton(m_theme, Symbol::Trigger, tr("Trigger: stands still at an edge or a level"), this);
    m_trigger->setCheckable(true);
    m_trigger->setKeyHint(QStringLiteral("T"));
    auto *cursors = new IconButton(m_theme, Symbol::Cursors, tr("Cursors A and B"), this);
    cursors->setCheckable(true);
    cursors->setKeyHint(QStringLiteral("L"));
    auto *fit = new IconButton(m_theme, Symbol::Fit, tr("Fit time and value"), this);
    fit->setKeyHint(QStringLiteral("0"));
    auto *pin = new IconButton(m_theme, Symbol::Pin, tr("Keep what is seen as a reference"), this);
    auto *layout = new IconButton(m_theme, Symbol::Preferences, tr("Layouts: save, restore, reset"), this);
    m_export = new CommandButton(m_theme, Symbol::Export, tr("Export"), this);
    m_export->setToolTip(tr("The picture as PNG, SVG or PDF; samples as CSV or MCAP"));
    for (QWidget *tool : std::initializer_list<QWidget *>{m_trigger, cursors, fit, pin, layout, m_export})
        m_row->addWidget(tool);
    popUpFrom(m_export, exports);
    popUpFrom(layout, layouts);
    connect(pin, &QToolButton::clicked, this, &PlotsBar::referencesWanted);
    connect(cursors, &QToolButton::toggled, &m_stack, &PlotStack::setCursorsShown);
    connect(&m_stack, &PlotStack::cursorsChanged, cursors,
        [this, cursors] { cursors->setChecked(m_stack.cursorsShown()); });
    connect(fit, &QToolButton::clicked, &m_stack, &PlotStack::fit);
    connect(m_trigger, &QToolButton::toggled, this, &PlotsBar::triggerToggled);
}

/// Symbols for what has one, where that saves a line.
void PlotsBar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    int needed = m_row->sizeHint().width();
    for (const CommandButton *button : {m_pause, m_export})
        needed += button->wordsSize().width() - button->sizeHint().width();
    needed += (m_row->count() - 1) * (m_theme.theme().u(8) - m_row->spacing());
    const bool narrow = needed > width();
    m_row->setSpacing(m_theme.theme().u(narrow ? 4 : 8));
    for (CommandButton *button : {m_pause, m_export})
        button->setIconOnly(narrow);
}

void PlotsBar::showView(int view)
{
    m_view->setCurrent(view);
}

void PlotsBar::togglePause()
{
    m_pause->click();
}

void PlotsBar::toggleTrigger()
{
    m_trigger->toggle();
}

void PlotsBar::showTrigger(bool armed)
{
    const QSignalBlocker quiet(m_trigger);
    m_trigger->setChecked(armed);
}

} // namespace mb
