// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/jogpanel.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/control/jogkeys.h"

namespace mb {

JogPanel::JogPanel(JogKeys &jog, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_jog(jog)
    , m_theme(theme)
{
    auto *row = layoutIn<QHBoxLayout>(this, theme.theme().u(8));
    m_backwards = button(false, tr("Nudge −"), QStringLiteral("K"));
    m_forwards = button(true, tr("Nudge +"), QStringLiteral("J"));
    m_backwards->setAccessibleName(tr("Nudge backwards"));
    m_forwards->setAccessibleName(tr("Nudge forwards"));
    row->addWidget(m_backwards);
    row->addWidget(m_forwards);
    setPossible(false, {});
}

CommandButton *JogPanel::button(bool forwards, const QString &text, const QString &key)
{
    auto *made = new CommandButton(m_theme, text, this);
    made->setKeyHint(key);
    made->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(made, &QPushButton::pressed, this, [this, forwards] { m_jog.hold(forwards); });
    connect(made, &QPushButton::released, this, [this] { m_jog.letGo(); });
    return made;
}

void JogPanel::setPossible(bool possible, const QString &reason)
{
    for (CommandButton *button : {m_backwards, m_forwards}) {
        button->setEnabled(possible || button->isDown()); // what is held down must hear that it is let go
        button->setToolTip(
            possible ? tr("A click moves it for a tenth of a second; held, it goes on until it is let go.") : reason);
    }
}

} // namespace mb
