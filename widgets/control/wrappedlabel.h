// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/labels.h"

namespace mb {

/// A sentence that takes as many lines as it needs.
[[nodiscard]] inline QLabel *wrappedLabel(const QString &text, TextRole role, Tone tone, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setWordWrap(true);
    setTextRole(*label, role);
    setTone(*label, tone);
    return label;
}

} // namespace mb
