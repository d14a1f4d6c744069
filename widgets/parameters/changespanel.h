// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"
#include "widgets/parameters/parametermodel.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QVBoxLayout;

namespace mb {

class ChangeRow;
class CommandButton;
class RamBlock;

/// Everything that would be written, in the order of writing; what is in RAM only; Discard and Write.
class ChangesPanel : public QWidget {
    Q_OBJECT
public:
    ChangesPanel(const ThemeSource &theme, Workbench &workbench, ParameterModel &model, QWidget *parent);

    /// After a change of edits, snapshot or selection. `device` may be nullptr.
    void refresh(const DeviceView *device, const OperationView *operation);
    [[nodiscard]] bool mayWrite() const;
    /// Below the table: without head and explanation, what writes above what is written.
    void setCompact(bool compact);
    /// Something is staged, in RAM only, or being done.
    [[nodiscard]] bool isFilled() const { return m_filled; }
    /// As wide as it must be: what it says breaks, and the table has the rest.
    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    void filled(bool filled);
    void writeRequested();
    void discardRequested();
    void storeRequested();
    void parameterActivated(mb::ParameterIndex index);

private:
    QWidget *buildHead();
    QWidget *buildBody();
    QWidget *buildFoot();
    void fillRows();
    void fillFoot(const DeviceView *device, const OperationView *operation);
    [[nodiscard]] QString obstacle(const DeviceView *device, bool busy) const;
    [[nodiscard]] QString proofNote(const DeviceView *device) const;

    const ThemeSource &m_theme;
    Workbench &m_workbench;
    ParameterModel &m_model;
    QVBoxLayout *m_all = nullptr;
    QWidget *m_head = nullptr;
    QWidget *m_foot = nullptr;
    QVBoxLayout *m_column = nullptr;
    QLabel *m_empty = nullptr;
    RamBlock *m_ram = nullptr;
    QLabel *m_note = nullptr;
    QLabel *m_step = nullptr;
    QProgressBar *m_progress = nullptr;
    CommandButton *m_discard = nullptr;
    CommandButton *m_write = nullptr;
    std::vector<ChangeRow *> m_rows;
    bool m_compact = false;
    bool m_filled = false;
};

} // namespace mb
