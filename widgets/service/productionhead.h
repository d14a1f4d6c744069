// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/recipematter.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;

namespace mb {

class CommandButton;
class HoldButton;
class ThemeSource;
struct ServiceView;
struct Snapshot;

/// What production does to every unit, on which link, and its orders. GUI thread.
class ProductionHead : public QWidget {
    Q_OBJECT
public:
    /// `chosen`: address of the link that somebody has chosen, which outlives this.
    ProductionHead(const ThemeSource &theme, QString &chosen, QWidget *parent);

    /// The recipe of what is in sight; nullptr: none yet. `canStart`: the page has one of its own.
    void show(const service::RecipeMatter *matter, bool canStart);
    void follow(const ServiceView &view);
    /// Offers the links that are open; what was chosen stays so, whatever becomes of it. Shows the one that units are served on.
    void follow(const Snapshot &shot, const ServiceView &view);
    /// Address of the chosen link; empty without one.
    [[nodiscard]] QString link() const;
    /// It is the chosen one from now on, also where nobody has chosen it by hand.
    void keepLink() { m_chosen = link(); }
    [[nodiscard]] HoldButton &armButton() const { return *m_arm; }
    [[nodiscard]] QLineEdit &serial() const { return *m_serial; }

Q_SIGNALS:
    void recipeWanted();
    /// To be started, or to be ended while units are served.
    void startWanted();
    void armWanted();
    void leaveWanted();
    /// Scanned or typed, without spaces around it.
    void serialTaken(const QString &serial);

private:
    void buildFacts(QHBoxLayout &row);
    void buildOrders(QWidget &orders);

    const ThemeSource &m_theme;
    QString &m_chosen;
    QLabel *m_name = nullptr;
    QLabel *m_image = nullptr;
    QLabel *m_parameters = nullptr;
    QLabel *m_number = nullptr;
    QLabel *m_test = nullptr;
    QComboBox *m_link = nullptr;
    CommandButton *m_start = nullptr;
    HoldButton *m_arm = nullptr;
    bool m_canStart = false;
    QLineEdit *m_serial = nullptr;
};

} // namespace mb
