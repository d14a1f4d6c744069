// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/turningrow.h"

namespace mb {

TurningRow::TurningRow(const ThemeSource &theme, int besideFrom, QWidget *parent)
    : QWidget(parent)
    , m_parts(new TurningBox(theme, besideFrom, this))
{
}

} // namespace mb
