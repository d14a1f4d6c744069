// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"

#include <QSocketNotifier>

#include <functional>

namespace mb::console {

/// SIGINT, SIGTERM and SIGHUP as events of the loop. They are blocked while this lives, so that none is missed.
class Signals : NonCopyable {
public:
    explicit Signals(std::function<void()> received);
    ~Signals();

private:
    int m_descriptor = -1;
    QSocketNotifier m_notifier;
};

} // namespace mb::console
