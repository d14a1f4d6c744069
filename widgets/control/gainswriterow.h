// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

#include <optional>

namespace mb {

class CommandButton;

/// Two buttons below the gains: one writes what is staged, the other takes it back.
class GainsWriteRow : public QWidget {
    Q_OBJECT
public:
    struct State {
        QStringList staged;      ///< the rows, by name
        std::optional<int> slot; ///< of a device that has several
        bool free = false;       ///< the device could be written now
        bool fault = false;      ///< a row is out of range
        bool leap = false;       ///< a row waits for somebody to confirm it
    };

    explicit GainsWriteRow(const ThemeSource &theme, QWidget *parent);
    void show(const State &state);
    [[nodiscard]] bool mayWrite() const;

Q_SIGNALS:
    void writeRequested();
    void revertRequested();

private:
    CommandButton *m_write = nullptr;
    CommandButton *m_revert = nullptr;
};

} // namespace mb
