// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace mb {

/// Versions of the program and of everything that it runs on, a line each: what a report of a fault should contain. English.
[[nodiscard]] QString versions();

/// What the program is, its versions with a button that copies them, and the licences of what it is made of.
class About : public QDialog {
    Q_OBJECT
public:
    explicit About(QWidget *parent);
};

} // namespace mb
