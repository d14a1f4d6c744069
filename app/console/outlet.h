// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"

#include <cstddef>
#include <string_view>

namespace mb::console {

/// Standard output or standard error, written to without ever waiting for who reads it. The descriptor itself is left as it
/// is: other processes share it, and would not expect that it stops blocking.
class Outlet : NonCopyable {
public:
    explicit Outlet(int shared);
    ~Outlet();

    struct Written {
        std::size_t bytes = 0; ///< fewer than asked for: the reader has to go on first
        int error = 0;         ///< of the system; 0 while it can go on
    };
    [[nodiscard]] Written write(std::string_view text) const;
    /// Becomes writable when the reader goes on.
    [[nodiscard]] int descriptor() const { return m_own >= 0 ? m_own : m_shared; }

private:
    [[nodiscard]] long writeOnce(std::string_view text) const;

    enum class Kind { Plain, Own, Socket, Careful };
    int m_shared;
    int m_own = -1;
    Kind m_kind = Kind::Plain;
};

} // namespace mb::console
