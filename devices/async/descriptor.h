// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"

#include <unistd.h>

#include <utility>

namespace mb {

/// A descriptor of the system that is closed with its owner; -1 is none.
class Descriptor : NonCopyable {
public:
    explicit Descriptor(int descriptor)
        : m_descriptor(descriptor)
    {
    }
    ~Descriptor()
    {
        if (m_descriptor >= 0)
            ::close(m_descriptor);
    }
    [[nodiscard]] int get() const { return m_descriptor; }
    /// From now on it is the caller's to close.
    [[nodiscard]] int give() { return std::exchange(m_descriptor, -1); }

private:
    int m_descriptor;
};

} // namespace mb
