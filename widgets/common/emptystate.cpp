// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/emptystate.h"

#include "widgets/common/labels.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

namespace mb {

EmptyState::EmptyState(
    const ThemeSource &theme, Symbol symbol, const QString &title, const QString &text, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_symbol(symbol)
{
    auto *column = new QVBoxLayout(this);
    m_mark = new QWidget(this);
    m_title = textLabel({}, TextRole::Title, Tone::Text, this);
    m_text = textLabel({}, TextRole::Body, Tone::Dim, this);
    m_text->setWordWrap(true);
    for (QLabel *label : {m_title, m_text})
        label->setAlignment(Qt::AlignCenter);
    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    m_actions = new QHBoxLayout;
    buttons->addLayout(m_actions);
    buttons->addStretch(1);
    column->addStretch(2);
    column->addWidget(m_mark, 0, Qt::AlignHCenter);
    column->addWidget(m_title);
    auto *line = new QHBoxLayout; // an alignment would be given the height of the whole width, and cut the second line
    line->addStretch(1);
    line->addWidget(m_text, 100);
    line->addStretch(1);
    column->addLayout(line);
    column->addLayout(buttons);
    column->addStretch(3);
    connect(&theme, &ThemeSource::changed, this, &EmptyState::restyle);
    setText(title, text);
    restyle();
}

void EmptyState::setText(const QString &title, const QString &text)
{
    m_title->setText(title);
    m_text->setText(text);
    m_text->setVisible(!text.isEmpty());
    setAccessibleName(title);
    setAccessibleDescription(text);
}

CommandButton *EmptyState::addAction(Symbol symbol, const QString &text)
{
    auto *button = new CommandButton(m_theme, symbol, text, this);
    button->setPrimary(m_actions->count() == 0);
    m_actions->addWidget(button);
    return button;
}

void EmptyState::restyle()
{
    const Theme &theme = m_theme.theme();
    m_mark->setFixedSize(theme.u(44), theme.u(44));
    m_text->setMinimumWidth(theme.u(140)); // the list of devices may be this narrow
    m_text->setMaximumWidth(theme.u(400));
    layout()->setContentsMargins(theme.u(24), theme.u(24), theme.u(24), theme.u(24));
    layout()->setSpacing(theme.u(8));
    m_actions->setSpacing(theme.u(8));
    m_actions->setContentsMargins(0, theme.u(8), 0, 0);
}

void EmptyState::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    paintSymbol(painter, m_mark->geometry(), m_symbol, m_theme.theme().faint);
}

} // namespace mb
