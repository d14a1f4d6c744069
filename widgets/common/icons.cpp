// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/icons.h"

#include "widgets/common/paintedicon.h"

#include <QFile>
#include <QPainter>
#include <QSvgRenderer>

namespace mb {
namespace {

constexpr std::array<const char *, SymbolCount> Files{"list-add", "mb-arm", "camera-photo", "go-down", "go-previous",
    "go-next", "go-up", "mb-chip", "clock", "window-close", "edit-copy", "mb-cursors", "edit-delete", "document",
    "document-edit", "dialog-error", "document-export", "view-filter", "zoom-fit-best", "folder", "mb-frame-send",
    "mb-gap", "mb-gauge", "help-contextual", "mb-identify", "document-import", "dialog-information", "mb-jog",
    "object-locked", "text-log", "mb-mark", "view-more", "mb-motor", "mb-nudge", "dialog-ok", "document-open",
    "mb-page-map", "media-playback-pause", "mb-pin", "media-playback-start", "mb-plug", "preferences", "media-record",
    "edit-redo", "view-refresh", "list-remove", "document-save", "edit-find", "mb-star", "mb-star-filled", "mb-stop",
    "mb-swap", "mb-trigger", "edit-undo", "object-unlocked", "mb-wand", "dialog-warning", "mb-wave"};
static_assert(static_cast<int>(Symbol::Wave) + 1 == SymbolCount);

QByteArray colouredSvg(Symbol symbol, const QColor &color)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(symbolFile(symbol)));
    if (!file.open(QIODevice::ReadOnly)) {
        qWarning("icon %s is not linked into this program", Files.at(static_cast<std::size_t>(symbol)));
        return {};
    }
    return file.readAll().replace("currentColor", color.name().toLatin1());
}

QRectF squareIn(const QRectF &box)
{
    const double side = std::min(box.width(), box.height());
    return {box.center().x() - side / 2, box.center().y() - side / 2, side, side};
}

class SymbolEngine : public PaintedIcon {
public:
    SymbolEngine(Symbol symbol, const QColor &color, const QColor &disabled)
        : m_symbol(symbol)
        , m_color(color)
        , m_disabled(disabled)
    {
    }
    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        paintSymbol(*painter, rect, m_symbol, mode == QIcon::Disabled ? m_disabled : m_color);
    }
    QIconEngine *clone() const override { return new SymbolEngine(*this); }

private:
    Symbol m_symbol;
    QColor m_color;
    QColor m_disabled;
};

} // namespace

QString symbolFile(Symbol symbol)
{
    return QLatin1String(Files.at(static_cast<std::size_t>(symbol)));
}

void paintSymbol(QPainter &painter, const QRectF &box, Symbol symbol, const QColor &color)
{
    QSvgRenderer renderer(colouredSvg(symbol, color));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    renderer.render(&painter, squareIn(box));
    painter.restore();
}

QIcon symbolIcon(Symbol symbol, const Theme &theme, Tone tone)
{
    return symbolIcon(symbol, theme.tone(tone), theme.faint);
}

QIcon symbolIcon(Symbol symbol, const QColor &color, const QColor &disabled)
{
    return QIcon(new SymbolEngine(symbol, color, disabled));
}

QIcon applicationIcon()
{
    return QIcon(QStringLiteral(":/icons/motorbench.svg"));
}

} // namespace mb
