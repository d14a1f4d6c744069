// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/turningbox.h"

#include <QWidget>

namespace mb {

/// A widget whose parts stand in a TurningBox; like TurningSplitter, with nothing to drag between them.
class TurningRow : public QWidget {
    Q_OBJECT
public:
    /// `besideFrom`: units of the theme; narrower than this it turns.
    TurningRow(const ThemeSource &theme, int besideFrom, QWidget *parent);
    [[nodiscard]] QBoxLayout &parts() const { return *m_parts; }
    [[nodiscard]] bool isTurned() const { return m_parts->isTurned(); }

Q_SIGNALS:
    /// It has another size, and may lie the other way.
    void arranged(bool turned);

protected:
    void resizeEvent(QResizeEvent *) override { Q_EMIT arranged(isTurned()); }

private:
    TurningBox *m_parts;
};

} // namespace mb
