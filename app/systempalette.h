// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPalette>

namespace mb {

/// The palette that the desktop has, whatever this program has set since, and word of its change. Made before the first theme is
/// applied. GUI thread.
class SystemPalette : public QObject {
    Q_OBJECT
public:
    SystemPalette();
    [[nodiscard]] const QPalette &palette() const { return m_palette; }

Q_SIGNALS:
    void changed();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] static QPalette ask();

    QPalette m_palette;
};

} // namespace mb
