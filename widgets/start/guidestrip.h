// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/iconbutton.h"
#include "widgets/start/guide.h"

#include <QFrame>

#include <functional>

class QLabel;

namespace mb {

class StateGlyph;

/// A story in a strip: offered on a page, or with its steps above the pages while it is played, and what came of it at its end.
/// Hidden otherwise.
class GuideStrip : public QFrame {
    Q_OBJECT
public:
    enum class Shows { Offers, Steps };
    GuideStrip(Shows shows, Guide &guide, const ThemeSource &theme, QWidget *parent = nullptr);

    /// Offers a story while none is played; nullptr takes the offer back.
    void offer(const Story *story);
    /// What a step's key is now; without it, as it came.
    using KeyOf = std::function<QString(const StoryStep &)>;
    void setKeys(KeyOf keyOf);

Q_SIGNALS:
    /// The offer was taken.
    void wanted(const mb::Story &story);
    /// The offer was refused: not again.
    void refused();
    /// Show where the present step is done.
    void placeWanted(mb::StoryPlace place);

protected:
    bool event(QEvent *event) override;

private:
    void build();
    QWidget *buildButtons();
    void setWords(const QString &words);
    void setOrders(const QString &act, const QString &leave);
    void follow();
    void showOffer();
    void showSteps();
    void act();
    void leave();

    Shows m_shows;
    Guide &m_guide;
    const ThemeSource &m_theme;
    const Story *m_offer = nullptr;
    KeyOf m_keyOf;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_title = nullptr;
    QLabel *m_steps = nullptr;
    QLabel *m_words = nullptr;
    CommandButton *m_act = nullptr;
    CommandButton *m_leave = nullptr;
};

} // namespace mb
