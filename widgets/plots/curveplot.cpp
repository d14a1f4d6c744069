// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curveplot.h"

#include "widgets/common/layoutin.h"
#include "widgets/plots/picturefile.h"
#include "widgets/plots/plottickers.h"

#include <QKeyEvent>

#include <algorithm>
#include <numeric>
#include <utility>

namespace mb {
namespace {

constexpr int besideNote = 16; ///< pixels

/// Clause after clause, on as many lines as they need; one that is too long breaks between its words.
QString inLines(
    const QString &note, const QFontMetrics &metrics, int width, const QString &joint = QStringLiteral(" · "))
{
    QString lines;
    QString line;
    for (QString clause : note.split(joint)) {
        if (joint != QLatin1String(" ") && metrics.horizontalAdvance(clause) > width)
            clause = inLines(clause, metrics, width, QStringLiteral(" "));
        const QString longer = line.isEmpty() ? clause : line + joint + clause;
        if (line.isEmpty() || metrics.horizontalAdvance(longer) <= width) {
            line = longer;
            continue;
        }
        lines += line + QLatin1Char('\n');
        line = clause;
    }
    return lines + line;
}

} // namespace

CurvePlot::CurvePlot(const ThemeSource &theme, const QString &accessibleName, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(accessibleName);
    setFocusPolicy(Qt::StrongFocus);
    m_plot = new QCustomPlot(this);
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    m_plot->setNoAntialiasingOnDrag(true);
    m_plot->xAxis->setTicker(QSharedPointer<NumberTicker>::create());
    m_plot->yAxis->setTicker(QSharedPointer<NumberTicker>::create());
    m_words = new QCPTextElement(m_plot, QString());
    m_plot->plotLayout()->addElement(1, 0, m_words);
    m_plot->axisRect()->insetLayout()->take(m_plot->legend);
    m_plot->legend->setBorderPen(Qt::NoPen);
    m_plot->legend->setBrush(Qt::NoBrush);
    m_plot->legend->setVisible(false);
    m_mark = new QCPItemText(m_plot);
    m_mark->position->setType(QCPItemPosition::ptAxisRectRatio);
    m_mark->position->setCoords(0.5, 0.5);
    m_labels = new AxisLabels(*m_plot);
    m_marks = new CurveMarks(*m_plot, theme);
    auto *column = layoutIn<QVBoxLayout>(this, -1, {2, 2, 2, 2});
    column->addWidget(m_plot);
    connect(m_plot, &QCustomPlot::mouseDoubleClick, this, &CurvePlot::fit);
    connect(&theme, &ThemeSource::changed, this, &CurvePlot::restyle);
    restyle();
}

/// A plot that was never laid out has no size to draw in.
void CurvePlot::replotSoon()
{
    if (isVisible() && m_plot->width() > 1 && m_plot->height() > 1)
        m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void CurvePlot::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    showNote();
    showLegend();
}

void CurvePlot::showNote()
{
    m_words->setText(m_around.note ? inLines(m_note, QFontMetrics(m_words->font()), width() - besideNote) : QString());
}

void CurvePlot::restyle()
{
    const Theme &theme = m_theme.theme();
    const QFont caption = theme.font(TextRole::Caption, font());
    m_plot->setBackground(theme.canvas);
    for (QCPAxis *axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setBasePen(QPen(theme.outline, 1));
        axis->setTickPen(Qt::NoPen);
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelFont(caption);
        axis->setTickLabelColor(theme.dim);
        axis->setLabelFont(caption);
        axis->setLabelColor(theme.dim);
        axis->grid()->setPen(QPen(theme.grid, 1));
        axis->grid()->setZeroLinePen(QPen(theme.line, 1));
    }
    m_plot->legend->setFont(caption);
    m_plot->legend->setTextColor(theme.text);
    m_words->setFont(caption);
    m_words->setTextColor(theme.dim);
    showNote();
    QFont big = theme.font(TextRole::Emphasis, font());
    big.setPixelSize(theme.u(72));
    QColor faint = theme.accent;
    faint.setAlphaF(0.12);
    m_mark->setFont(big);
    m_mark->setColor(faint);
    setSurroundings(m_around);
    setMarks(std::vector<CurveMark>(marks()));
    setCurves(std::vector<Curve>(m_curves));
}

void CurvePlot::setAxes(const QString &x, const QString &y, bool logarithmicY, bool logarithmicX)
{
    setAxis(*m_plot->xAxis, x, logarithmicX);
    setAxis(*m_plot->yAxis, y, logarithmicY);
    m_nameOfX = x;
    m_labels->nameX(x, m_around.unitAtEnd && m_around.xLabels);
}

void CurvePlot::setAxis(QCPAxis &axis, const QString &label, bool logarithmic)
{
    axis.setLabel(label);
    const auto type = logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear;
    if (type == axis.scaleType())
        return;
    axis.setScaleType(type);
    axis.setTicker(logarithmic ? QSharedPointer<QCPAxisTicker>(QSharedPointer<DecadeTicker>::create())
                               : QSharedPointer<NumberTicker>::create());
    m_fitted = false;
}

/// Two graphs that nobody sees, and what is between them.
void CurvePlot::addBand(const Curve &curve)
{
    QCPGraph *const low = m_plot->addGraph();
    QCPGraph *const high = m_plot->addGraph();
    low->setData(curve.x, curve.low, true);
    high->setData(curve.x, curve.high, true);
    QColor fill = tracePen(curve.look, m_theme.theme()).color();
    fill.setAlphaF(0.16);
    for (QCPGraph *graph : {low, high}) {
        graph->setPen(Qt::NoPen);
        graph->removeFromLegend();
    }
    high->setBrush(fill);
    high->setChannelFillGraph(low);
}

void CurvePlot::addCurve(const Curve &curve)
{
    if (!curve.low.isEmpty())
        addBand(curve);
    auto *drawn = new QCPCurve(m_plot->xAxis, m_plot->yAxis);
    drawn->setName(curve.name);
    QPen pen = tracePen(curve.look, m_theme.theme());
    if (curve.look.emphasis && curve.look.dash == TraceDash::Solid)
        pen.setWidth(m_theme.theme().u(2));
    drawn->setPen(pen);
    if (curve.points) {
        drawn->setLineStyle(QCPCurve::lsNone);
        drawn->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssTriangle, pen,
            curve.hollow ? QBrush(m_theme.theme().canvas) : QBrush(pen.color()), m_theme.theme().u(8)));
    }
    QVector<double> order(curve.x.size());
    std::iota(order.begin(), order.end(), 0.0);
    drawn->setData(order, curve.x, curve.y, true);
}

