// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/start/story.h"

#include <QWidget>

namespace mb {

/// What a story is about, drawn: a sketch, not a measurement.
class StoryDrawing : public QWidget {
    Q_OBJECT
public:
    StoryDrawing(StoryPicture picture, const QString &caption, const ThemeSource &theme, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void paintCurve(QPainter &painter, const QRectF &box) const;

    StoryPicture m_picture;
    QString m_caption;
    const ThemeSource &m_theme;
};

} // namespace mb
