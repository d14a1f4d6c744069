// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <vector>

class QWidget;

namespace mb {

/// What can have the focus by Tab in this window, as it is read: group by group as the layouts nest, in each from the top to the
/// bottom and from left to right. What is hidden or off is left out.
[[nodiscard]] std::vector<QWidget *> readingOrder(const QWidget &window);

/// Tab goes through a window in the order in which it is read, whatever order its parts were made in: rows come and go, and columns become
/// rows in a narrow window. What takes Tab for itself keeps it. Install on the application. GUI thread.
class FocusOrder : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] static bool takesTab(const QWidget &widget);
    static void go(QWidget &from, bool forwards);
};

} // namespace mb
