// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mb::test {

/// Counts the objects alive, to see that a cancelled coroutine destroyed its locals, once.
struct Witness {
    explicit Witness(int &alive)
        : count(alive)
    {
        ++count;
    }
    Witness(const Witness &) = delete;
    Witness &operator=(const Witness &) = delete;
    ~Witness() { --count; }
    int &count;
};

} // namespace mb::test
