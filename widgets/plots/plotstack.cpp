// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotstack.h"

#include "widgets/common/numberformat.h"
#include "widgets/plots/plotcursors.h"

#include <QPainter>
#include <QRubberBand>
#include <QTimer>
#include <QVBoxLayout>

namespace mb {

PlotStack::PlotStack(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Plot"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2, 2, 2, 2);
    buildPlot();
    column->addWidget(m_plot);
    connectMouse();
    connect(&theme, &ThemeSource::changed, this, &PlotStack::restyle);
    rebuildLayout();
}

PlotStack::~PlotStack() = default;

void PlotStack::buildPlot()
{
    m_plot = new PlotFrame(this);
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->setContextMenuPolicy(Qt::NoContextMenu);
    m_plot->addLayer(QStringLiteral("wished"), m_plot->layer(QStringLiteral("main")), QCustomPlot::limBelow);
    m_plot->plotLayout()->clear();
    m_plot->plotLayout()->setRowSpacing(0);
    m_margins = new QCPMarginGroup(m_plot);
    m_timeTicker = QSharedPointer<TimeTicker>::create();
    m_foot = new PlotFoot(*m_plot, m_theme);
    m_cursors = new PlotCursors(*m_plot, m_theme);
    m_box = new QRubberBand(QRubberBand::Rectangle, m_plot);
}

std::unique_ptr<PlotStack::Strip> PlotStack::makeStrip()
{
    auto strip = std::make_unique<Strip>();
    strip->rect = new QCPAxisRect(m_plot);
    strip->rect->setMarginGroup(QCP::msLeft, m_margins);
    const auto axes = strip->rect->axes();
    for (QCPAxis *axis : axes) {
        axis->setLayer(QStringLiteral("axes"));
        axis->grid()->setLayer(QStringLiteral("grid"));
    }
    strip->rect->axis(QCPAxis::atLeft)->setTicker(QSharedPointer<NumberTicker>::create());
    strip->rect->axis(QCPAxis::atRight)->setTicker(QSharedPointer<NumberTicker>::create());
    strip->rect->axis(QCPAxis::atRight)->grid()->setVisible(false);
    strip->rect->axis(QCPAxis::atBottom)->setTicker(m_timeTicker);
    new StripBackdrop(*strip->rect, m_theme, strip->decor); // both belong to the plot
    new StripFace(*strip->rect, m_theme, strip->decor);
    return strip;
}

void PlotStack::ensureStrip(int strip)
{
    const auto wanted = static_cast<std::size_t>(std::max(strip, 0)) + 1;
    if (m_strips.size() >= wanted)
        return;
    while (m_strips.size() < wanted)
        m_strips.push_back(makeStrip());
    rebuildLayout();
}

void PlotStack::rebuildLayout()
{
    QCPLayoutGrid &layout = *m_plot->plotLayout();
    const auto takeOut = [&layout](QCPLayoutElement *element) {
        if (element->layout() == &layout)
            layout.take(element);
    };
    for (const auto &strip : m_strips)
        takeOut(strip->rect);
    takeOut(m_foot);
    layout.simplify();
    int row = 0;
    std::vector<QCPAxisRect *> rects;
    for (const auto &strip : m_strips) {
        layout.addElement(row, 0, strip->rect);
        layout.setRowStretchFactor(row++, strip->style.stretch);
        rects.push_back(strip->rect);
    }
    layout.addElement(row, 0, m_foot);
    layout.setRowStretchFactor(row, 0.001);
    m_cursors->setRects(std::move(rects));
    restyle();
}

void PlotStack::restyle()
{
    m_plot->setCanvas(m_theme.theme().canvas);
    for (const auto &strip : m_strips)
        styleStrip(*strip, strip == m_strips.back());
    for (auto &[id, trace] : m_traces)
        trace.plottable->setLook(trace.plottable->look(), m_theme.theme());
    updateHeads();
    touch();
}

void PlotStack::styleStrip(Strip &strip, bool last) const
{
    const Theme &theme = m_theme.theme();
    const QFont caption = theme.font(TextRole::Caption, font());
    for (const auto type : {QCPAxis::atLeft, QCPAxis::atRight, QCPAxis::atBottom}) {
        QCPAxis &axis = *strip.rect->axis(type);
        axis.setBasePen(QPen(theme.outline, 1));
        axis.setTickPen(Qt::NoPen);
        axis.setSubTickPen(Qt::NoPen);
        axis.setTickLength(0);
        axis.setTickLabelPadding(theme.u(type == QCPAxis::atBottom ? 6 : 7));
        axis.setTickLabelFont(caption);
        axis.setTickLabelColor(theme.dim);
        axis.grid()->setPen(QPen(theme.grid, 1));
        axis.grid()->setZeroLinePen(QPen(type == QCPAxis::atBottom ? theme.grid : theme.line, 1));
    }
    strip.rect->axis(QCPAxis::atBottom)->setTickLabels(last);
    const int below = theme.u(last ? 26 : 6);
    strip.rect->setAutoMargins(QCP::msLeft);
    strip.decor.headGap = strip.style.legend || !strip.style.title.isEmpty() ? theme.u(8) : 0;
    const int above = theme.u(headHeight) + strip.decor.headGap + theme.u(strip.decor.headGap > 0 ? 8 : 2);
    strip.rect->setMargins(QMargins(0, above, tagMargin(), below));
    strip.decor.keyUnit = last && !m_unixAtZero ? tr("s") : QString();
}

void PlotStack::updateHeads()
{
    const QFontMetrics caption(m_theme.theme().font(TextRole::Caption, font()));
    const bool anySecond = std::any_of(m_traces.begin(), m_traces.end(),
        [](const auto &entry) { return entry.second.visible && entry.second.style.secondAxis; });
    for (std::size_t i = 0; i < m_strips.size(); ++i) {
        StripDecor &decor = m_strips[i]->decor;
        decor.title = m_strips[i]->style.title;
        decor.first = i == 0;
        decor.watermark = m_watermark;
        decor.entries.clear();
        decor.curves.clear();
        decor.marks = m_marks;
        decor.secondRoom = anySecond ? m_theme.theme().u(56) : 0;
        QStringList units;
        QStringList secondUnits;
        for (const auto &[id, trace] : m_traces) {
            if (trace.style.strip != static_cast<int>(i) || !trace.visible)
                continue;
            QStringList &ofAxis = trace.style.secondAxis ? secondUnits : units;
            if (!ofAxis.contains(trace.style.unit))
                ofAxis << trace.style.unit;
            if (!decor.notes.empty() && !trace.style.secondAxis)
                decor.curves.push_back(trace.plottable);
            if (m_strips[i]->style.legend)
                decor.entries.push_back({trace.style.name, trace.plottable->look()});
        }
        decor.unit = units.join(QStringLiteral(", "));
        decor.secondUnit = secondUnits.join(QStringLiteral(", "));
        m_strips[i]->rect->axis(QCPAxis::atRight)->setVisible(!secondUnits.isEmpty());
        const int unit = caption.horizontalAdvance(decor.unit) + m_theme.theme().u(10);
        m_strips[i]->rect->setMinimumMargins(QMargins(std::max(m_theme.theme().u(52), unit), 0, 0, 0));
    }
    const int right = tagMargin();
    for (const auto &strip : m_strips) {
        const QMargins margins = strip->rect->margins();
        strip->rect->setMargins({margins.left(), margins.top(), right, margins.bottom()});
    }
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
        refresh(m_now);
    });
}

