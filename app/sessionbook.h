// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sessionrecord.h"

#include <QLockFile>

#include <memory>
#include <optional>
#include <vector>

namespace mb {

/// Sessions as files of one folder, one a run. A run holds a lock beside its file; a file that nobody locks and that says that it
/// has not ended belongs to a program that crashed. GUI thread.
class SessionBook {
public:
    /// So many are kept.
    static constexpr int most = 12;

    struct Entry {
        QString file;
        SessionRecord record;
    };

    explicit SessionBook(const QString &folder);

    /// Begins the one of this run, `begun` in Unix time.
    [[nodiscard]] Result<void> begin(qint64 begun);
    /// Writes the one of this run, whole or not at all. Any thread, one at a time.
    [[nodiscard]] Result<void> save(const SessionRecord &record) const;
    /// Of earlier runs and of other windows, newest first; those that run are left out.
    [[nodiscard]] std::vector<Entry> earlier() const;
    /// The newest that crashed.
    [[nodiscard]] std::optional<Entry> crashed() const;
    /// It has been dealt with: it counts as ended.
    void settle(const Entry &entry) const;

private:
    void tidy() const;
    [[nodiscard]] static bool isRunning(const QString &file);

    QString m_folder;
    QString m_file;
    std::unique_ptr<QLockFile> m_lock;
};

} // namespace mb
