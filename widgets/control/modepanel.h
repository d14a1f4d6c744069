// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <QWidget>

#include <vector>

class QButtonGroup;

namespace mb {

class SlotPanel;
class ThemeSource;

/// What the drive is to do: one of the modes of its family, and the gain slot that it is about.
class ModePanel : public QWidget {
    Q_OBJECT
public:
    explicit ModePanel(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Modes and slots of a family; keeps what is chosen where it exists there.
    void setFamily(const Family &family);
    [[nodiscard]] Mode mode() const { return m_mode; }
    [[nodiscard]] int editedSlot() const;
    [[nodiscard]] int runningSlot() const;
    /// Without a signal.
    void show(Mode mode, int edited, int running);
    /// SlotPanel::swap().
    void swapSlots();
    /// Puts the buttons behind `before` in the order of Tab: they are made anew for each family.
    void chainAfter(QWidget *before);

Q_SIGNALS:
    void modeChanged(mb::Mode mode);
    void editedSlotChanged(int slot);
    /// editedSlot() may have changed with it.
    void runningSlotChanged(int slot);

private:
    void rebuild();

    const Family *m_family = nullptr;
    Mode m_mode = Mode::Velocity;
    std::vector<Mode> m_modes;
    QButtonGroup *m_group = nullptr;
    QWidget *m_buttons = nullptr;
    SlotPanel *m_slots = nullptr;
};

} // namespace mb
