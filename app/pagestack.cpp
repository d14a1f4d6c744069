// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pagestack.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/segmented.h"
#include "widgets/connection/deviceline.h"
#include "widgets/connection/livestatebar.h"
#include "widgets/control/arming.h"
#include "widgets/parameters/keepbar.h"

#include <QResizeEvent>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTimer>
#include <QWindow>

namespace mb {
namespace {

constexpr std::chrono::milliseconds againLater(200);
constexpr int tallEnough = 520;  ///< for the line of the device above its page
constexpr int roomyEnough = 900; ///< for one of limits and pins below it that all stand as they should

} // namespace

PageStack::PageStack(
    Workbench &workbench, Selection &selection, const Arming &arming, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_arming(arming)
    , m_theme(theme)
    , m_tabs(new PageTabs(theme, this))
    , m_tabsRow(new QHBoxLayout)
    , m_line(new DeviceLine(workbench, selection, theme, this))
    , m_states(new LiveStateBar(workbench, selection, theme, this))
    , m_pages(new QStackedWidget(this))
{
    setMinimumSize(1, 1); // as the docks
    m_tabs->setAccessibleName(tr("Pages"));
    m_tabsRow->addWidget(m_tabs, 1);
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    column->addLayout(m_tabsRow);
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(m_line);
    column->addWidget(m_states);
    column->addWidget(m_pages, 1);
    column->addWidget(new KeepBar(workbench, theme, this));
    connect(m_tabs, &QTabBar::currentChanged, this, &PageStack::followTab);
}

void PageStack::add(const QString &title, std::function<QWidget *(QWidget *)> make)
{
    auto *scroll = new QScrollArea(m_pages); // for large fonts in a small window
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    m_pages->addWidget(scroll);
    m_makers.push_back(std::move(make));
    const QSignalBlocker quiet(m_tabs); // the first is in front, and nobody has asked for it yet
    m_tabs->addTab(title);
}

void PageStack::addBeforeTabs(QWidget &button)
{
    m_tabsRow->insertWidget(0, &button);
}

void PageStack::addBesideTabs(QWidget &button)
{
    m_tabsRow->addWidget(&button);
}

void PageStack::addAbovePages(QWidget &strip)
{
    auto *column = static_cast<QBoxLayout *>(layout());
    column->insertWidget(column->indexOf(m_pages), &strip);
}

QWidget *PageStack::page(PageId id)
{
    auto *scroll = static_cast<QScrollArea *>(m_pages->widget(static_cast<int>(id)));
    if (!scroll->widget()) {
        scroll->setWidget(m_makers[static_cast<std::size_t>(id)](m_pages));
        Q_EMIT pageMade(id, scroll->widget());
    }
    return scroll->widget();
}

void PageStack::showPage(PageId id)
{
    if (!isAvailable(id)) {
        m_workbench.report(Severity::Info, title(id), m_tabs->tabToolTip(static_cast<int>(id)));
        return;
    }
    m_tabs->setCurrentIndex(static_cast<int>(id));
    followTab();
}

PageId PageStack::shown() const
{
    return static_cast<PageId>(m_tabs->currentIndex());
}

std::vector<PageId> PageStack::all() const
{
    std::vector<PageId> ids;
    for (int i = 0; i < m_tabs->count(); ++i)
        ids.push_back(static_cast<PageId>(i));
    return ids;
}

QString PageStack::title(PageId id) const
{
    return m_tabs->tabText(static_cast<int>(id));
}

void PageStack::setUnavailable(PageId id, const QString &reason)
{
    m_tabs->setUnavailable(static_cast<int>(id), reason);
}

bool PageStack::isAvailable(PageId id) const
{
    return m_tabs->isTabEnabled(static_cast<int>(id));
}

/// One a turn of the event loop, so that keys wait for one at most. Never while a motor may move: it may take longer than its lease.
void PageStack::makePages(int from)
{
    if (from >= m_pages->count())
        return;
    if (m_arming.state() != LampState::Safe && m_arming.state() != LampState::Stopped) {
        QTimer::singleShot(againLater, this, [this, from] { makePages(from); });
        return;
    }
    (void)page(static_cast<PageId>(from));
    QTimer::singleShot(0, this, [this, from] { makePages(from + 1); });
}

void PageStack::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (QWindow *const handle = window()->windowHandle())
        handle->installEventFilter(this);
}

bool PageStack::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Expose && watched == window()->windowHandle()) {
        watched->removeEventFilter(this);
        QTimer::singleShot(0, this, [this] { makePages(0); });
    }
    return QWidget::eventFilter(watched, event);
}

void PageStack::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (event->size().height() != event->oldSize().height())
        followLine();
}

void PageStack::followTab()
{
    m_pages->setCurrentIndex(m_tabs->currentIndex());
    shownPage()->setFocus();
    followLine();
    Q_EMIT shownChanged();
}

/// What the device is and does; where the window is low the page needs the room.
void PageStack::followLine()
{
    const bool ofDevice = shown() == PageId::Parameters || shown() == PageId::Tune || shown() == PageId::Design;
    const bool tall = window()->height() >= m_theme.theme().u(tallEnough);
    const bool roomy = window()->height() >= m_theme.theme().u(roomyEnough);
    m_states->setWanted(shown() != PageId::Tune || !tall ? LiveStateBar::Wanted::Never
            : roomy                                      ? LiveStateBar::Wanted::Always
                                                         : LiveStateBar::Wanted::IfSomethingHolds);
    m_line->setWanted(ofDevice && tall);
}

} // namespace mb
