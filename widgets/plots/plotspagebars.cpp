// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/segmented.h"
#include "widgets/plots/curveplot.h"
#include "widgets/plots/plotspage.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>

#include <array>

namespace mb {
namespace {

constexpr std::array windowChoices{0.1, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 300.0, 1800.0, 3600.0, 28800.0, 86400.0};

QString windowText(double seconds)
{
    if (seconds < 1.0)
        return PlotsPage::tr("window %1 ms").arg(formatNumber(seconds * 1000.0));
    if (seconds < 60.0)
        return PlotsPage::tr("window %1 s").arg(formatNumber(seconds));
    return seconds < 3600.0 ? PlotsPage::tr("window %1 min").arg(formatNumber(seconds / 60.0))
                            : PlotsPage::tr("window %1 h").arg(formatNumber(seconds / 3600.0));
}

} // namespace

QWidget *PlotsPage::buildBar()
{
    const Theme &theme = m_theme.theme();
    auto *bar = new QWidget(this);
    auto *row = new QHBoxLayout(bar);
    row->setContentsMargins(theme.u(12), theme.u(6), theme.u(12), theme.u(6));
    row->setSpacing(theme.u(8));
    m_pause = new CommandButton(m_theme, Symbol::Pause, tr("Pause view"), bar);
    m_pause->setKeyHint(QStringLiteral("P"));
    m_pause->setTextVariants({tr("Pause view"), tr("Follow live")});
    m_pause->setToolTip(tr("The recording goes on."));
    row->addWidget(m_pause);
    buildRecord(*row);
    row->addStretch(1);
    buildView(*row);
    buildTools(*row);
    connect(m_pause, &QPushButton::clicked, this, [this] { m_stack->setLive(!m_stack->isLive()); });
    connect(m_stack, &PlotStack::liveChanged, this, [this](bool live) {
        m_pause->setText(live ? tr("Pause view") : tr("Follow live"));
        m_pause->setSymbol(live ? Symbol::Pause : Symbol::Play);
    });
    return bar;
}

void PlotsPage::buildRecord(QHBoxLayout &row)
{
    m_record = new CommandButton(m_theme, Symbol::Record, tr("Record"), this);
    m_record->setKeyHint(QStringLiteral("R"));
    m_record->setTextVariants({tr("Record"), tr("Save")});
    m_record->hide();
    m_recordText = textLabel({}, TextRole::Caption, Tone::Dim, this);
    m_recordText->hide();
    row.addWidget(m_record);
    row.addWidget(m_recordText);
    connect(m_record, &QPushButton::clicked, this, &PlotsPage::toggleRecording);
}

void PlotsPage::buildView(QHBoxLayout &row)
{
    m_view = new Segmented(tr("View"), {tr("Time"), tr("X-Y"), tr("Spectrum")}, this);
    m_view->setToolTip(
        tr("Against time, one signal against another, or amplitude against frequency of what is seen or of A … B"));
    m_window = new QComboBox(this);
    m_window->setObjectName(QStringLiteral("plotsWindow"));
    for (const double seconds : windowChoices)
        m_window->addItem(windowText(seconds), seconds);
    m_window->setCurrentIndex(m_window->findData(m_stack->window()));
    m_window->setAccessibleName(tr("Length of the time axis"));
    row.addWidget(m_view);
    row.addWidget(m_window);
    connect(m_view, &Segmented::currentChanged, this, [this](int view) { showView(static_cast<View>(view)); });
    connect(m_window, qOverload<int>(&QComboBox::activated), this,
        [this](int place) { m_stack->setWindow(windowChoices.at(static_cast<std::size_t>(place))); });
    connect(m_stack, &PlotStack::windowChanged, this, [this](double seconds) {
        m_window->setCurrentIndex(m_window->findData(seconds));
        m_remember.start();
    });
}

void PlotsPage::buildTools(QHBoxLayout &row)
{
    m_triggerButton = new IconButton(m_theme, Symbol::Trigger, tr("Trigger: stands still at an edge or a level"), this);
    m_triggerButton->setCheckable(true);
    m_triggerButton->setKeyHint(QStringLiteral("T"));
    auto *cursors = new IconButton(m_theme, Symbol::Cursors, tr("Cursors A and B"), this);
    cursors->setCheckable(true);
    cursors->setKeyHint(QStringLiteral("L"));
    auto *fit = new IconButton(m_theme, Symbol::Fit, tr("Fit time and value"), this);
    fit->setKeyHint(QStringLiteral("0"));
    auto *pin = new IconButton(m_theme, Symbol::Pin, tr("Keep what is seen as a reference"), this);
    auto *layout = new IconButton(m_theme, Symbol::Preferences, tr("Layouts: save, restore, reset"), this);
    auto *save = new CommandButton(m_theme, Symbol::Export, tr("Export"), this);
    save->setToolTip(tr("The picture as PNG, SVG or PDF; samples as CSV or MCAP"));
    for (QWidget *tool : std::initializer_list<QWidget *>{m_triggerButton, cursors, fit, pin, layout, save})
        row.addWidget(tool);
    const auto popUp = [this](QAbstractButton *button, auto fill) {
        connect(button, &QAbstractButton::clicked, this, [this, button, fill] {
            auto *menu = new QMenu(button);
            menu->setAttribute(Qt::WA_DeleteOnClose);
            (this->*fill)(*menu);
            menu->popup(button->mapToGlobal(QPoint(0, button->height())));
        });
    };
    popUp(save, &PlotsPage::fillExportMenu);
    popUp(layout, &PlotsPage::fillLayoutMenu);
    connect(pin, &QToolButton::clicked, m_board, &PlotBoard::keepReferences);
    connect(cursors, &QToolButton::toggled, m_stack, &PlotStack::setCursorsShown);
    connect(m_stack, &PlotStack::cursorsChanged, this, [this, cursors] {
        cursors->setChecked(m_stack->cursorsShown());
        m_analysedAt = -1.0;
        showRows();
    });
    connect(fit, &QToolButton::clicked, m_stack, &PlotStack::fit);
    connect(m_triggerButton, &QToolButton::toggled, this, [this](bool on) {
        if (!on)
            triggerOff();
        else if (!m_trigger.isArmed() && !m_board->traces().empty())
            triggerOn(m_board->traces().front().id);
    });
}

void PlotsPage::addKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_P}, tr("pauses the plots, and goes on"), [this] { m_pause->click(); });
    keys->add({Qt::Key_0}, tr("fits time and value"),
        [this] { m_plots->currentWidget() == m_stack ? m_stack->fit() : curves(View::Spectrum).fit(); });
    keys->add({Qt::Key_L}, tr("cursors: arrows move one, C changes to the other"), [this] {
        m_stack->setCursorsShown(!m_stack->cursorsShown());
        if (m_stack->cursorsShown())
            m_stack->setFocus(Qt::ShortcutFocusReason);
    });
    keys->add({Qt::Key_T}, tr("watches for a trigger, or no more"), [this] { m_triggerButton->toggle(); });
    keys->add({Qt::Key_R}, tr("records, or ends the recording"), [this] {
        if (m_recorder)
            toggleRecording();
    });
    keys->note({Qt::Key_Plus, Qt::Key_Minus}, tr("in the plots: less or more time"));
    keys->note({Qt::Key_PageUp, Qt::Key_PageDown}, tr("in the plots: larger or smaller values"));
    keys->note({Qt::Key_N}, tr("in the plots: writes a note at this time"));
}

} // namespace mb
