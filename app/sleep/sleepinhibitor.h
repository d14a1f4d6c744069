// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/listeners.h"
#include "async/message.h"
#include "async/noncopyable.h"

namespace mb {

/// Can keep the computer from being suspended. One thread.
class SleepInhibitor : NonCopyable {
public:
    virtual ~SleepInhibitor() = default;

    /// From now on, or no longer. Never waits.
    virtual void keepAwake(bool awake) = 0;
    /// It cannot: one line for people with cause and remedy, once.
    [[nodiscard]] Listeners<const Message &> &troubled() { return m_troubled; }

private:
    Listeners<const Message &> m_troubled;
};

} // namespace mb
