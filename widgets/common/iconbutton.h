// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/icons.h"

#include <QDeadlineTimer>
#include <QPushButton>
#include <QToolButton>
#include <optional>

namespace mb {

/// An icon without words: 28 units in a hit box of 32. The name is the accessible name; the tooltip adds the key.
class IconButton : public QToolButton {
    Q_OBJECT
public:
    IconButton(const ThemeSource &theme, Symbol symbol, const QString &name, QWidget *parent = nullptr);
    /// Shown in the tooltip only: "Fit time and value  0". The action or shortcut itself belongs to the page.
    void setKeyHint(const QString &key);
    QSize sizeHint() const override;

protected:
    bool event(QEvent *event) override;

private:
    void restyle();

    const ThemeSource &m_theme;
    Symbol m_symbol;
    Tone m_tone = Tone::Dim;
    QString m_key;
};

/// A push button with an icon, a verb with an object, and the dim key behind it: "Write and run F5".
class CommandButton : public QPushButton {
    Q_OBJECT
public:
    CommandButton(const ThemeSource &theme, const QString &text, QWidget *parent = nullptr);
    CommandButton(const ThemeSource &theme, Symbol symbol, const QString &text, QWidget *parent = nullptr);
    /// The one filled button of a region.
    void setPrimary(bool primary);
    bool isPrimary() const;
    void setSymbol(std::optional<Symbol> symbol, Tone tone = Tone::Text);
    /// "F5" behind the text. The shortcut itself belongs to the page.
    void setKeyHint(const QString &key);
    /// "Ctrl+H", as it is now.
    QString keyHint() const;
    /// Its symbol alone, words and key above its own tooltip; it needs a symbol.
    void setIconOnly(bool iconOnly);
    /// With its words, icon only or not.
    QSize wordsSize() const;
    /// Texts this button may change to: it is as wide as the widest, so that the row does not move.
    void setTextVariants(const QStringList &texts);
    /// Its words and its name, where what it does becomes something else under the pointer, as Start becomes End.
    void setRole(const QString &text);
    /// It does something else than a moment ago, or to something else, or stands where another stood: a press that is held down, or comes
    /// within the time of a double click, was meant for that, and is none.
    void changeRole();
    [[nodiscard]] bool isFresh() const { return !m_readFrom.hasExpired(); }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    QFont hintFont() const;
    void tellWords();
    QColor contentColor() const;
    void paintSymbolAt(QPainter &painter, int x) const;

    const ThemeSource &m_theme;
    std::optional<Symbol> m_symbol;
    Tone m_tone = Tone::Text;
    QString m_key;
    QStringList m_variants;
    QString m_tip; ///< of its own, while it is a symbol
    bool m_iconOnly = false;
    bool m_isMeant = false;    ///< the press that is held: it was for what the button does now
    QDeadlineTimer m_readFrom; ///< before that nobody has read what it does
};

} // namespace mb
