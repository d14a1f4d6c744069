// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/design/designbook.h"

#include <QWidget>

namespace mb {

class CommandButton;
class Segmented;

/// The row of orders of the Design page: which loop, which slot, Identify and Autotune; and the button that proves, which stands elsewhere. Decides nothing. GUI thread.
class DesignOrders : public QWidget {
    Q_OBJECT
public:
    DesignOrders(const ThemeSource &theme, QWidget *parent);

    /// Shows what is chosen for the motor in question; `mayRun`: its motor may be pushed, `mayProve`: there is something to write.
    void follow(const DesignBook &book, const Family &family, bool mayRun, bool mayProve);

    /// In one line: without the keys behind the names, and the two choices as lists where that is not enough.
    void setCompact(bool compact);
    /// Write and prove, to be put where what it does is told.
    [[nodiscard]] QWidget *proveButton() const;

Q_SIGNALS:
    void loopChosen(mb::Mode loop);
    void slotChosen(int slot);
    void identifyRequested();
    void autotuneRequested();
    void proveRequested();

protected:
    void resizeEvent(QResizeEvent *) override { fold(); }
    bool event(QEvent *event) override;

private:
    void fold();

    Segmented *m_loops = nullptr;
    Segmented *m_slots = nullptr;
    CommandButton *m_identify = nullptr;
    CommandButton *m_autotune = nullptr;
    CommandButton *m_prove = nullptr;
    bool m_compact = false;
};

} // namespace mb
