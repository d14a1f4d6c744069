// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "widgets/common/stateglyph.h"

#include <QString>

namespace mb {

/// One thing that can be handed out or looked up: a card of a unit, a tuning, a trial, or what was once done to a unit. A value.
struct ReportEntry {
    enum class Kind { Card, Tuning, Trial, Visit };
    Kind kind = Kind::Card;
    ReportUnit unit;   ///< who it is, as far as it is known
    ReportWish wish;   ///< what else is to be told
    double time = 0.0; ///< Unix, s; 0: as it is now
    QString title;
    QString about;
    QString words;        ///< besides these, for the search
    service::Visit visit; ///< of Visit
    std::optional<GlyphState> glyph;

    /// Two lines: what it is, and when.
    [[nodiscard]] QString text() const;
    [[nodiscard]] bool contains(const QString &search) const;
    /// The same thing, though it may be known better since, or its unit have another number.
    [[nodiscard]] bool isSameAs(const ReportEntry &other) const;
};

/// As the journal has it. `family`: of the unit; nullptr: this program does not know it.
[[nodiscard]] ReportEntry entryOf(const service::Visit &visit, const Family *family);

} // namespace mb
