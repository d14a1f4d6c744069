// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <QByteArray>
#include <QStringList>

namespace mb {

/// What a run of the program had open, so that it can be opened again.
struct SessionRecord {
    qint64 begun = 0;   ///< Unix time, s
    qint64 changed = 0; ///< the same, of its last change
    bool ended = false; ///< the window was closed; false: it runs, or it crashed
    QStringList links;  ///< addresses
    QStringList units;  ///< "DMC60C #5", of those that were found
    QString selected;   ///< selector of the device that was shown; empty: none
    int axis = 0;
    QString page; ///< name of the page, "tune"
    QByteArray geometry;

    friend bool operator==(const SessionRecord &a, const SessionRecord &b)
    {
        return a.begun == b.begun && a.changed == b.changed && a.ended == b.ended && a.isSameView(b);
    }
    /// Times aside.
    [[nodiscard]] bool isSameView(const SessionRecord &other) const
    {
        return links == other.links && units == other.units && selected == other.selected && axis == other.axis
            && page == other.page && geometry == other.geometry;
    }
    /// There is something to come back to.
    [[nodiscard]] bool isWorthKeeping() const { return !links.isEmpty(); }
    [[nodiscard]] QByteArray toJson() const;
    /// OutOfRange when it is none.
    [[nodiscard]] static Result<SessionRecord> fromJson(const QByteArray &json);
};

} // namespace mb
