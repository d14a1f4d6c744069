// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/iconbutton.h"

#include "widgets/common/labels.h"
#include "widgets/common/pagekeys.h"

#include <QApplication>
#include <QPainter>
#include <QStyleOptionButton>

namespace mb {

IconButton::IconButton(const ThemeSource &theme, Symbol symbol, const QString &name, QWidget *parent)
    : QToolButton(parent)
    , m_theme(theme)
    , m_symbol(symbol)
{
    setAccessibleName(name);
    setToolTip(name);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&theme, &ThemeSource::changed, this, &IconButton::restyle);
    restyle();
}

void IconButton::setKeyHint(const QString &key)
{
    m_key = key;
    const QString shown = keyShown(*this, key);
    setToolTip(shown.isEmpty() ? accessibleName() : accessibleName() + QStringLiteral("  ") + shown);
}

bool IconButton::event(QEvent *event)
{
    if (event->type() == keysChanged() && !m_key.isEmpty())
        setKeyHint(m_key);
    return QToolButton::event(event);
}

QSize IconButton::sizeHint() const
{
    const int side = m_theme.theme().u(32);
    return {side, side};
}

void IconButton::restyle()
{
    const int side = m_theme.theme().u(16);
    setIcon(symbolIcon(m_symbol, m_theme.theme(), m_tone));
    setIconSize({side, side});
    updateGeometry();
}

CommandButton::CommandButton(const ThemeSource &theme, const QString &text, QWidget *parent)
    : QPushButton(text, parent)
    , m_theme(theme)
{
    setAccessibleName(text);
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    connect(&theme, &ThemeSource::changed, this, [this] { updateGeometry(); });
}

CommandButton::CommandButton(const ThemeSource &theme, Symbol symbol, const QString &text, QWidget *parent)
    : CommandButton(theme, text, parent)
{
    m_symbol = symbol;
}

void CommandButton::setPrimary(bool primary)
{
    setStyleProperty(*this, "primary", primary);
    updateGeometry();
}

bool CommandButton::isPrimary() const
{
    return property("primary").toBool();
}

void CommandButton::setSymbol(std::optional<Symbol> symbol, Tone tone)
{
    m_symbol = symbol;
    m_tone = tone;
    updateGeometry();
    update();
}

void CommandButton::setKeyHint(const QString &key)
{
    m_key = key;
    updateGeometry();
    update();
}

bool CommandButton::event(QEvent *event)
{
    const bool presses = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    if (presses && isFresh())
        return true;
    m_isMeant = m_isMeant || presses;
    if (event->type() == QEvent::MouseButtonRelease && !m_isMeant)
        setDown(false);
    if (event->type() == keysChanged() && !m_key.isEmpty()) {
        tellWords();
        updateGeometry();
        update();
    }
    return QPushButton::event(event);
}

QString CommandButton::keyHint() const
{
    return keyShown(*this, m_key);
}

void CommandButton::setIconOnly(bool iconOnly)
{
    if (m_iconOnly == iconOnly)
        return;
    m_iconOnly = iconOnly;
    if (iconOnly)
        m_tip = toolTip();
    else
        setToolTip(m_tip);
    tellWords();
    updateGeometry();
    update();
}

void CommandButton::tellWords()
{
    if (!m_iconOnly)
        return;
    QString told = text();
    if (const QString key = keyHint(); !key.isEmpty())
        told += QStringLiteral("  ") + key;
    setToolTip(m_tip.isEmpty() ? told : told + QLatin1Char('\n') + m_tip);
}

void CommandButton::setTextVariants(const QStringList &texts)
{
    m_variants = texts;
    updateGeometry();
}

void CommandButton::setRole(const QString &text)
{
    if (text == this->text())
        return;
    setText(text);
    setAccessibleName(text);
    changeRole();
}

void CommandButton::changeRole()
{
    m_isMeant = false;
    m_readFrom.setRemainingTime(QApplication::doubleClickInterval());
}

