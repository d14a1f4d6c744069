// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/keystrip.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/wraplayout.h"

namespace mb {

KeyStrip::KeyStrip(const ThemeSource &theme, const std::vector<Key> &keys, QWidget *parent)
    : QWidget(parent)
{
    auto *line = new WrapLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(theme.theme().u(18));
    for (const Key &key : keys) {
        auto *pair = new QWidget(this);
        auto *row = layoutIn<QHBoxLayout>(pair, theme.theme().u(8));
        QLabel *const cap = badge({}, Tone::Text, pair);
        m_pairs.push_back({key.cap, pair, cap});
        row->addWidget(cap);
        row->addWidget(textLabel(key.does, TextRole::Caption, Tone::Dim, pair));
        line->addWidget(pair);
    }
    follow();
}

bool KeyStrip::event(QEvent *event)
{
    if (event->type() == keysChanged())
        follow();
    return QWidget::event(event);
}

void KeyStrip::follow()
{
    for (const Pair &pair : m_pairs) {
        const QString key = keyShown(*this, pair.factory);
        pair.cap->setText(key);
        pair.whole->setVisible(!key.isEmpty());
    }
}

} // namespace mb
