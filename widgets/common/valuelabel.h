// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/livetext.h"
#include "widgets/common/theme.h"

#include <QWidget>

namespace mb {

/// A live number that does not move: its field is as wide as the widest text it may show, the unit stands dim behind.
/// Unknown is "–". Three looks: Card (caption above, large value, left), Line ("velocity 0 rpm" in one line, value
/// bold), Row (caption left, value and unit at the right edge).
class ValueLabel : public QWidget {
    Q_OBJECT
public:
    enum class Look { Card, Line, Row };
    ValueLabel(
        const ThemeSource &theme, Look look, const QString &caption, const QString &unit, QWidget *parent = nullptr);

    /// Text that sets the width of the number, such as "−88 888" (the default).
    void setWidest(const QString &widest);
    /// A finished text from numberformat.h.
    void setValue(const QString &value);
    /// Nothing known: "–", and no unit.
    void clear();
    void setUnit(const QString &unit);
    /// Both; of what the device has not, the unit stays.
    void setLive(const LiveText &live);
    void setTone(Tone tone);
    /// Greyed, with the reason or age in the tooltip, while a device does not answer.
    void setStale(bool stale);
    QString value() const { return m_value; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QFont valueFont() const;
    QFont captionFont() const;
    int fieldWidth() const;
    void followBreadth(const QString &value);
    void updateAccessibleText();
    void paintCard(QPainter &painter, const QColor &color) const;
    void paintLine(QPainter &painter, const QColor &color) const;
    void paintRow(QPainter &painter, const QColor &color) const;

    const ThemeSource &m_theme;
    Look m_look;
    QString m_caption;
    QString m_unit;
    QString m_value;
    QString m_widest;
    int m_broadest
        = 0; ///< of the numbers lately, in pixels: a caption stands beside that, and does not move with every digit
    int m_narrower = 0; ///< how often it was told less since
    Tone m_tone = Tone::Text;
    bool m_stale = false;
};

} // namespace mb
