// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotstack.h"

#include "widgets/common/layoutin.h"
#include "widgets/plots/fixedtrace.h"

#include <QAccessible>
#include <QContextMenuEvent>
#include <QMenu>
#include <QPainter>
#include <QTimer>

namespace mb {
namespace {

constexpr qint64 WordsEvery = 100; ///< milliseconds between two changes of numbers that somebody reads

} // namespace

PlotStack::PlotStack(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_plot(new PlotFrame(this))
    , m_strips(new PlotStrips(*m_plot, theme))
    , m_view(new PlotView(this))
    , m_readings(*m_strips, *m_view)
    , m_feed(*m_strips, *m_view, theme)
    , m_exporter(new PlotExport(*this, *m_plot, m_readings))
    , m_input(new PlotInput(*this, *m_plot, *m_strips, *m_view, theme))
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Plot"));
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->setContextMenuPolicy(Qt::NoContextMenu);
    auto *column = layoutIn<QVBoxLayout>(this, -1, {2, 2, 2, 2});
    column->addWidget(m_plot);
    connectParts();
    touch();
}

void PlotStack::connectParts()
{
    connect(m_strips, &PlotStrips::changed, this, &PlotStack::touch);
    connect(m_view, &PlotView::changed, this, [this] {
        m_strips->times().setEvent(m_view->heldKey());
        touch();
    });
    connect(m_view, &PlotView::liveChanged, this, &PlotStack::announce);
    connect(m_input, &PlotInput::fitRequested, this, &PlotStack::fit);
    connect(m_input, &PlotInput::cursorsToggled, this, [this] { setCursorsShown(!cursorsShown()); });
    connect(m_input, &PlotInput::cursorMoved, this, [this] {
        touch();
        Q_EMIT cursorsChanged();
    });
}

void PlotStack::touch()
{
    m_dirty = true;
    if (m_pending)
        return;
    m_pending = true;
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(m_budget.wait());
    QTimer::singleShot(wait, Qt::PreciseTimer, this, [this] {
        m_pending = false;
        refresh(m_view->now());
    });
}

void PlotStack::refresh(double now)
{
    m_view->setNow(now);
    if (!isVisible() || m_plot->visibleRegion().isEmpty())
        return;
    const bool moved = m_view->isLive() && m_view->follow(now, m_strips->width());
    if (!moved && !m_dirty)
        return;
    const Painting painting(m_budget);
    const bool scaled = m_feed.fetch(m_plot->devicePixelRatioF());
    const bool words = m_dirty || !m_wordsSince.isValid() || m_wordsSince.elapsed() >= WordsEvery;
    if (words) {
        m_wordsSince.start();
        m_feed.updateWords(m_readings);
        Q_EMIT wordsUpdated();
    }
    m_dirty = false;
    const int width = m_strips->width();
    // What stands beside the axes reaches over all of the picture with cursors, and changes with a second axis.
    const bool second
        = std::ranges::any_of(m_strips->all(), [](const auto &strip) { return !strip->decor.secondUnit.isEmpty(); });
    if (words || scaled || second || cursorsShown())
        m_plot->render();
    else
        m_plot->renderPart(m_feed.movingPart());
    // Drawing lays out first: after a resize, or with wider tick labels, the columns were made for another width.
    if (m_strips->width() != width) {
        m_feed.fetch(m_plot->devicePixelRatioF());
        m_plot->render();
    }
}

void PlotStack::fit()
{
    for (const auto &strip : m_strips->all())
        strip->fit();
    double first = std::numeric_limits<double>::infinity();
    double last = -first;
    for (const auto &[id, trace] : m_strips->traces()) {
        if (const auto *fixed = dynamic_cast<const FixedTrace *>(trace.source.get());
            fixed && !fixed->points().empty() && !trace.style.aligned) { // which has no time of its own
            first = std::min(first, fixed->points().front().key);
            last = std::max(last, fixed->points().back().key);
        }
    }
    if (m_view->whole())
        m_view->setRange(m_view->whole()->first, m_view->whole()->second);
    else if (last > first)
        m_view->setRange(first, last);
    touch();
}

void PlotStack::setFootNote(const QString &text)
{
    m_feed.setFootNote(text);
    touch();
}

void PlotStack::setStateText(const QString &text)
{
    if (m_feed.setStateText(text))
        touch();
}

void PlotStack::setCursorsShown(bool shown)
{
    if (shown == cursorsShown())
        return;
    const double from = m_view->range().first;
    m_strips->cursors().setVisible(shown);
    setCursorKeys(from + m_view->span() / 3, from + m_view->span() * 2 / 3);
}

bool PlotStack::cursorsShown() const
{
    return m_strips->cursors().visible();
}

void PlotStack::setCursorKeys(double a, double b)
{
    m_strips->cursors().setKey(false, a);
    m_strips->cursors().setKey(true, b);
    touch();
    Q_EMIT cursorsChanged();
}

std::pair<double, double> PlotStack::cursorKeys() const
{
    return {m_strips->cursors().key(false), m_strips->cursors().key(true)};
}

void PlotStack::fillMenu(QMenu &menu)
{
    const bool live = m_view->isLive();
    menu.addAction(live ? tr("Pause view\tP") : tr("Back to live\tP"), this,
        [this] { m_view->isLive() ? m_view->setLive(false) : m_input->backToLive(); });
    menu.addAction(tr("Fit time and value\t0"), this, &PlotStack::fit);
    QAction *cursors = menu.addAction(tr("Cursors A and B\tL"), this, [this] { setCursorsShown(!cursorsShown()); });
    cursors->setCheckable(true);
    cursors->setChecked(cursorsShown());
    menu.addSeparator();
    m_exporter->fillMenu(menu);
}

void PlotStack::announce()
{
    setAccessibleDescription(m_readings.summary());
    QAccessibleEvent event(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&event);
}

bool PlotStack::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::FocusIn: announce(); [[fallthrough]];
    case QEvent::FocusOut: update(); break;
    case QEvent::Show:
    case QEvent::Resize: touch(); break;
    default: break;
    }
    return QWidget::event(event);
}

void PlotStack::contextMenuEvent(QContextMenuEvent *event)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(*menu);
    Q_EMIT menuRequested(menu, m_strips->stripAt(event->pos()), m_strips->keyAt(event->pos().x()));
    menu->popup(event->globalPos());
}

void PlotStack::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_theme.theme().canvas);
    if (!hasFocus())
        return;
    painter.setPen(QPen(m_theme.theme().accent, 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

QSize PlotStack::sizeHint() const
{
    return {m_theme.theme().u(640), m_theme.theme().u(400)};
}

} // namespace mb
