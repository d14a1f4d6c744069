// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/motionrenewal.h"
#include "widgets/common/theme.h"

#include <QDialog>
#include <QTimer>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QVBoxLayout;

namespace mb {

class HoldButton;

/// An experiment of a device (Family::experiments), guided: what happens, what must be so, how much power is allowed; progress,
/// log, result. What moves begins only when the button was held, and goes on only while this dialog is alive and the program
/// has the focus: it renews the motion lease. Closing it cancels.
class ExperimentDialog : public QDialog {
    Q_OBJECT
public:
    ExperimentDialog(Workbench &workbench, DeviceId device, const Experiment &experiment, const ThemeSource &theme,
        QWidget *parent = nullptr);
    ~ExperimentDialog() override;

    /// As the held button.
    void start();
    [[nodiscard]] bool isRunning() const { return m_running; }
    [[nodiscard]] QString result() const;

private:
    void buildQuestions(QVBoxLayout &column);
    void buildProgress(QVBoxLayout &column);
    void buildButtons(QVBoxLayout &column);
    void follow();
    void cancel();
    void ended(const Result<void> &result);
    [[nodiscard]] const OperationView *operation() const;

    Workbench &m_workbench;
    DeviceId m_device;
    const Experiment &m_experiment;
    const ThemeSource &m_theme;
    QComboBox *m_axis = nullptr;
    QDoubleSpinBox *m_power = nullptr;
    QComboBox *m_answer = nullptr;
    QLabel *m_step = nullptr;
    QProgressBar *m_progress = nullptr;
    QListWidget *m_log = nullptr;
    QLabel *m_result = nullptr;
    HoldButton *m_start = nullptr;
    QPushButton *m_close = nullptr;
    MotionRenewal m_renewal;
    OperationId m_before; ///< the newest operation when it was started
    bool m_running = false;
    std::size_t m_lines = 0;
};

} // namespace mb
