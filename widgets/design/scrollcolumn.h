// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QScrollArea>

#include <initializer_list>

class QVBoxLayout;

namespace mb {

/// A column of a page: it scrolls before anything in it is squeezed. Takes no focus of its own.
class ScrollColumn : public QScrollArea {
    Q_OBJECT
public:
    ScrollColumn(const Theme &theme, QWidget *parent);

    /// Parent of what goes into it.
    [[nodiscard]] QWidget *content() { return m_content; }
    [[nodiscard]] QVBoxLayout &rows() { return *m_rows; }
    /// Whether there is room for these of its rows, one below the other, without scrolling. What was hidden or shown in them counts at once.
    [[nodiscard]] bool isInSight(std::initializer_list<QWidget *> parts) const;

private:
    QWidget *m_content = nullptr;
    QVBoxLayout *m_rows = nullptr;
};

} // namespace mb
