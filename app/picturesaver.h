// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"

#include <QImage>
#include <QThreadPool>

#include <atomic>
#include <functional>

namespace mb {

/// Makes files of pictures in a thread of its own: to pack one of 8 million pixels takes longer than the lease of a motion, which the
/// thread of the window must renew meanwhile. One after the other. GUI thread.
class PictureSaver : NonCopyable {
public:
    /// In the other thread; false: it could not be written.
    using Write = std::function<bool(const QImage &picture, const QString &path)>;
    explicit PictureSaver(Write write);
    ~PictureSaver();

    /// Returns at once.
    void save(const QImage &picture, const QString &path);
    /// How many are not written yet: each holds its picture in memory.
    [[nodiscard]] int waiting() const { return m_waiting; }
    /// Until all are written; false: one of them could not be.
    bool finish();

private:
    Write m_write;
    QThreadPool m_pool;
    std::atomic<int> m_waiting = 0;
    std::atomic<bool> m_good = true;
};

} // namespace mb