void PlotStack::setStrip(int strip, const StripStyle &style)
{
    ensureStrip(strip);
    m_strips.at(static_cast<std::size_t>(strip))->style = style;
    rebuildLayout();
}

int PlotStack::addTrace(const TraceStyle &style, std::shared_ptr<const TraceSource> source)
{
    ensureStrip(style.strip);
    QCPAxisRect &rect = *m_strips.at(static_cast<std::size_t>(style.strip))->rect;
    QCPAxis *values = rect.axis(style.secondAxis ? QCPAxis::atRight : QCPAxis::atLeft);
    Trace trace{style, std::move(source), new TracePlottable(rect.axis(QCPAxis::atBottom), values)};
    trace.plottable->setLook(style.look(), m_theme.theme());
    trace.plottable->setName(style.name);
    if (style.role == TraceRole::Setpoint || style.dash == TraceDash::Dots)
        trace.plottable->setLayer(QStringLiteral("wished")); // behind what was measured
    const int id = m_nextTrace++;
    m_traces.emplace(id, std::move(trace));
    updateHeads();
    touch();
    return id;
}

const TraceStyle *PlotStack::style(int trace) const
{
    const auto found = m_traces.find(trace);
    return found == m_traces.end() ? nullptr : &found->second.style;
}

void PlotStack::setSource(int trace, std::shared_ptr<const TraceSource> source)
{
    const auto found = m_traces.find(trace);
    if (found == m_traces.end())
        return;
    found->second.source = std::move(source);
    touch();
}

void PlotStack::setTraceVisible(int trace, bool visible)
{
    const auto found = m_traces.find(trace);
    if (found == m_traces.end())
        return;
    found->second.visible = visible;
    found->second.plottable->setVisible(visible);
    updateHeads();
    touch();
}

void PlotStack::removeTrace(int trace)
{
    const auto found = m_traces.find(trace);
    if (found == m_traces.end())
        return;
    m_plot->removePlottable(found->second.plottable);
    m_traces.erase(found);
    updateHeads();
    touch();
}

void PlotStack::clear()
{
    m_plot->clearPlottables();
    m_traces.clear();
    for (int i = m_plot->itemCount() - 1; i >= 0; --i) {
        if (m_plot->item(i) != m_cursors)
            m_plot->removeItem(i);
    }
    for (const auto &strip : m_strips)
        m_plot->plotLayout()->remove(strip->rect);
    m_strips.clear();
    m_trigger.reset();
    rebuildLayout();
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
