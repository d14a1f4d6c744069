// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

#include <vector>

class QHBoxLayout;
class QLabel;

namespace mb {

class StateGlyph;
class ValueLabel;

/// One line above the page of a device: state, name, serial, firmware, and at the right its live values. Hidden while none is selected.
class DeviceLine : public QWidget {
    Q_OBJECT
public:
    DeviceLine(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent = nullptr);
    /// Wanted above this page; shown where there is a device.
    void setWanted(bool wanted);

protected:
    void showEvent(QShowEvent *) override { follow(); }
    void resizeEvent(QResizeEvent *event) override;

private:
    void buildIdentity(QHBoxLayout &row);
    void buildValues(QHBoxLayout &row);
    void follow();
    /// Those that there are, in the order in which they are shown as long as there is room.
    std::vector<ValueLabel *> showValues(const DeviceView &device);
    void fitValues(const std::vector<ValueLabel *> &wanted);
    [[nodiscard]] QString aboutOf(const DeviceView &device) const;

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    bool m_wanted = false;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_title = nullptr;
    QLabel *m_name = nullptr;
    QLabel *m_identity = nullptr;
    QWidget *m_values = nullptr;
    ValueLabel *m_position = nullptr; ///< of an axis: the devices with one motor have more to say
    ValueLabel *m_velocity = nullptr;
    ValueLabel *m_current = nullptr;
    ValueLabel *m_duty = nullptr;
    ValueLabel *m_bus = nullptr;
    ValueLabel *m_temperature = nullptr;
    StateGlyph *m_faultGlyph = nullptr;
    QLabel *m_faults = nullptr;
};

} // namespace mb
