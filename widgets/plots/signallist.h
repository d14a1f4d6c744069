// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <compare>
#include <set>

class QListWidget;
class QListWidgetItem;

namespace mb {

/// One channel of one device, as long as the program runs.
struct Signal {
    DeviceId device;
    ChannelIndex channel;
    friend auto operator<=>(const Signal &, const Signal &) = default;
};

/// "#5 velocity"
[[nodiscard]] QString signalName(const DeviceView &device, ChannelIndex channel);

/// Every channel of every device with a box: what is ticked is plotted. A double click or Enter ticks, too.
class SignalList : public QWidget {
    Q_OBJECT
public:
    explicit SignalList(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Devices may have come or gone.
    void setDevices(const std::vector<DeviceView> &devices);
    void setChosen(const std::set<Signal> &chosen);
    [[nodiscard]] QListWidget &list() { return *m_list; }

Q_SIGNALS:
    void toggled(mb::Signal signal, bool on);

private:
    void itemChanged(QListWidgetItem *item);

    const ThemeSource &m_theme;
    std::set<Signal> m_chosen;
    QString m_shown; ///< which devices, as text
    QListWidget *m_list = nullptr;
};

} // namespace mb
