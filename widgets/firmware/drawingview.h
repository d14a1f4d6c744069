// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "firmware/updateroute.h"
#include "widgets/common/theme.h"

#include <QWidget>

namespace mb {

/// Shows a family's drawing in the colours of the theme, as wide as there is room; hidden while there is none.
class DrawingView : public QWidget {
    Q_OBJECT
public:
    explicit DrawingView(const ThemeSource &theme, QWidget *parent = nullptr);

    /// nullptr for none. The drawing outlives this widget: families' data do.
    void setDrawing(const Drawing *drawing);
    [[nodiscard]] const Drawing *drawing() const { return m_drawing; }
    /// Of `drawing`, with colours and words in the place of their marks.
    [[nodiscard]] static QByteArray svgOf(const Drawing &drawing, const Theme &theme);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const ThemeSource &m_theme;
    const Drawing *m_drawing = nullptr;
};

} // namespace mb
