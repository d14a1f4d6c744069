// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mb {

/// The base of what is neither copied nor moved, because others keep its address or it gives something back when it goes:
/// `class Turn : NonCopyable`.
class NonCopyable {
public:
    NonCopyable(const NonCopyable &) = delete;
    NonCopyable &operator=(const NonCopyable &) = delete;

protected:
    NonCopyable() = default;
    ~NonCopyable() = default;
};

} // namespace mb
