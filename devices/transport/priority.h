// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mb {

enum class Priority {
    Normal,
    /// For stops: goes before everything that still waits in this program, and takes the place of what could start the
    /// motor again: CanLink and SerialLink say of what.
    Urgent,
};

} // namespace mb
