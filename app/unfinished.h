// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QWidget>

#include <functional>
#include <vector>

namespace mb {

/// Something that is under way and would be cut, or lost, if its window went. A value of one moment; GUI thread.
struct Unfinished {
    /// In the order in which people are asked. All but a job are cut only when somebody says so. A job writes to a unit, or tries
    /// its loop, and ends by itself in a few seconds.
    enum class Kind { Service, Export, Update, Job };

    Kind kind = Kind::Job;
    QString what;                 ///< the file, the unit, or what the job is called
    bool mayInterrupt = true;     ///< now
    QString left;                 ///< of an update: what a cancel would leave now, a clause
    std::function<void()> cancel; ///< asks it to end, and to put back what it changed; empty: it is not asked
};

/// All of it, questions first. What only looks at a unit is none of it.
[[nodiscard]] std::vector<Unfinished> unfinishedIn(const QWidget &window, Workbench &workbench);

} // namespace mb
