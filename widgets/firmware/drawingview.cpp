// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/drawingview.h"

#include "widgets/common/devicetext.h"

#include <QPainter>
#include <QSvgRenderer>

#include <algorithm>
#include <array>
#include <utility>

namespace mb {
namespace {

constexpr double widest = 1.4; ///< times the drawing's own width

} // namespace

DrawingView::DrawingView(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("stepDrawing"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    hide();
    connect(&theme, &ThemeSource::changed, this, qOverload<>(&QWidget::update));
}

void DrawingView::setDrawing(const Drawing *drawing)
{
    setVisible(drawing);
    if (std::exchange(m_drawing, drawing) == drawing)
        return;
    setAccessibleName(drawing ? tableText(drawing->description) : QString());
    updateGeometry();
    update();
}

QByteArray DrawingView::svgOf(const Drawing &drawing, const Theme &theme)
{
    QString svg = QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %1 %2\">")
                      .arg(drawing.width)
                      .arg(drawing.height);
    for (const std::string_view layer : drawing.layers)
        svg += qt(layer);
    const std::array<std::pair<const char *, QColor>, 11> colours{{{"outline", theme.outline}, {"panel", theme.panel},
        {"control", theme.control}, {"canvas", theme.canvas}, {"text", theme.text}, {"dim", theme.dim},
        {"accent", theme.accent}, {"onfill", theme.onFill}, {"ok", theme.tone(Tone::Ok)},
        {"caution", theme.tone(Tone::Caution)}, {"danger", theme.tone(Tone::Danger)}}};
    for (const auto &[name, colour] : colours)
        svg.replace(QLatin1Char('{') + QLatin1String(name) + QLatin1Char('}'), colour.name());
    for (std::size_t i = 0; i < drawing.words.size(); ++i)
        svg.replace(QStringLiteral("{%1}").arg(i), tableText(drawing.words[i]).toHtmlEscaped());
    return (svg + QStringLiteral("</svg>")).toUtf8();
}

QSize DrawingView::sizeHint() const
{
    const int width = m_theme.theme().u(m_drawing ? m_drawing->width : 0);
    return {width, heightForWidth(width)};
}

int DrawingView::heightForWidth(int width) const
{
    if (!m_drawing)
        return 0;
    const double most = m_theme.theme().u(m_drawing->width * widest);
    return static_cast<int>(std::min<double>(width, most) * m_drawing->height / m_drawing->width);
}

void DrawingView::paintEvent(QPaintEvent *)
{
    if (!m_drawing)
        return;
    QPainter painter(this);
    QSvgRenderer renderer(svgOf(*m_drawing, m_theme.theme()));
    const double scale = std::min(1.0 * width() / m_drawing->width, 1.0 * height() / m_drawing->height);
    renderer.render(&painter, QRectF(0.0, 0.0, m_drawing->width * scale, m_drawing->height * scale));
}

} // namespace mb
