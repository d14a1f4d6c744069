// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/pagekeys.h"

namespace mb {

/// Every command that has or may have a key, from the tables that make the keys, while somebody changes them. What is chosen here
/// holds once it is given back to those tables (PageKeys::use).
class KeyBook {
public:
    struct Row {
        QString place;   ///< page, as its tab says; "Everywhere"
        bool everywhere; ///< of the window: acts on every page
        QString id;      ///< PageKeys::idOf
        QString does;    ///< a short phrase
        std::vector<QKeySequence> factory;
        std::vector<QKeySequence> keys;
        bool changeable; ///< not those that stop, arm, or belong to what has the focus
    };

    /// The table of a page, or of the window.
    void add(const QString &place, bool everywhere, const PageKeys &keys);
    [[nodiscard]] const std::vector<Row> &rows() const { return m_rows; }

    /// Why this row cannot have this key, with the name of what has it; empty: it can.
    [[nodiscard]] QString refusal(std::size_t row, const QKeySequence &key) const;
    /// The row has this key and no other; an empty one: it has none. Refused keys change nothing.
    bool choose(std::size_t row, const QKeySequence &key);
    /// The keys it came with; refused, with the reason, where another row has one of them now.
    [[nodiscard]] QString reset(std::size_t row);
    void resetAll();
    /// Rows whose keys are not those they came with.
    [[nodiscard]] KeyChoices choices() const;
    /// Those of these choices that may be had: what somebody wrote into the settings by hand takes no stop key away.
    void take(const KeyChoices &choices);

private:
    std::vector<Row> m_rows;
};

} // namespace mb
