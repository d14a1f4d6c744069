// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPalette>

namespace mb {

/// The palette that the desktop has, whatever this program has set since, and word of its change. Made before the first theme is
/// applied. GUI thread.
///
/// Qt tells of other colours in one of two ways: a platform theme sets them over the program's own (Plasma), or it exchanges what
/// lies below them (GTK), which shows in the roles that themePalette() leaves to the desktop. What the program sets itself is told
/// to keep(), and is no news.
class SystemPalette : public QObject {
    Q_OBJECT
public:
    SystemPalette();
    [[nodiscard]] const QPalette &palette() const { return m_palette; }
    /// The palette that the application has now is the program's own.
    void keep();
    /// Nobody has set another one over it.
    [[nodiscard]] bool isOurs() const;

Q_SIGNALS:
    /// The desktop has other colours, or somebody has set theirs over the program's; once for all that changed together.
    void changed();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void look();
    [[nodiscard]] QPalette ask();

    QPalette m_palette;
    QPalette m_ours;
    bool m_asking = false;
    bool m_told = false;      ///< look() is on its way
    bool m_exchanged = false; ///< the platform theme says that it is another one
};

} // namespace mb
