// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace mb {

/// A part of a page that shrinks to the least height its own parts may have, lines that wrap counted, before the page scrolls: a table and a
/// list scroll by themselves. Without it what wraps makes a page as high as its parts would like to be.
class LeastHeight : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;
    [[nodiscard]] bool hasHeightForWidth() const override { return false; }
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
};

} // namespace mb
