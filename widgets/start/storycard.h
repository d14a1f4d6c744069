// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/card.h"
#include "widgets/start/story.h"

namespace mb {

class CommandButton;

/// A story on the start page: its drawing, its motor, what is wrong with it, and the button that begins it.
class StoryCard : public Card {
    Q_OBJECT
public:
    StoryCard(const Story &story, const ThemeSource &theme, QWidget *parent = nullptr);

    void setPrimary(bool primary);

Q_SIGNALS:
    void wanted(const mb::Story &story);

private:
    void buildHead(const Story &story, const ThemeSource &theme);

    CommandButton *m_try = nullptr;
};

} // namespace mb
