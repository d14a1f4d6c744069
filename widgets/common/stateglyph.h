// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/glyphshapes.h"
#include "widgets/common/theme.h"

#include <QIcon>
#include <QWidget>

namespace mb {

Tone glyphTone(GlyphState state);
/// Colour of the shape. Moving wears the colour of the Arm button, everything else its tone.
QColor glyphColor(GlyphState state, const Theme &theme);
/// The translated word that stands beside the shape ("online", "RAM, not in flash").
QString glyphWord(GlyphState state);
QIcon glyphIcon(GlyphState state, const Theme &theme);

/// The shape as a widget of 12 units; its accessible name is the word.
class StateGlyph : public QWidget {
    Q_OBJECT
public:
    StateGlyph(const ThemeSource &theme, GlyphState state, QWidget *parent = nullptr);
    GlyphState state() const { return m_state; }
    void setState(GlyphState state);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const ThemeSource &m_theme;
    GlyphState m_state;
};

} // namespace mb
