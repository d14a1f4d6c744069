// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/traceplottable.h"

#include <QWidget>

#include <vector>

namespace mb {

class WrapLayout;

/// The strip above a plot: its title, and what its lines are, one behind the other and below each other where it is narrow.
class CurveLegend : public QWidget {
    Q_OBJECT
public:
    enum class Shape { Line, Band, Filled, Hollow, Faint };
    struct Entry {
        QString name;
        TraceLook look;
        Shape shape = Shape::Line; ///< Filled and below: points without a line
        friend bool operator==(const Entry &a, const Entry &b) { return a.name == b.name && a.shape == b.shape; }
    };

    /// An empty title has no place.
    CurveLegend(const ThemeSource &theme, const QString &title, QWidget *parent = nullptr);

    void setTitle(const QString &title);
    void setEntries(const std::vector<Entry> &entries);

private:
    const ThemeSource &m_theme;
    WrapLayout *m_row = nullptr;
    QWidget *m_title = nullptr;
    std::vector<Entry> m_entries;
    std::vector<QWidget *> m_shown;
};

} // namespace mb
