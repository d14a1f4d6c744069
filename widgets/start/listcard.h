// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/card.h"
#include "widgets/common/icons.h"

#include <vector>

namespace mb {

/// A card of rows, each a symbol, a name, a second line and one thing that can be done with it.
class ListCard : public Card {
    Q_OBJECT
public:
    struct Row {
        Symbol symbol = Symbol::Document;
        QString name;
        QString words;
        QString action; ///< text of its button
        QString tooltip;
        friend bool operator==(const Row &a, const Row &b)
        {
            return a.symbol == b.symbol && a.name == b.name && a.words == b.words && a.action == b.action
                && a.tooltip == b.tooltip;
        }
    };

    ListCard(const ThemeSource &theme, const QString &title, QWidget *parent = nullptr);

    /// `none` stands where there is no row.
    void setRows(std::vector<Row> rows, const QString &none);

Q_SIGNALS:
    void activated(int row);

private:
    [[nodiscard]] QWidget *makeRow(const Row &row, int at);

    const ThemeSource &m_theme;
    QWidget *m_box = nullptr;
    std::vector<Row> m_rows;
    QString m_none;
};

} // namespace mb
