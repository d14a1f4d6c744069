// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/serviceview.h"
#include "widgets/common/stateglyph.h"

#include "model/snapshot.h"

#include <QString>

namespace mb {

/// One unit in the table of a queue, ready to be shown. A value.
struct QueueLine {
    DeviceId device{};     ///< none: it is gone, or not of the family that is asked for
    std::uint32_t row = 0; ///< of the queue; 0: it is not in it
    service::RowState state = service::RowState::Skipped;
    GlyphState glyph = GlyphState::Waiting;
    QString serial;
    QString title;           ///< "DMC60C #5"
    QString name;            ///< "#5 shooter"
    QString link;            ///< its address, where another unit has the same title; else empty
    QString firmware;        ///< "1.23 → 1.25"
    QString step;            ///< what it does now, or came to
    std::optional<int> done; ///< percent; nothing: it does nothing
    QString time;
    QString result;
    Tone tone = Tone::Text; ///< of the result

    friend bool operator==(const QueueLine &, const QueueLine &) = default;
};

/// Units of the queue in its order, also of one that has ended, then those of the family that are not in it. `version`: of the image
/// that these would get, empty without one.
[[nodiscard]] std::vector<QueueLine> queueLines(
    const ServiceView &view, const Snapshot &shot, const Family *family, const std::string &version, Instant now);

/// How a queue stands.
struct QueueTotals {
    int units = 0; ///< that have ended, run or wait
    int ended = 0;
    int running = 0;
    int waiting = 0;
    int failed = 0;
    int refused = 0;
    int passed = 0;
    double share = 0.0;                ///< 0 … 1 of the whole
    std::optional<double> mean;        ///< s, of those that passed
    std::optional<double> secondsLeft; ///< of the bus that takes longest
};
[[nodiscard]] QueueTotals totalsOf(const ServiceView &view, Instant now);

/// "Backup": a step of a service for people.
[[nodiscard]] QString stepText(service::Step step);

} // namespace mb
