// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parametermodel.h"

#include <QStringList>

#include <optional>

namespace mb {

/// Which rows are shown: a segment, and words that all must occur in label, key, group, unit or help.
struct ParameterFilter {
    enum Segment { All, Changed, Edited, Errors };
    Segment segment = All;
    QString words;
    std::optional<int> axis; ///< only rows of this axis, 0: those of the board as a whole; nothing: all

    /// The row that is being edited is always accepted: it must not vanish under the cursor.
    [[nodiscard]] bool accepts(const ParameterModel &model, ParameterIndex index) const;
};

/// How many parameters stand how; the errors are illegal edits and values without an answer.
struct ParameterCounts {
    int all = 0;
    int changed = 0;
    int edited = 0;
    int illegal = 0;
    int unread = 0;
    int inRam = 0;
    int stored = 0;
    int notKept = 0; ///< what a power cycle takes
    int assumed = 0;
};
/// Of one axis (0: of what the board has once), or of all.
[[nodiscard]] ParameterCounts countParameters(const ParameterModel &model, std::optional<int> axis = {});

} // namespace mb
