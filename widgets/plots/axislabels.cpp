// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/axislabels.h"

#include "widgets/plots/plottickers.h"

namespace mb {
namespace {

constexpr int besideUnit = 8;        ///< pixels
constexpr int higherThanNumbers = 2; ///< pixels, so that both stand on one line

} // namespace

AxisLabels::AxisLabels(QCustomPlot &plot)
    : QObject(&plot)
    , m_plot(plot)
    , m_unit(new QCPItemText(&plot))
{
    m_unit->setClipToAxisRect(false);
    m_unit->setPositionAlignment(Qt::AlignRight | Qt::AlignTop);
    m_unit->position->setType(QCPItemPosition::ptAbsolute);
    m_unit->setVisible(false);
    connect(&plot, &QCustomPlot::afterLayout, this, &AxisLabels::arrange);
}

void AxisLabels::nameX(const QString &name, bool atEnd)
{
    m_plot.xAxis->setLabel(atEnd ? QString() : name);
    m_isUnitAtEnd = atEnd;
    m_unit->setText(name);
    m_unit->setFont(m_plot.xAxis->tickLabelFont());
    m_unit->setColor(m_plot.xAxis->tickLabelColor());
}

void AxisLabels::arrange()
{
    const QRect frame = m_plot.axisRect()->rect();
    m_unit->setVisible(m_isUnitAtEnd && m_plot.xAxis->tickLabels());
    m_unit->position->setCoords(
        m_plot.width() - besideUnit, frame.bottom() + m_plot.xAxis->tickLabelPadding() - higherThanNumbers);
    const auto ticker = m_plot.yAxis->ticker().dynamicCast<NumberTicker>();
    const int height = QFontMetrics(m_plot.yAxis->tickLabelFont()).height();
    if (ticker && ticker->spaceLabels(height, frame.height()))
        m_plot.replot(QCustomPlot::rpQueuedReplot);
}

} // namespace mb
