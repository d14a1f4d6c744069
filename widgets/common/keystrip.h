// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

#include <vector>

namespace mb {

/// A line that names keys as caps, as they are now, and says what each does: "[F5] test again  [F8] set aside". Goes on in the next line
/// where it does not fit. GUI thread.
class KeyStrip : public QWidget {
    Q_OBJECT
public:
    struct Key {
        QString cap;  ///< "F5", as it came
        QString does; ///< "test again"
    };
    KeyStrip(const ThemeSource &theme, const std::vector<Key> &keys, QWidget *parent);
};

} // namespace mb
