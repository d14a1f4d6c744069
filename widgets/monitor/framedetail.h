// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/monitor/framefilter.h"

#include <QWidget>

class QLabel;
class QTableWidget;

namespace mb {

/// The selected frame: what it is, its bytes, every field with its value.
class FrameDetail : public QWidget {
    Q_OBJECT
public:
    explicit FrameDetail(const ThemeSource &theme, QWidget *parent = nullptr);
    void show(const FrameRow &row);

private:
    const ThemeSource &m_theme;
    FrameRow m_row;
    QLabel *m_message = nullptr;
    QLabel *m_id = nullptr;
    QLabel *m_bytes = nullptr;
    QTableWidget *m_fields = nullptr;
};

} // namespace mb
