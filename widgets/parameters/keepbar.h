// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QFrame>

#include <optional>

class QGridLayout;
class QLabel;
class QProgressBar;

namespace mb {

class CommandButton;
class ElidedLabel;
class ThemeSource;

/// "Keep these values? They go back in 18 s": the change of settings that waits for somebody (Snapshot::unconfirmed), with its
/// time as a bar, Keep and Put back; hidden without one. Of several the one that goes first. GUI thread.
class KeepBar : public QFrame {
    Q_OBJECT
public:
    KeepBar(Workbench &workbench, const ThemeSource &theme, QWidget *parent);
    /// What the bar asks, as it stands there; empty while it is hidden.
    [[nodiscard]] QString question() const;
    void keep();
    void putBack();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void placeButtons();
    void follow();
    void showChange(const UnconfirmedView &view, int more);
    [[nodiscard]] const UnconfirmedView *first() const;

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    DeviceId m_device;
    std::int64_t m_change = 0; ///< whose words stand there
    ElidedLabel *m_question;
    QLabel *m_countdown;
    ElidedLabel *m_values;
    QProgressBar *m_time;
    CommandButton *m_keep;
    CommandButton *m_back;
    QGridLayout *m_grid = nullptr;
    std::optional<bool> m_below; ///< the words; nothing: nowhere yet
};

} // namespace mb
