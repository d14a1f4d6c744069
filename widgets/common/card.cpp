// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/card.h"

#include "widgets/common/spoken.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QVBoxLayout>

namespace mb {

Card::Card(const ThemeSource &theme, QWidget *parent)
    : QFrame(parent)
    , m_theme(theme)
{
    setProperty("card", true);
    m_column = new QVBoxLayout(this);
    m_column->setSpacing(0);
    m_body = new QVBoxLayout;
    m_column->addLayout(m_body, 1);
    connect(&theme, &ThemeSource::changed, this, &Card::restyle);
    restyle();
}

Card::Card(const ThemeSource &theme, const QString &title, QWidget *parent)
    : Card(theme, parent)
{
    setTitle(title);
}

void Card::ensureHead()
{
    if (m_head)
        return;
    m_head = new QHBoxLayout;
    m_glyph = new StateGlyph(m_theme, GlyphState::Online, this);
    m_glyph->hide();
    m_title = textLabel({}, TextRole::Emphasis, Tone::Text, this);
    m_title->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    m_subtitle = textLabel({}, TextRole::Body, Tone::Dim, this);
    m_head->addWidget(m_glyph);
    m_head->addWidget(m_title);
    m_head->addWidget(m_subtitle, 1);
    m_column->insertLayout(0, m_head);
    restyle();
}

void Card::setTitle(const QString &title, const QString &subtitle)
{
    ensureHead();
    m_title->setText(title);
    m_subtitle->setText(subtitle);
    m_subtitle->setMinimumWidth(subtitle.isEmpty() ? 1 : 0); // 0: what it needs
    setSpoken(*this, subtitle.isEmpty() ? title : title + QLatin1Char(' ') + subtitle, accessibleDescription());
}

void Card::setGlyph(std::optional<GlyphState> state)
{
    ensureHead();
    m_glyph->setVisible(state.has_value());
    if (state)
        m_glyph->setState(*state);
}

void Card::addHeadWidget(QWidget *widget)
{
    ensureHead();
    m_head->addWidget(widget);
}

void Card::addHeadMark(QWidget *widget)
{
    ensureHead();
    m_head->insertWidget(0, widget);
}

void Card::setDense(bool dense)
{
    m_dense = dense;
    restyle();
}

void Card::setTight(bool tight)
{
    if (tight == m_tight)
        return;
    m_tight = tight;
    restyle();
}

void Card::setFlush(bool flush)
{
    m_flush = flush;
    restyle();
}

QHBoxLayout &Card::foot()
{
    if (!m_foot) {
        m_foot = new QHBoxLayout;
        m_column->addWidget(separatorLine(Qt::Horizontal, this));
        m_column->addLayout(m_foot);
        restyle();
    }
    return *m_foot;
}

void Card::setEdge(std::optional<Tone> edge)
{
    QString word;
    if (edge)
        word = *edge == Tone::Danger ? QStringLiteral("danger")
            : *edge == Tone::Caution ? QStringLiteral("caution")
                                     : QStringLiteral("selected");
    setStyleProperty(*this, "edge", word);
}

void Card::setActivatable(bool activatable)
{
    m_activatable = activatable;
    setFocusPolicy(activatable ? Qt::TabFocus : Qt::NoFocus);
}

void Card::restyle()
{
    const Theme &theme = m_theme.theme();
    const int pad = theme.u(m_dense ? 10 : 12);
    const int air = theme.u(m_tight ? 3 : m_dense ? 6 : 10);
    m_column->setContentsMargins(1, 1, 1, 1);
    if (m_head) {
        m_head->setContentsMargins(pad, air, pad, m_flush ? air : 0);
        m_head->setSpacing(theme.u(8));
    }
    const int above = theme.u(m_tight ? 1 : m_dense ? 3 : m_head ? 8 : 12);
    m_body->setContentsMargins(m_flush ? QMargins() : QMargins(pad, above, pad, m_dense ? air : pad));
    m_body->setSpacing(theme.u(m_flush ? 0 : m_tight ? 1 : m_dense ? 3 : 8));
    if (m_foot) {
        m_foot->setContentsMargins(pad, theme.u(6), pad, theme.u(6));
        m_foot->setSpacing(theme.u(12));
    }
}

void Card::mouseReleaseEvent(QMouseEvent *event)
{
    if (m_activatable && event->button() == Qt::LeftButton && rect().contains(event->pos()))
        Q_EMIT activated();
    QFrame::mouseReleaseEvent(event);
}

void Card::keyPressEvent(QKeyEvent *event)
{
    // Space is STOP, so only Enter opens a card.
    if (m_activatable && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter))
        Q_EMIT activated();
    else
        QFrame::keyPressEvent(event);
}

} // namespace mb
