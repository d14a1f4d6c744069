// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include "model/family.h"
#include "transport/linkcatalog.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QPushButton;

namespace mb {

class ProgrammerBox;

/// The way in for an update of a family that is not updated over its own link: programmer or serial port, kind of
/// microcontroller, whether what the unit has stored is erased, and what is not known of the way. Hidden for the others.
class RoutePanel : public QWidget {
    Q_OBJECT
public:
    explicit RoutePanel(const ThemeSource &theme, QWidget *parent = nullptr);
    /// nullptr: no device. The listings name the serial ports that there are; `own` is the address of the device's link.
    void show(const Family *family, const std::vector<LinkListing> &listings, const std::string &own);
    [[nodiscard]] UpdateOptions options() const;
    /// What a unit has stored is erased in one update of one unit: the next one is asked anew.
    void keepSettings();
    /// As typed into the field.
    void setVia(const QString &via);
    /// What is missing before an update can begin; empty when nothing is.
    [[nodiscard]] QString missing() const;

Q_SIGNALS:
    void changed();

private:
    struct Field {
        const UpdateSetting *setting = nullptr;
        QComboBox *value = nullptr;
    };
    void buildFields(const UpdateRoute &route);
    void listPorts(const UpdateRoute &route, const std::vector<LinkListing> &listings);
    [[nodiscard]] bool hasProgrammers() const;
    [[nodiscard]] QString viaWithSettings() const;

    const ThemeSource &m_theme;
    const Family *m_family = nullptr;
    QStringList m_ports;
    QComboBox *m_via = nullptr;            ///< of a route that names no programmers
    ProgrammerBox *m_programmer = nullptr; ///< of the others
    QComboBox *m_target = nullptr;
    QCheckBox *m_erase = nullptr;
    QPushButton *m_more = nullptr;
    QWidget *m_settings = nullptr;
    std::vector<Field> m_fields;
};

} // namespace mb
