// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <vector>

class QLabel;
class QScrollBar;

namespace mb {

class Arming;
class AxesPanel;
class EnvelopePanel;
class GainsPanel;
class GainsWriteRow;
class JogKeys;
class JogPanel;
class ModePanel;
class MovesPanel;
class SetPointPanel;
class Workbench;

/// The left column of the Tune page: axis, mode, envelope or set-point, gains and moves, and below them what writes the gains.
class TuneColumn : public QWidget {
    Q_OBJECT
public:
    /// `jog` outlives what is drawn here.
    TuneColumn(Workbench &workbench, Arming &arming, JogKeys &jog, const ThemeSource &theme, QWidget *parent);

    [[nodiscard]] AxesPanel &axesPanel() { return *m_axes; }
    [[nodiscard]] ModePanel &modePanel() { return *m_modes; }
    [[nodiscard]] SetPointPanel &setPointPanel() { return *m_setPoint; }
    [[nodiscard]] JogPanel &jogPanel() { return *m_jog; }
    [[nodiscard]] EnvelopePanel &envelope() { return *m_envelope; }
    [[nodiscard]] GainsPanel &gainsPanel() { return *m_gains; }
    [[nodiscard]] MovesPanel &movesPanel() { return *m_moves; }
    [[nodiscard]] GainsWriteRow &writeRow() { return *m_writeRow; }

    /// Set-point and jog of the live view instead of the envelope of the experiments.
    void setLive(bool live);
    /// 0: the device has one motor only.
    void setAxis(int axis);
    /// What Run is about: axes in order, or 0 for the one motor.
    [[nodiscard]] std::vector<int> motorsToRun() const;
    /// Says so where the first motion of an axis sets its power limit.
    void showFirstPower(const DeviceView &view, int axis);
    /// Puts its buttons behind `before` in the order of Tab: they are made anew for each family.
    void chainAfter(QWidget *before);

private:
    void buildPanels(Workbench &workbench, Arming &arming, JogKeys &jog, QWidget &panels);
    void layOut(QWidget &panels, const QScrollBar &bar);

    const ThemeSource &m_theme;
    AxesPanel *m_axes = nullptr;
    QWidget *m_axesLine = nullptr;
    ModePanel *m_modes = nullptr;
    SetPointPanel *m_setPoint = nullptr;
    JogPanel *m_jog = nullptr;
    EnvelopePanel *m_envelope = nullptr;
    QWidget *m_live = nullptr;
    QLabel *m_firstPower = nullptr;
    GainsPanel *m_gains = nullptr;
    MovesPanel *m_moves = nullptr;
    GainsWriteRow *m_writeRow = nullptr;
};

} // namespace mb
