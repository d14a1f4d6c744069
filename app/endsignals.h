// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"

#include <QSocketNotifier>

#include <functional>

namespace mb {

/// SIGINT, SIGTERM and SIGHUP as events of the GUI thread's loop, in whatever thread they arrive; one that was ignored before, as by
/// nohup, stays so. Programs that this one starts have none of it. One at a time; GUI thread.
class EndSignals : NonCopyable {
public:
    explicit EndSignals(std::function<void()> received);
    /// They act as in a new program again.
    ~EndSignals();

private:
    int m_descriptor = -1;
    QSocketNotifier m_notifier;
};

} // namespace mb
