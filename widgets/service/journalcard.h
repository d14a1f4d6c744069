// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

class QLabel;

namespace mb {

class CommandButton;
class StateGlyph;
class Workbench;

/// Where the journal of a bench is kept, and whether its server has every entry; to be changed while nothing is served. GUI thread.
class JournalCard : public QWidget {
    Q_OBJECT
public:
    JournalCard(Workbench &workbench, const ThemeSource &theme, QWidget *parent);

    /// "3 entries wait: the server does not answer", as it stands there.
    [[nodiscard]] QString text() const;

private:
    void follow();
    void ask();

    Workbench &m_workbench;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_place = nullptr;
    QLabel *m_state = nullptr;
    CommandButton *m_change = nullptr;
};

} // namespace mb
