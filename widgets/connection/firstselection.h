// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "widgets/common/selection.h"

namespace mb {

/// Whether a loop of it can be tuned now: it runs its application, may be driven, and its gains can be
/// read, so that they can be put back.
[[nodiscard]] bool canBeTuned(const DeviceView &device);

/// Offers a device to the selection: the first that can be tuned, in the order of the list; until there is one, the
/// first of all. What somebody has selected, or works with, stays (Selection::offer).
class FirstSelection {
public:
    explicit FirstSelection(Selection &selection)
        : m_selection(selection)
    {
    }

    void follow(const Snapshot &shot);

private:
    Selection &m_selection;
    DeviceId m_chosen; ///< by this class, and not good enough yet
};

} // namespace mb
