// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "widgets/common/card.h"

#include <array>

class QLabel;

namespace mb {

class AxisCells;
class CommandButton;
class Sparkline;
class ValueLabel;

/// One device on the Overview: three live values, the last ten seconds, rate, loss and faults. In its bootloader the card says
/// so and offers the update.
class DeviceCard : public Card {
    Q_OBJECT
public:
    DeviceCard(const ThemeSource &theme, QWidget *parent);
    void show(const DeviceView &device, Instant now, bool selected);
    /// How many columns it takes where there are as many.
    [[nodiscard]] int columns() const { return m_axes ? 2 : 1; }

Q_SIGNALS:
    void updateRequested();
    void axisActivated(int axis);

private:
    void buildLive();
    void buildNote();
    void showAxes(const DeviceView &device, Instant now);
    void showValues(const DeviceView &device, Instant now);
    void showSparkline(const DeviceView &device, Instant now);
    void showFoot(const DeviceView &device);

    const ThemeSource &m_theme;
    QWidget *m_live = nullptr;
    AxisCells *m_axes = nullptr; ///< instead of the values of one motor; made for the first board that is shown
    std::array<ValueLabel *, 3> m_values{};
    QLabel *m_range = nullptr;
    Sparkline *m_sparkline = nullptr;
    QWidget *m_note = nullptr;
    QLabel *m_noteCause = nullptr;
    QLabel *m_noteRemedy = nullptr;
    CommandButton *m_update = nullptr;
    QLabel *m_badge = nullptr;
    QLabel *m_rate = nullptr;
    StateGlyph *m_faultGlyph = nullptr;
    QLabel *m_faults = nullptr;
};

} // namespace mb
