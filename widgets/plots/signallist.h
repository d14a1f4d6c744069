// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "widgets/common/signal.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <set>
#include <vector>

class QListWidget;
class QListWidgetItem;

namespace mb {

/// The device of derived signals; their channel is the place in the list of the page.
inline constexpr DeviceId derivedDevice{0};
/// Every channel of every device, and the derived signals, with a box: what is ticked is plotted. A double click or Enter
/// ticks, too; a drag carries the signal to a pane.
class SignalList : public QWidget {
    Q_OBJECT
public:
    static constexpr int UnitRole = Qt::UserRole + 2; ///< of an item

    explicit SignalList(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Devices may have come or gone. No row moves under the mouse: until it has left, what is gone can only be ticked no more, and what has
    /// come is listed where that is below all others.
    void setDevices(const std::vector<DeviceView> &devices);
    /// Names by place; an empty one is no signal any more.
    void setDerived(const QStringList &names);
    void setChosen(const std::set<Signal> &chosen);
    [[nodiscard]] QListWidget &list() { return *m_list; }

Q_SIGNALS:
    void toggled(mb::Signal signal, bool on);
    void newDerivedRequested();
    void removeDerivedRequested(int place);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Row {
        Signal signal;
        QString name;
        QString unit;
        QString hint;
    };
    void itemChanged(QListWidgetItem *item);
    [[nodiscard]] std::vector<Row> rows() const;
    void fill();
    void extend();
    void add(const Row &row);
    void showMenu(const QPoint &at);

    const ThemeSource &m_theme;
    std::set<Signal> m_chosen;
    QString m_shown;         ///< which devices, as text
    bool m_isBehind = false; ///< they are not listed as they should be
    std::vector<DeviceView> m_devices;
    QStringList m_derived;
    QListWidget *m_list = nullptr;
};

} // namespace mb
