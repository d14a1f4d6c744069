// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGridLayout>
#include <QHBoxLayout>
#include <QMargins>
#include <QVBoxLayout>

namespace mb {

/// A layout of this widget with no margins but those that are given, in pixels; `spacing` between its parts, -1: what the style has.
template <class Layout> [[nodiscard]] Layout *layoutIn(QWidget *parent, int spacing = -1, const QMargins &margins = {})
{
    auto *layout = new Layout(parent);
    layout->setContentsMargins(margins);
    if (spacing >= 0)
        layout->setSpacing(spacing);
    return layout;
}

} // namespace mb
