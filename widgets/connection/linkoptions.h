// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/linkaddress.h"
#include "widgets/connection/linkchoices.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace mb {

/// Options of a link by choosing: bit rate and RS-485 of a serial port, clock and GPIO lines of an SPI device, losses of a
/// simulated link. Shows those of one kind at a time.
class LinkOptions : public QWidget {
    Q_OBJECT
public:
    explicit LinkOptions(QWidget *parent = nullptr);

    void setKind(LinkChoice::Kind kind);
    /// GPIO lines that can be named: "gpiochip0:25" and what the system calls them.
    void setLines(const std::vector<std::pair<QString, QString>> &lines);
    /// Those that were chosen, in the order of docs/names.md#links; a choice that is the usual one adds none.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> options() const;

Q_SIGNALS:
    void changed();

private:
    void buildSerial();
    void buildSpi();
    void buildSimulated();
    [[nodiscard]] QComboBox *addBox(const QString &name, const char *objectName);

    QFormLayout *m_form = nullptr;
    LinkChoice::Kind m_kind = LinkChoice::Kind::Can;
    QComboBox *m_baud = nullptr;
    QCheckBox *m_rs485 = nullptr;
    QComboBox *m_speed = nullptr;
    QComboBox *m_ready = nullptr;
    QComboBox *m_reset = nullptr;
    QComboBox *m_loss = nullptr;
};

} // namespace mb
