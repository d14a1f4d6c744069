// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QComboBox;
class QGridLayout;
class QLabel;

namespace mb {

/// What the drive is to do: one of the modes of its family, and the gain slots that are edited and that run.
class ModePanel : public QWidget {
    Q_OBJECT
public:
    explicit ModePanel(QWidget *parent = nullptr);

    /// Modes and slots of a family; keeps what is chosen where it exists there.
    void setFamily(const Family &family);
    [[nodiscard]] Mode mode() const { return m_mode; }
    [[nodiscard]] int editedSlot() const;
    [[nodiscard]] int runningSlot() const;
    /// Without a signal.
    void show(Mode mode, int edited, int running);

Q_SIGNALS:
    void modeChanged(mb::Mode mode);
    void editedSlotChanged(int slot);
    void runningSlotChanged(int slot);

private:
    void rebuild();
    void updateSlots();

    const Family *m_family = nullptr;
    Mode m_mode = Mode::Velocity;
    std::vector<Mode> m_modes;
    QButtonGroup *m_group = nullptr;
    QWidget *m_buttons = nullptr;
    QWidget *m_slots = nullptr;
    QComboBox *m_edited = nullptr;
    QComboBox *m_running = nullptr;
};

} // namespace mb
