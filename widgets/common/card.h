// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/labels.h"
#include "widgets/common/stateglyph.h"

#include <QFrame>
#include <optional>

class QBoxLayout;
class QHBoxLayout;
class QVBoxLayout;

namespace mb {

/// A framed panel: head with glyph, title, dim subtitle and widgets at the right; body; foot behind a line.
/// Head and foot appear with their first content.
class Card : public QFrame {
    Q_OBJECT
public:
    explicit Card(const ThemeSource &theme, QWidget *parent = nullptr);
    Card(const ThemeSource &theme, const QString &title, QWidget *parent = nullptr);

    void setTitle(const QString &title, const QString &subtitle = {});
    void setGlyph(std::optional<GlyphState> state);
    /// At the right of the head (badge, icon button); the card takes it.
    void addHeadWidget(QWidget *widget);
    /// At the left of the head; the card takes it.
    void addHeadMark(QWidget *widget);
    /// Less air, where several stand below each other.
    void setDense(bool dense);
    /// A dense one where its column would scroll for some pixels.
    void setTight(bool tight);
    /// Where the content goes. Margins are those of a card; setFlush(true) removes them for tables and plots.
    QVBoxLayout &body() { return *m_body; }
    void setFlush(bool flush);
    /// Left to right; add a stretch for what stands at the right.
    QHBoxLayout &foot();
    /// The frame: empty is neutral, Accent is selected (2 px), Caution and Danger are states.
    void setEdge(std::optional<Tone> edge);
    /// Lets the card be clicked, and focused and activated by keys.
    void setActivatable(bool activatable);

Q_SIGNALS:
    void activated();

protected:
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void restyle();
    void ensureHead();

    const ThemeSource &m_theme;
    QVBoxLayout *m_column = nullptr;
    QHBoxLayout *m_head = nullptr;
    QVBoxLayout *m_body = nullptr;
    QHBoxLayout *m_foot = nullptr;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_title = nullptr;
    QLabel *m_subtitle = nullptr;
    bool m_flush = false;
    bool m_dense = false;
    bool m_tight = false;
    bool m_activatable = false;
};

} // namespace mb
