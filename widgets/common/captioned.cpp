// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/captioned.h"

#include "widgets/common/labels.h"

#include <QHBoxLayout>

namespace mb {

QLabel *addCaptioned(
    const ThemeSource &theme, const QString &caption, TextRole role, QHBoxLayout &row, int stretch, QWidget *parent)
{
    auto *box = new QVBoxLayout;
    box->setSpacing(0);
    box->addWidget(textLabel(caption, TextRole::Caption, Tone::Dim, parent));
    auto *value = new ElidedLabel({}, parent);
    value->setAccessibleName(caption);
    value->setMinimumWidth(theme.theme().u(60));
    setTextRole(*value, role);
    box->addWidget(value);
    row.addLayout(box, stretch);
    return value;
}

} // namespace mb
