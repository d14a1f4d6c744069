// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/counttiles.h"

#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/stateglyph.h"
#include "widgets/service/verdictof.h"

#include <QPainter>

namespace mb {
namespace {

constexpr double figureSize = 2.4; ///< of the body

} // namespace

/// A figure with its shape, and what it counts below.
class CountTiles::Tile : public QWidget {
public:
    Tile(const ThemeSource &theme, std::optional<GlyphState> glyph, QString caption, QWidget *parent)
        : QWidget(parent)
        , m_theme(theme)
        , m_glyph(glyph)
        , m_caption(std::move(caption))
    {
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    void setFigure(const QString &figure)
    {
        m_figure = figure;
        setAccessibleName(text());
        update();
    }
    [[nodiscard]] QString text() const { return m_figure + QLatin1Char(' ') + m_caption; }
    [[nodiscard]] QSize sizeHint() const override { return {m_theme.theme().u(120), m_theme.theme().u(80)}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {m_theme.theme().u(70), sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent *) override;

private:
    const ThemeSource &m_theme;
    std::optional<GlyphState> m_glyph;
    QString m_caption;
    QString m_figure;
};

void CountTiles::Tile::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme &theme = m_theme.theme();
    painter.setPen(theme.line);
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), theme.u(4), theme.u(4));
    QRect room = rect().adjusted(theme.u(14), theme.u(6), -theme.u(8), -theme.u(8));
    QFont figure = theme.font(TextRole::Title, font());
    figure.setPointSizeF(theme.bodyPointSize * figureSize);
    QRect top(room.topLeft(), QSize(room.width(), QFontMetrics(figure).height()));
    if (m_glyph) {
        const int side = theme.u(16);
        paintGlyph(painter, QRectF(top.left(), top.center().y() - side / 2.0, side, side), *m_glyph,
            glyphColor(*m_glyph, theme));
        top.setLeft(top.left() + side + theme.u(10));
    }
    const int wanted = QFontMetrics(figure).horizontalAdvance(m_figure);
    if (wanted > top.width() && wanted > 0)
        figure.setPointSizeF(std::max(figure.pointSizeF() * top.width() / wanted, theme.bodyPointSize));
    painter.setFont(figure);
    painter.setPen(theme.text);
    painter.drawText(top, Qt::AlignLeft | Qt::AlignVCenter, m_figure);
    const QFont caption = theme.font(TextRole::Caption, font());
    painter.setFont(caption);
    painter.setPen(theme.dim);
    room.setTop(room.bottom() - QFontMetrics(caption).height());
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetrics(caption).elidedText(m_caption, Qt::ElideRight, room.width()));
}

CountTiles::CountTiles(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_tiles{new Tile(theme, GlyphState::Done, tr("passed"), this),
          new Tile(theme, GlyphState::Fault, tr("failed"), this),
          new Tile(theme, GlyphState::Warning, tr("refused before start"), this),
          new Tile(theme, GlyphState::Waiting, tr("mean time"), this), new Tile(theme, {}, tr("units an hour"), this)}
{
    auto *row = layoutIn<QHBoxLayout>(this, theme.theme().u(12));
    for (Tile *tile : m_tiles)
        row->addWidget(tile, 1);
}

void CountTiles::follow(const ServiceView &view)
{
    const auto mean = meanSeconds(view);
    const auto hourly = unitsAnHour(view);
    const QStringList figures{QString::number(view.counts.passed), QString::number(view.counts.failed),
        QString::number(view.counts.refused), mean ? formatValue(*mean, 1, QStringLiteral("s")) : QString(UnknownMark),
        hourly ? formatNumber(*hourly, 0) : QString(UnknownMark)};
    for (std::size_t i = 0; i < m_tiles.size(); ++i)
        m_tiles[i]->setFigure(figures.at(static_cast<int>(i)));
}

QStringList CountTiles::texts() const
{
    QStringList texts;
    for (const Tile *tile : m_tiles)
        texts << tile->text();
    return texts;
}

} // namespace mb
