// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/glyphshapes.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <string>
#include <vector>

class QLabel;

namespace mb {

class StateGlyph;
class WrapLayout;
struct JournalState;
struct Snapshot;

/// Something that must hold before a unit is served.
struct UnitCheck {
    GlyphState glyph = GlyphState::Done;
    QString words;
    friend bool operator==(const UnitCheck &, const UnitCheck &) = default;
};

/// What the window knows of the link that units are put on, of what is on it, and of the journal.
[[nodiscard]] std::vector<UnitCheck> checksOf(
    const Snapshot &shot, const JournalState &journal, const std::string &link);

/// Such checks in a row, each with its shape. GUI thread.
class UnitChecks : public QWidget {
    Q_OBJECT
public:
    explicit UnitChecks(const ThemeSource &theme, QWidget *parent);
    void show(const std::vector<UnitCheck> &checks);
    [[nodiscard]] QString text() const;

private:
    struct Item {
        QWidget *box = nullptr;
        StateGlyph *glyph = nullptr;
        QLabel *words = nullptr;
    };
    void add();

    const ThemeSource &m_theme;
    WrapLayout *m_row = nullptr;
    std::vector<UnitCheck> m_checks;
    std::vector<Item> m_items;
};

} // namespace mb
