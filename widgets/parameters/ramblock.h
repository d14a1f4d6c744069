// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <functional>

class QGridLayout;
class QLabel;
class QProgressBar;
class QTimer;

namespace mb {

class CommandButton;

/// What RAM has and flash perhaps not: the values, the time until the device stores by itself, and the button that
/// waits for its proof. Hidden while there is nothing.
class RamBlock : public QWidget {
    Q_OBJECT
public:
    /// `now` is on the line of all time stamps.
    RamBlock(const ThemeSource &theme, std::function<Instant()> now, QWidget *parent);

    struct State {
        const Family *family = nullptr;
        Shared<std::vector<ParameterStore::Entry>> parameters;
        std::optional<Instant> lastWrite;
        bool mayStore = false; ///< online and not busy
    };
    void show(State state);

Q_SIGNALS:
    void storeRequested();

private:
    void build();
    void fillRows(const std::vector<ParameterIndex> &held);
    void tick();

    const ThemeSource &m_theme;
    std::function<Instant()> m_now;
    State m_state;
    QLabel *m_left = nullptr;
    QProgressBar *m_bar = nullptr;
    QGridLayout *m_grid = nullptr;
    QLabel *m_hint = nullptr;
    CommandButton *m_store = nullptr;
    QTimer *m_timer = nullptr;
    std::vector<QLabel *> m_labels;
    std::size_t m_held = 0;
};

} // namespace mb
