// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

namespace mb {

/// One line under that of the device, of one height: which of its limits hold (by name, with the glyph of a caution), and the
/// levels of its pins. Hidden for families that tell neither.
class LiveStateBar : public QWidget {
    Q_OBJECT
public:
    LiveStateBar(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent = nullptr);
    enum class Wanted { Never, IfSomethingHolds, Always };
    /// On this page, where the device tells something. IfSomethingHolds: a limit, or a move that waits in the device, or one of them did
    /// since the device was chosen: a current that is limited now and then does not move the page.
    void setWanted(Wanted wanted);
    /// What is said of its limits.
    [[nodiscard]] const QString &words() const { return m_words; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] bool isWantedFor(const DeviceView &device) const;
    void follow();

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    Wanted m_wanted = Wanted::Never;
    DeviceId m_held; ///< something held there
    LiveStates m_shown;
    DeviceId m_device;
    int m_axis = 0;
    QString m_words; ///< of its limits
};

} // namespace mb
