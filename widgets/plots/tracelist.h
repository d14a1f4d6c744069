// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/traceplottable.h"

#include <QWidget>

#include <vector>

class QVBoxLayout;

namespace mb {

/// What is plotted: swatch, name, source, rate, loss and the newest value, with a button that removes it.
class TraceList : public QWidget {
    Q_OBJECT
public:
    struct Row {
        int id = 0;
        TraceLook look;
        QString name;
        QString source; ///< "can0, encoder counts"
        QString rate;
        QString lost;
        bool lossy = false;
        QString value;
        QString cursors;    ///< "A 799  B 1 503", instead of the value while the cursors are shown
        QString statistics; ///< "mean 12  σ 0.4  min … max" of the samples between them

        friend bool operator==(const Row &a, const Row &b)
        {
            return a.id == b.id && a.name == b.name && a.source == b.source && a.rate == b.rate && a.lost == b.lost
                && a.value == b.value && a.cursors == b.cursors && a.statistics == b.statistics
                && a.look.colourRole() == b.look.colourRole() && a.look.dash == b.look.dash;
        }
    };

    explicit TraceList(const ThemeSource &theme, QWidget *parent = nullptr);
    void setRows(std::vector<Row> rows);
    [[nodiscard]] const std::vector<Row> &rows() const { return m_rows; }

Q_SIGNALS:
    void removeRequested(int id);
    /// A row's menu is wanted, there on the screen.
    void menuRequested(int id, const QPoint &at);

private:
    class Entry;
    void rebuild();

    const ThemeSource &m_theme;
    std::vector<Row> m_rows;
    std::vector<Entry *> m_entries;
    QVBoxLayout *m_column = nullptr;
};

} // namespace mb
