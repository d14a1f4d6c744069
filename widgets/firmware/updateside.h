// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "firmware/updateroute.h"
#include "widgets/common/theme.h"

#include <QScrollArea>

class QFrame;
class QLabel;
class QVBoxLayout;

namespace mb {

class PageMap;
class StepsPanel;

/// Beside an update: whether power may be cut now, the steps of hands or the pages of the flash, and notes. GUI thread.
class UpdateSide : public QScrollArea {
    Q_OBJECT
public:
    /// Turns: nothing is written, but a self-test moves the motor; WaitsToTurn: as soon as somebody arms.
    enum class Safety { Nothing, MayCut, MustNotCut, Turns, WaitsToTurn };

    UpdateSide(const ThemeSource &theme, QWidget *parent);

    /// `place`: which unit it is about; of Nothing, whose writing has ended.
    void showSafety(Safety safety, const QString &place, const UpdateWords &words);
    /// Whether power may be cut comes last in `column`, where little is in sight at once; nullptr: above what is beside.
    void placeSafety(QVBoxLayout *column);
    /// The steps of hands in the place of the pages.
    void setGuided(bool guided) { m_pages->setVisible(!guided); }
    void setNotes(const QString &notes);
    /// Between what hands do and the pages.
    void add(QWidget *part);
    [[nodiscard]] PageMap &map() { return *m_map; }
    [[nodiscard]] StepsPanel &steps() { return *m_steps; }

private:
    [[nodiscard]] QFrame *buildSafety(QWidget *parent);
    [[nodiscard]] QWidget *buildPages(QWidget *parent);

    const ThemeSource &m_theme;
    QFrame *m_safety = nullptr;
    QLabel *m_title = nullptr;
    QLabel *m_text = nullptr;
    QVBoxLayout *m_column = nullptr;
    StepsPanel *m_steps = nullptr;
    QWidget *m_pages = nullptr;
    PageMap *m_map = nullptr;
    QLabel *m_notes = nullptr;
};

} // namespace mb
