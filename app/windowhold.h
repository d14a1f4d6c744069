// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mb {

class MainWindow;
class Workbench;

/// Somebody would lose something if another window took its place: it is armed, about to close, or something is unfinished in it; another
/// window of it is open, but the help; or a mouse button is down. GUI thread.
[[nodiscard]] bool isHeld(MainWindow &window, Workbench &workbench);

} // namespace mb
