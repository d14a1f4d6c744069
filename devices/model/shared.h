// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>

namespace mb {

/// A value that is read in several threads and changed by nobody: copies are the same object, a change makes a new one. It
/// always has a value; one that was moved from has that of `T()`.
template <typename T> class Shared {
public:
    Shared()
        : m_value(initial())
    {
    }
    Shared(T value)
        : m_value(std::make_shared<const T>(std::move(value)))
    {
    }
    Shared(const Shared &) = default;
    Shared(Shared &&other) noexcept
        : m_value(std::exchange(other.m_value, initial()))
    {
    }
    Shared &operator=(Shared other) noexcept
    {
        m_value.swap(other.m_value);
        return *this;
    }
    ~Shared() = default;

    [[nodiscard]] const T &operator*() const { return *m_value; }
    [[nodiscard]] const T *operator->() const { return m_value.get(); }
    operator const T &() const { return *m_value; }

    /// Whether both are one object, and so equal without a look at it.
    [[nodiscard]] bool isSameAs(const Shared &other) const { return m_value == other.m_value; }

    /// Makes this one, and no other copy, a new value that is changed before anybody copies it.
    [[nodiscard]] T &edit()
    {
        auto changed = std::make_shared<T>(*m_value);
        T &value = *changed;
        m_value = std::move(changed);
        return value;
    }

private:
    static const std::shared_ptr<const T> &initial()
    {
        static const auto value = std::make_shared<const T>();
        return value;
    }

    std::shared_ptr<const T> m_value;
};

/// A value that one thread changes where it lies, and shows to others: shared() is the same object until the next edit().
template <typename T> class Published {
public:
    explicit Published(T value = T())
        : m_value(std::move(value))
    {
    }

    [[nodiscard]] const T &operator*() const { return m_value; }
    [[nodiscard]] const T *operator->() const { return &m_value; }
    [[nodiscard]] T &edit()
    {
        m_shown.reset();
        return m_value;
    }
    [[nodiscard]] const Shared<T> &shared() const
    {
        if (!m_shown)
            m_shown.emplace(m_value);
        return *m_shown;
    }

private:
    T m_value;
    mutable std::optional<Shared<T>> m_shown;
};

} // namespace mb
