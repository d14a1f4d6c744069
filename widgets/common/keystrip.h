// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

#include <vector>

class QLabel;

namespace mb {

/// A line that names keys as caps, as they are now, and says what each does: "[F5] test again  [F8] set aside"; nothing of those that were
/// taken away. Goes on in the next line where it does not fit. GUI thread.
class KeyStrip : public QWidget {
    Q_OBJECT
public:
    struct Key {
        QString cap;  ///< "F5", as it came
        QString does; ///< "test again"
    };
    KeyStrip(const ThemeSource &theme, const std::vector<Key> &keys, QWidget *parent);

protected:
    bool event(QEvent *event) override;

private:
    struct Pair {
        QString factory;
        QWidget *whole = nullptr;
        QLabel *cap = nullptr;
    };
    void follow();

    std::vector<Pair> m_pairs;
};

} // namespace mb
