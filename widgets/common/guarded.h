// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>

#include <utility>

namespace mb {

/// Work for an answer that may come when this object is gone: then it is not done, so that it may use the object. Where
/// something is left to do without it, a QPointer says so.
template <class Work> [[nodiscard]] auto guarded(QObject *object, Work work)
{
    return [alive = QPointer<QObject>(object), work = std::move(work)](auto &&...answer) {
        if (alive)
            work(std::forward<decltype(answer)>(answer)...);
    };
}

} // namespace mb
