// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

class QGridLayout;
class QScrollArea;

namespace mb {

class DesignCourse;
class DesignOrders;
class Segmented;

/// Where the parts of the Design page stand. With room: status and orders in one row, below it model and proposals, curves, and what
/// happens, side by side. Without (large fonts, small screens): the orders stand below the status, and one part is seen at a time,
/// chosen in a row of tabs, beside which stands the order to prove. GUI thread.
class DesignFrame : public QWidget {
    Q_OBJECT
public:
    struct Parts {
        QWidget *status = nullptr;
        DesignOrders *orders = nullptr; ///< folds and wraps where it is narrow
        QWidget *model = nullptr;
        QWidget *curves = nullptr;
        DesignCourse *course = nullptr;
    };

    explicit DesignFrame(const ThemeSource &theme, QWidget *parent = nullptr);
    /// Takes them; once.
    void setParts(const Parts &parts);
    /// Little: it arranges itself into what it gets, and its parts scroll.
    [[nodiscard]] bool hasHeightForWidth() const override { return false; }
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *) override { fold(); }
    bool event(QEvent *event) override;

private:
    /// Tabs of the compact arrangement.
    enum class Part { Model, Curves, Course };

    void arrange();
    void fold();
    void foldTabs();
    [[nodiscard]] int courseNow() const;
    void setWidth(QWidget &column, int width) const;

    const ThemeSource &m_theme;
    Parts m_parts;
    QGridLayout *m_grid = nullptr;
    QGridLayout *m_commands = nullptr;
    QWidget *m_tabsRow = nullptr;
    Segmented *m_tabs = nullptr;
    QScrollArea *m_curvesArea = nullptr;
    QWidget *m_lineBefore = nullptr;
    QWidget *m_lineBehind = nullptr;
    bool m_compact = false;
    bool m_stacked = false; ///< the status stands above the orders
};

} // namespace mb
