// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "widgets/common/displayunits.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/telemetrysource.h"

#include <QTimer>

#include <map>

class QComboBox;
class QLineEdit;

namespace mb {

class IconButton;
class Segmented;
class Workbench;

/// What the motor does, live: the commanded quantity with its set-point, and two more that explain it, above one axis of
/// time; units, window and pause above. Fetches and draws only while it can be seen.
class TunePlot : public QWidget {
    Q_OBJECT
public:
    TunePlot(Workbench &workbench, const ThemeSource &theme, QWidget *parent = nullptr);

    /// The traces of a device in a mode. Nothing changes while both stay the same. Of a board, of one of its axes; what the
    /// mode commands is shown of the axes `beside` it, too, each in its colour.
    void choose(const DeviceView &device, Mode mode, int axis = 0, const std::vector<int> &beside = {});
    /// Rates and the present; every snapshot.
    void follow(const DeviceView &device);
    void setUnits(const DisplayUnits &units);
    [[nodiscard]] const DisplayUnits &units() const { return m_units; }
    [[nodiscard]] PlotStack &stack() { return *m_stack; }

Q_SIGNALS:
    void unitsChanged(const mb::DisplayUnits &units);

protected:
    void showEvent(QShowEvent *) override { m_tick.start(); }
    void hideEvent(QHideEvent *event) override;

private:
    /// Set-points of another mode have another unit: those before are not drawn.
    struct Told {
        Mode mode = Mode::Off;
        Instant since{};
    };

    QWidget *buildBar();
    void buildUnits(class QLayout &row);
    void buildView(class QLayout &row);
    bool addTrace(const DeviceView &device, std::string_view channel, int strip, bool main, int axis);
    void addSetPoint(const DeviceView &device, int strip, const ShownUnit &unit, int axis);
    [[nodiscard]] QString nameOf(const Channel &row, int axis) const;
    void rebuild(const DeviceView &device);
    void countsTyped();
    void tick();
    void draw();

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    DeviceId m_device;
    Mode m_mode = Mode::Off;
    int m_axis = 0;
    std::vector<int> m_beside;
    DisplayUnits m_units;
    std::map<std::pair<DeviceId, int>, Told> m_told; ///< by device and axis
    Instant m_since{};
    std::shared_ptr<const Telemetry> m_telemetry;
    const Channel *m_table = nullptr; ///< its units (Telemetry::useTable)
    std::vector<std::shared_ptr<TelemetrySource>> m_sources;
    std::uint64_t m_drawn = 0;
    double m_drawnAt = 0.0;
    QTimer m_tick;
    Segmented *m_unitChoice = nullptr;
    QLineEdit *m_counts = nullptr;
    QComboBox *m_window = nullptr;
    IconButton *m_pause = nullptr;
    PlotStack *m_stack = nullptr;
};

} // namespace mb
