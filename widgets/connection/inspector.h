// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

#include <vector>

class QLabel;
class QVBoxLayout;

namespace mb {

class AxisCells;
class CommandButton;
class ProfilePanel;
class ValueLabel;

/// The right dock: everything known about the selected device, as rows.
class Inspector : public QWidget {
    Q_OBJECT
public:
    Inspector(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent = nullptr);
    [[nodiscard]] QSize sizeHint() const override;

private:
    void buildActions(QVBoxLayout &column);
    void buildLive(QVBoxLayout &column);
    void buildIdentity(QVBoxLayout &column);
    void buildParameters(QVBoxLayout &column);
    void showLive(const DeviceView &device);
    ValueLabel *addRow(QVBoxLayout &column, const QString &caption);
    void follow();
    void showParameters(const DeviceView &device);

    struct LiveRow {
        std::string_view channel;
        ValueLabel *label;
    };

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    QLabel *m_title = nullptr;
    QLabel *m_subtitle = nullptr;
    CommandButton *m_identify = nullptr;
    CommandButton *m_read = nullptr;
    std::vector<LiveRow> m_live;
    AxisCells *m_axes = nullptr;
    ProfilePanel *m_profile = nullptr;
    ValueLabel *m_serial = nullptr;
    ValueLabel *m_firmware = nullptr;
    ValueLabel *m_bootloader = nullptr;
    ValueLabel *m_session = nullptr;
    ValueLabel *m_limits = nullptr;
    ValueLabel *m_faults = nullptr;
    ValueLabel *m_changed = nullptr;
    ValueLabel *m_ram = nullptr;
};

} // namespace mb
