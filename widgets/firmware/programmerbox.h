// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include "model/family.h"
#include "transport/linkcatalog.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QLabel;

namespace mb {

/// The programmer of an update and where it is plugged in: chosen from what the program of the route usually works with and
/// from the serial ports that there are, or typed. Yields both as `--via` takes them.
class ProgrammerBox : public QWidget {
    Q_OBJECT
public:
    ProgrammerBox(const ThemeSource &theme, QWidget *parent);
    /// A route with programmers; outlives this.
    void show(const UpdateRoute &route);
    /// `own`: address of the device's own link, whose port comes first.
    void listPorts(const std::vector<LinkListing> &listings, const std::string &own);
    [[nodiscard]] QString via() const;
    /// What is missing before an update can begin; empty when nothing is.
    [[nodiscard]] QString missing() const;

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] static QComboBox *makeBox(QWidget *parent, const QString &name, const QString &help);
    [[nodiscard]] static QString chosen(const QComboBox &box);
    [[nodiscard]] Programmer::Port portKind() const;
    void followProgrammer();

    const UpdateRoute *m_route = nullptr;
    std::vector<std::pair<QString, QString>> m_ports; ///< path, and what it is
    QComboBox *m_programmer = nullptr;
    QLabel *m_at = nullptr;
    QComboBox *m_port = nullptr;
};

} // namespace mb
