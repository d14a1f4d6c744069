// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateglyph.h"

#include <QAbstractButton>
#include <optional>
#include <vector>

namespace mb {

/// A small framed button: glyph, bold word, dim words, sometimes a bar. The frame wears `edge`; caution where
/// unhealthy.
class Chip : public QAbstractButton {
    Q_OBJECT
public:
    struct Part {
        enum class Kind { Text, Bar };
        QString text;
        bool strong = false; ///< full text colour instead of dim
        QString widest = {}; ///< keeps the width of this text, so that numbers do not move
        Kind kind = Kind::Text;
        double level = 0.0; ///< of a bar, 0 … 1

        friend bool operator==(const Part &, const Part &) = default;
    };
    explicit Chip(const ThemeSource &theme, QWidget *parent = nullptr);

    void setGlyph(std::optional<GlyphState> state);
    void setTitle(const QString &title);
    void setParts(std::vector<Part> parts);
    /// Colour of frame and title; empty gives the neutral outline.
    void setEdge(std::optional<Tone> edge);
    /// Without frame and background, for a state that needs no attention.
    void setFlat(bool flat);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    int partWidth(const Part &part) const;
    QFont titleFont() const;
    QFont partFont() const;
    void paintFrame(QPainter &painter) const;
    int paintPart(QPainter &painter, const Part &part, int x) const;
    template <typename Value> void keep(Value &member, Value value); ///< what is not new is not measured anew
    void changed();

    const ThemeSource &m_theme;
    std::optional<GlyphState> m_glyph;
    QString m_title;
    std::vector<Part> m_parts;
    std::optional<Tone> m_edge;
    bool m_flat = false;
};

/// What a link chip shows. Rates and losses of the last second, see Link's counters.
struct LinkStatus {
    QString name; ///< "can0"
    GlyphState state = GlyphState::Online;
    QString word;               ///< instead of numbers when the link is not up: "down", "no permission"
    std::optional<double> load; ///< 0 … 1; NaN: not known (yet)
    QString rate;               ///< "61 Hz", a polled link
    std::optional<qint64> lost; ///< samples lost since the link was opened
    bool healthy = true;        ///< false: caution outline
    QString tooltip;            ///< cause and remedy
    QString address = {};       ///< of the link; names can be the same
};

/// One link in the header. Clicking opens Bus.
class LinkChip : public Chip {
    Q_OBJECT
public:
    explicit LinkChip(const ThemeSource &theme, QWidget *parent = nullptr);
    const LinkStatus &status() const { return m_status; }
    void setStatus(const LinkStatus &status);

private:
    LinkStatus m_status;
};

} // namespace mb
