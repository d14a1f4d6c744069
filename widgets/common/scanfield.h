// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace mb {

/// A field for a scanner, which types as a keyboard does, only faster than a hand. Space belongs to it among such keys and stops motors
/// otherwise: it has the focus all day.
class ScanField : public QLineEdit {
    Q_OBJECT
public:
    using QLineEdit::QLineEdit;
};

} // namespace mb
