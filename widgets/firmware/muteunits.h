// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <functional>
#include <span>

class QMenu;
class QWidget;

namespace mb {

/// A line for each open link and family on it whose firmware takes another way in (Family::routes). It asks for the number of a unit
/// that does not answer there, above `parent`; `found` gets that one once it is in the list, where it can be updated. Why it cannot is
/// reported.
void addMuteUnits(QMenu &menu, Workbench &workbench, std::span<const Family *const> families, QWidget &parent,
    const std::function<void(DeviceId)> &found);

} // namespace mb
