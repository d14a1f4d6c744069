// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <utility>

namespace mb {

/// Keeps a listener registered; destroying or resetting it ends the registration. It may outlive the list.
class [[nodiscard]] Subscription {
public:
    Subscription() = default;
    explicit Subscription(std::function<void()> cancel)
        : m_cancel(std::move(cancel))
    {
    }
    Subscription(Subscription &&other) noexcept
        : m_cancel(std::exchange(other.m_cancel, nullptr))
    {
    }
    Subscription &operator=(Subscription &&other) noexcept
    {
        if (this != &other) {
            reset();
            m_cancel = std::exchange(other.m_cancel, nullptr);
        }
        return *this;
    }
    ~Subscription() { reset(); }
    void reset()
    {
        if (auto cancel = std::exchange(m_cancel, nullptr))
            cancel();
    }
    [[nodiscard]] bool isActive() const { return static_cast<bool>(m_cancel); }

private:
    std::function<void()> m_cancel;
};

/// A list of callbacks. Single-threaded. Listeners may come and go while a notification runs: those added are not called
/// by it, those removed are not called any more. Notifying does not allocate.
template <class... Args> class Listeners {
public:
    using Callback = std::function<void(Args...)>;

    Listeners()
        : m_state(std::make_shared<State>())
    {
    }
    Listeners(const Listeners &) = delete;
    Listeners &operator=(const Listeners &) = delete;

    Subscription add(Callback callback)
    {
        auto &entries = m_state->entries;
        const auto entry = entries.insert(entries.end(), Entry{std::move(callback), true});
        ++m_state->alive;
        return Subscription([weak = std::weak_ptr<State>(m_state), entry] {
            if (const auto state = weak.lock())
                state->remove(entry);
        });
    }

    void notify(Args... args) const
    {
        const auto state = m_state; // a callback may destroy the owner of this list
        if (state->entries.empty())
            return;
        ++state->depth;
        const auto last = std::prev(state->entries.end());
        for (auto entry = state->entries.begin();; ++entry) {
            if (entry->alive)
                entry->callback(args...);
            if (entry == last)
                break;
        }
        if (--state->depth == 0 && state->stale)
            state->sweep();
    }

    [[nodiscard]] std::size_t size() const { return m_state->alive; }

private:
    struct Entry {
        Callback callback;
        bool alive = true;
    };
    struct State {
        std::list<Entry> entries;
        std::size_t alive = 0;
        int depth = 0;
        bool stale = false;

        void remove(typename std::list<Entry>::iterator entry)
        {
            --alive;
            entry->alive = false;
            if (depth == 0)
                entries.erase(entry);
            else
                stale = true;
        }
        void sweep()
        {
            stale = false;
            entries.remove_if([](const Entry &entry) { return !entry.alive; });
        }
    };

    std::shared_ptr<State> m_state;
};

} // namespace mb
