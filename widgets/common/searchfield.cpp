// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/searchfield.h"

#include "widgets/common/pagekeys.h"

#include <QKeyEvent>
#include <QPainter>

namespace mb {
namespace {

constexpr int fieldWords = 90; ///< units, with the symbol before them

} // namespace

SearchField::SearchField(const ThemeSource &theme, const QString &placeholder, QWidget *parent)
    : QLineEdit(parent)
    , m_theme(theme)
{
    setPlaceholderText(placeholder);
    setAccessibleName(placeholder);
    connect(&theme, &ThemeSource::changed, this, &SearchField::restyle);
    connect(this, &QLineEdit::textChanged, this, &SearchField::updateMargins);
    restyle();
}

void SearchField::setKeyHint(const QString &key)
{
    m_key = key;
    updateMargins();
}

void SearchField::setResult(const QString &result)
{
    m_result = result;
    setAccessibleDescription(result);
    updateMargins();
}

/// Whoever has less room gives it a minimum of its own.
QSize SearchField::minimumSizeHint() const
{
    return {m_theme.theme().u(160), QLineEdit::minimumSizeHint().height()};
}

void SearchField::setSymbol(Symbol symbol)
{
    m_symbol = symbol;
    update();
}

void SearchField::restyle()
{
    updateGeometry();
    updateMargins();
}

void SearchField::updateMargins()
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics caption(theme.font(TextRole::Caption, font()));
    const QString right = beside();
    const int room = right.isEmpty() ? 0 : caption.horizontalAdvance(right) + theme.u(16);
    setTextMargins(theme.u(22), 0, room, 0);
    update();
}

/// The key only where the words of the field have room too; they matter more.
QString SearchField::beside() const
{
    if (!text().isEmpty())
        return m_result;
    const QString key = keyShown(*this, m_key);
    const Theme &theme = m_theme.theme();
    const int badge = QFontMetrics(theme.font(TextRole::Caption, font())).horizontalAdvance(key) + theme.u(16);
    return width() < theme.u(fieldWords) + badge ? QString() : key;
}

bool SearchField::event(QEvent *event)
{
    if (event->type() == keysChanged() || event->type() == QEvent::Resize)
        updateMargins();
    return QLineEdit::event(event);
}

void SearchField::paintEvent(QPaintEvent *event)
{
    QLineEdit::paintEvent(event);
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = theme.u(15);
    paintSymbol(painter, QRectF(theme.u(9), (height() - side) / 2, side, side), m_symbol, theme.dim);
    const QString right = beside();
    if (right.isEmpty())
        return;
    const QFont caption = theme.font(TextRole::Caption, font());
    const QFontMetrics metrics(caption);
    const int size = metrics.horizontalAdvance(right) + theme.u(10);
    const QRectF box(width() - size - theme.u(7), (height() - metrics.height() - 2) / 2.0, size, metrics.height() + 2);
    painter.setFont(caption);
    painter.setPen(theme.dim);
    painter.drawText(box, Qt::AlignCenter, right);
    if (!text().isEmpty())
        return;
    painter.setPen(QPen(theme.outline, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), theme.u(3), theme.u(3));
}

void SearchField::keyPressEvent(QKeyEvent *event)
{
    // Esc is STOP everywhere; it also empties the filter, and goes on to whoever stops.
    if (event->key() == Qt::Key_Escape) {
        clear();
        event->ignore();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

} // namespace mb
