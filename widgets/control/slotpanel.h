// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace mb {

class Segmented;

/// The gain slot: one choice, edited and run. Editing one slot while another runs takes a deliberate "Split", and amber words
/// stand below for as long as it lasts.
class SlotPanel : public QWidget {
    Q_OBJECT
public:
    SlotPanel(const ThemeSource &theme, QWidget *parent);

    /// How many the family has; hidden below two. Everything is joined again, at slot 0.
    void setCount(int count);
    [[nodiscard]] int edited() const { return m_edited; }
    [[nodiscard]] int running() const { return m_running; }
    /// Split where they differ. Without a signal.
    void show(int edited, int running);
    /// Edited and running slot change places; where one is both, the next one becomes both. Nothing where there is one only.
    void swap();

Q_SIGNALS:
    void editedChanged(int slot);
    /// edited() may have changed with it.
    void runningChanged(int slot);

private:
    QWidget *buildJoined();
    QWidget *buildApart();
    QWidget *buildNote();
    void choose(int edited, int running);
    void refresh();

    const ThemeSource &m_theme;
    int m_edited = 0;
    int m_running = 0;
    bool m_split = false;
    QVBoxLayout *m_column = nullptr;
    QWidget *m_content = nullptr;
    QWidget *m_joinedRow = nullptr;
    QWidget *m_apartRow = nullptr;
    QWidget *m_noteRow = nullptr;
    QLabel *m_note = nullptr;
    Segmented *m_both = nullptr;
    Segmented *m_editedChoice = nullptr;
    Segmented *m_runningChoice = nullptr;
    int m_count = 0;
};

} // namespace mb
