// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/iconbutton.h"

class QLabel;
class QHBoxLayout;

namespace mb {

/// What a page says while it has nothing to show: symbol, one bold line, one sentence, what can be done about it.
class EmptyState : public QWidget {
    Q_OBJECT
public:
    EmptyState(
        const ThemeSource &theme, Symbol symbol, const QString &title, const QString &text, QWidget *parent = nullptr);

    void setText(const QString &title, const QString &text);
    /// The first one is primary. The button stays ours; connect to its clicked().
    CommandButton *addAction(Symbol symbol, const QString &text);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void restyle();

    const ThemeSource &m_theme;
    Symbol m_symbol;
    QWidget *m_mark = nullptr;
    QLabel *m_title = nullptr;
    QLabel *m_text = nullptr;
    QHBoxLayout *m_actions = nullptr;
};

} // namespace mb
