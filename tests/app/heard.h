// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <functional>
#include <memory>
#include <optional>

namespace mb::test {

/// The answer to an order: nothing until it is there. Whoever is to answer shares the place of it, so that an answer may come
/// after this is gone: every order is answered, the last ones when the engine ends.
template <class T = void> class Heard {
public:
    /// For the order; also for several.
    [[nodiscard]] std::function<void(Result<T>)> finished() const
    {
        return [place = m_place](Result<T> result) { *place = std::move(result); };
    }
    [[nodiscard]] bool has_value() const { return m_place->has_value(); }
    [[nodiscard]] explicit operator bool() const { return has_value(); }
    [[nodiscard]] Result<T> &operator*() const { return m_place->value(); }
    [[nodiscard]] Result<T> *operator->() const { return &m_place->value(); }
    [[nodiscard]] Result<T> value_or(Result<T> other) const { return m_place->value_or(std::move(other)); }
    /// What was asked until now is not heard any more.
    void reset() { m_place = std::make_shared<std::optional<Result<T>>>(); }

private:
    std::shared_ptr<std::optional<Result<T>>> m_place = std::make_shared<std::optional<Result<T>>>();
};

} // namespace mb::test
