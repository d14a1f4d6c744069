// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

namespace mb {

class CommandButton;
class JogKeys;

/// Two buttons that move the armed motor gently: a click nudges it for a tenth of a second, held they go on until they are
/// let go. The same as the keys J and K, and through them.
class JogPanel : public QWidget {
    Q_OBJECT
public:
    JogPanel(JogKeys &jog, const ThemeSource &theme, QWidget *parent = nullptr);
    /// Nothing to move: the buttons say why.
    void setPossible(bool possible, const QString &reason);

private:
    CommandButton *button(bool forwards, const QString &text, const QString &key);

    JogKeys &m_jog;
    const ThemeSource &m_theme;
    CommandButton *m_backwards = nullptr;
    CommandButton *m_forwards = nullptr;
};

} // namespace mb
