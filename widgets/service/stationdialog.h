// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;

namespace mb {

class Workbench;

/// Asks for the name of this station and the server that stations share their journal on. Closes once that is so; a mistake is
/// said in it. GUI thread.
class StationDialog : public QDialog {
    Q_OBJECT
public:
    StationDialog(Workbench &workbench, QWidget *parent);

    [[nodiscard]] QLineEdit &server() const { return *m_server; }
    [[nodiscard]] QLineEdit &station() const { return *m_station; }
    /// Why it was not taken; empty: nothing was wrong so far.
    [[nodiscard]] QString mistake() const;
    void accept() override;

private:
    Workbench &m_workbench;
    QLineEdit *m_server = nullptr;
    QLineEdit *m_station = nullptr;
    QLabel *m_mistake = nullptr;
};

} // namespace mb
