// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings.h"
#include "widgets/common/keybook.h"

#include <QObject>

namespace mb {

/// Those that stop, arm, press and keep: handled elsewhere, said in this table, and nobody's to change.
void noteFixedKeys(PageKeys &window);

/// The keys that the user has chosen, in the settings and in every table of the window: a page gets them when it is made, all others at
/// once. Lives as long as the window.
class KeyDesk : public QObject {
    Q_OBJECT
public:
    /// `page` makes the page of a tab where there is none yet.
    KeyDesk(QWidget &window, Settings &settings, std::function<QWidget *(int)> page);

    /// Every command with its key; makes the pages that were not made yet.
    [[nodiscard]] KeyBook book();
    /// Kept, and in force from now on.
    void use(const KeyChoices &choices);

    /// To every table that there is now.
    void apply();

private:
    void nameTabs();

    QWidget &m_window;
    Settings &m_settings;
    std::function<QWidget *(int)> m_page;
};

} // namespace mb