void CurvePlot::setCurves(const std::vector<Curve> &curves)
{
    m_curves = curves;
    m_plot->clearPlottables();
    for (const Curve &curve : m_behind)
        addCurve(curve);
    for (const Curve &curve : m_curves)
        addCurve(curve);
    showLegend();
    showLabels();
    if (!m_fitted && !m_curves.empty())
        fit();
    else
        replotSoon();
}

/// Numbers beside nothing say nothing.
void CurvePlot::showLabels()
{
    m_plot->xAxis->setTickLabels(m_around.xLabels && !m_curves.empty());
    m_plot->yAxis->setTickLabels(!m_curves.empty());
}

/// Above the axes, as many names in a row as have room: nothing of a curve is behind it.
void CurvePlot::showLegend()
{
    const bool shown = m_around.legend && !m_curves.empty();
    QCPLayoutGrid &rows = *m_plot->plotLayout();
    QCPLegend &legend = *m_plot->legend;
    legend.setVisible(shown);
    if (shown && legend.layout() != &rows) {
        rows.insertRow(0);
        rows.addElement(0, 0, &legend);
        rows.setRowStretchFactor(0, 0.001);
    } else if (!shown && legend.layout() == &rows) {
        rows.take(&legend);
        rows.simplify();
    }
    int widest = 1;
    for (int i = 0; i < legend.itemCount(); ++i) { // the last row may have empty places
        if (const QCPAbstractLegendItem *item = legend.item(i))
            widest = std::max(widest, item->minimumOuterSizeHint().width() + legend.columnSpacing());
    }
    const int room = m_plot->width() - legend.margins().left() - legend.margins().right();
    legend.setWrap(std::max(1, room / widest));
    legend.setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

void CurvePlot::setBehind(std::vector<Curve> curves)
{
    m_behind = std::move(curves);
    setCurves(std::vector<Curve>(m_curves));
}

void CurvePlot::setMarks(std::vector<CurveMark> marks)
{
    m_marks->set(std::move(marks), font());
    replotSoon();
}

void CurvePlot::setSurroundings(const Surroundings &surroundings)
{
    m_around = surroundings;
    showLegend();
    showLabels();
    QCPAxisRect &frame = *m_plot->axisRect();
    frame.setAutoMargins(m_around.left > 0 ? QCP::msTop | QCP::msRight | QCP::msBottom : QCP::msAll);
    if (!m_around.note && m_words->layout()) {
        m_plot->plotLayout()->take(m_words);
        m_plot->plotLayout()->simplify();
    }
    if (m_around.left > 0) {
        const Theme &look = m_theme.theme();
        frame.setMargins(QMargins(look.u(m_around.left), 0, 0, 0));
        frame.setMinimumMargins(QMargins(0, look.u(6), look.u(m_around.unitAtEnd ? 34 : 14), look.u(6)));
    }
    m_labels->nameX(m_nameOfX, m_around.unitAtEnd && m_around.xLabels);
    showNote();
}

void CurvePlot::setNote(const QString &note)
{
    m_note = note;
    setAccessibleDescription(note);
    showNote();
    replotSoon();
}

void CurvePlot::setWatermark(const QString &text)
{
    m_mark->setText(text);
}

void CurvePlot::fit()
{
    m_fitted = !m_curves.empty();
    bool first = true;
    for (int i = static_cast<int>(m_behind.size()); i < m_plot->plottableCount(); ++i)
        m_plot->plottable(i)->rescaleAxes(!std::exchange(first, false));
    if (m_least.size() > 0.0)
        m_plot->yAxis->setRange(m_plot->yAxis->range().expanded(m_least));
    for (QCPAxis *axis : {m_plot->xAxis, m_plot->yAxis}) {
        if (axis->scaleType() == QCPAxis::stLinear)
            axis->scaleRange(1.06, axis->range().center());
    }
    if (m_plot->yAxis->scaleType() == QCPAxis::stLogarithmic) { // noise far below says nothing
        const QCPRange range = m_plot->yAxis->range();
        m_plot->yAxis->setRange(std::max(range.lower, range.upper * 1e-6), range.upper * 2);
    }
    replotSoon();
}

void CurvePlot::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_0: return fit();
    case Qt::Key_Plus: m_plot->xAxis->scaleRange(0.8); break;
    case Qt::Key_Minus: m_plot->xAxis->scaleRange(1.25); break;
    case Qt::Key_Left: m_plot->xAxis->moveRange(-0.1 * m_plot->xAxis->range().size()); break;
    case Qt::Key_Right: m_plot->xAxis->moveRange(0.1 * m_plot->xAxis->range().size()); break;
    default: return QWidget::keyPressEvent(event);
    }
    replotSoon();
}

QByteArray CurvePlot::contentAs(const QString &kind)
{
    const QSize size = m_plot->size();
    if (kind == QLatin1String("png"))
        return pngOf(picture().toImage());
    return drawingAs(kind, {size, accessibleName(), {}, [&](QCPPainter &painter) {
                                m_plot->toPainter(&painter, size.width(), size.height());
                            }});
}

} // namespace mb