QFont CommandButton::hintFont() const
{
    return m_theme.theme().font(TextRole::Caption, font());
}

QColor CommandButton::contentColor() const
{
    const Theme &theme = m_theme.theme();
    if (!isEnabled())
        return theme.faint;
    return isPrimary() ? theme.onFill : theme.text;
}

QSize CommandButton::sizeHint() const
{
    const QSize words = wordsSize();
    return m_iconOnly ? QSize(m_theme.theme().u(32), words.height()) : words;
}

QSize CommandButton::wordsSize() const
{
    ensurePolished();
    const Theme &theme = m_theme.theme();
    QFont widest = font();
    widest.setBold(isPrimary());
    const QFontMetrics metrics(widest);
    int width = metrics.horizontalAdvance(text());
    for (const QString &variant : m_variants)
        width = std::max(width, metrics.horizontalAdvance(variant));
    if (m_symbol)
        width += theme.u(16 + 8);
    if (const QString key = keyHint(); !key.isEmpty())
        width += theme.u(8) + QFontMetrics(hintFont()).horizontalAdvance(key);
    width += menu() ? theme.u(8 + 12) : 0;
    return {width + theme.u(28), std::max(theme.u(32), metrics.height() + theme.u(8))};
}

void CommandButton::paintSymbolAt(QPainter &painter, int x) const
{
    if (!m_symbol)
        return;
    const Theme &theme = m_theme.theme();
    const QColor color = isEnabled() && m_tone != Tone::Text ? theme.tone(m_tone) : contentColor();
    paintSymbol(painter, QRectF(x, (height() - theme.u(16)) / 2.0, theme.u(16), theme.u(16)), *m_symbol, color);
}

void CommandButton::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text.clear();
    option.icon = {};
    option.features &= ~QStyleOptionButton::HasMenu; // told by a chevron of ours
    QPainter painter(this);
    style()->drawControl(QStyle::CE_PushButton, &option, &painter, this);
    if (m_iconOnly)
        return paintSymbolAt(painter, (width() - theme.u(16)) / 2);

    const QFontMetrics hints(hintFont());
    const int iconWidth = m_symbol ? theme.u(16 + 8) : 0;
    const int chevron = menu() ? theme.u(8 + 12) : 0;
    const int most = width() - theme.u(16) - iconWidth - chevron;
    QString key = keyHint();
    int hintWidth = key.isEmpty() ? 0 : theme.u(8) + hints.horizontalAdvance(key);
    if (hintWidth > 0 && fontMetrics().size(Qt::TextShowMnemonic, text()).width() > most - hintWidth) {
        key.clear(); // the words matter more
        hintWidth = 0;
    }
    const int room = most - hintWidth;
    const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, room, Qt::TextShowMnemonic);
    const int textWidth = fontMetrics().size(Qt::TextShowMnemonic, shown).width();
    int x = (width() - iconWidth - textWidth - hintWidth - chevron) / 2;
    if (chevron > 0) {
        const QRectF box(x + iconWidth + textWidth + hintWidth + theme.u(8), (height() - theme.u(12)) / 2.0,
            theme.u(12), theme.u(12));
        paintSymbol(painter, box, Symbol::ChevronDown, isEnabled() && !isPrimary() ? theme.dim : contentColor());
    }
    paintSymbolAt(painter, x);
    x += iconWidth;
    painter.setPen(contentColor());
    painter.drawText(QRect(x, 0, textWidth + 1, height()), Qt::AlignVCenter | Qt::TextShowMnemonic, shown);
    if (hintWidth == 0)
        return;
    painter.setFont(hintFont());
    painter.setPen(!isEnabled() ? theme.faint : isPrimary() ? theme.onFill : theme.dim);
    painter.drawText(QRect(x + textWidth + theme.u(8), 0, hintWidth, height()), Qt::AlignVCenter, key);
}

} // namespace mb
