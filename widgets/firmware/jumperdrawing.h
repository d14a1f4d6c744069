// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

namespace mb {

/// The board from above with its serial adapter: where the jumper between AUX1 and AUX2 goes, and how TX and RX cross. A
/// schematic, not to scale.
class JumperDrawing : public QWidget {
    Q_OBJECT
public:
    explicit JumperDrawing(const ThemeSource &theme, QWidget *parent = nullptr);

    void setClosed(bool closed);
    [[nodiscard]] bool isClosed() const { return m_closed; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void paintBoard(QPainter &painter) const;
    void paintAdapter(QPainter &painter) const;
    void paintWires(QPainter &painter) const;
    void paintJumper(QPainter &painter) const;

    const ThemeSource &m_theme;
    bool m_closed = true;
};

} // namespace mb
