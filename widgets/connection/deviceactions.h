// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <functional>

class QMenu;
class QWidget;

namespace mb {

/// What can be done to one device from a menu: identify, rename, give another number, clear faults, copy its selector.
/// `menu` runs before `parent` goes.
void addDeviceActions(QMenu &menu, Workbench &workbench, DeviceId device, QWidget &parent);

/// Ask for the new value first. Nothing is sent when the user thinks better of it.
void askRename(Workbench &workbench, DeviceId device, QWidget &parent);
void askRenumber(Workbench &workbench, DeviceId device, QWidget &parent);
/// Opens a link; `opened` gets the address once it is open, so that it can be remembered. What is wrong with it is reported.
void openAddress(Workbench &workbench, const QString &text, const std::function<void(const QString &)> &opened);
/// Opens a candump or Vector ASC log as a link; `opened` gets its address once it is open. What is wrong with the file is reported once, by the engine.
void openRecording(Workbench &workbench, const QString &path, const std::function<void(const QString &)> &opened);

} // namespace mb
