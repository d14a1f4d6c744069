// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

namespace mb {

/// What stands below a slider: the words of its ends, and a triangle with words where the proposal is. The words of the proposal go on a
/// line of their own where they would meet an end.
class SliderScale : public QWidget {
    Q_OBJECT
public:
    SliderScale(const ThemeSource &theme, const QString &low, const QString &high, QWidget *parent);

    /// `share` of the way from the low end to the high one.
    void setMark(double share, const QString &words);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *) override { updateGeometry(); }

private:
    [[nodiscard]] QFont captionFont() const;
    [[nodiscard]] double markAt(int width) const;
    [[nodiscard]] bool needsLine(int width) const;

    const ThemeSource &m_theme;
    QString m_low;
    QString m_high;
    QString m_words;
    double m_share = 0.5;
};

} // namespace mb
