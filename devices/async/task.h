// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/result.h"

#include <coroutine>
#include <exception>
#include <functional>
#include <optional>
#include <utility>

namespace mb {

/// A lazy coroutine that owns its frame. `co_await std::move(task)` yields the value, or ends the caller with the same
/// error; `co_await std::move(task).attempt()` yields the Result. `co_await` takes a Result likewise, without ever waiting.
/// Destroying a Task cancels it, wherever it is suspended.
///
/// A coroutine ends with `co_return value;`, `co_return fail(Fault::…);`, or, for Task<void>, `co_return {};`.
/// Rules that keep this safe (what may stand in an operand, no capturing lambdas): docs/architecture.md#asynchrony.
template <class T> class Task;

namespace detail {

class AnyPromise : NonCopyable {
public:
    struct Final {
        AnyPromise &self;
        bool await_ready() noexcept { return false; }
        void await_suspend(std::coroutine_handle<>) noexcept { self.finish(); }
        void await_resume() noexcept { }
    };

    std::suspend_always initial_suspend() noexcept { return {}; }
    Final final_suspend() noexcept { return Final{*this}; }
    void unhandled_exception() noexcept { std::terminate(); }

    virtual void failWith(const Error &error) noexcept = 0;
    [[nodiscard]] virtual const Error *error() const noexcept = 0;

    void finish() noexcept
    {
        finished = true;
        if (parentSuspended)
            resumeParent();
        else if (onFinished)
            std::exchange(onFinished, nullptr)();
    }
    void resumeParent() noexcept
    {
        if (const Error *failure = error(); failure && propagates)
            parent->failWith(*failure);
        else
            std::coroutine_handle<>(continuation).resume();
    }

    AnyPromise *parent = nullptr;
    std::coroutine_handle<> continuation;
    std::function<void()> onFinished;
    bool propagates = false;
    bool parentSuspended = false;
    bool finished = false;

protected:
    ~AnyPromise() = default;
};

template <class T> class Promise final : public AnyPromise {
public:
    Task<T> get_return_object() noexcept;
    void return_value(Result<T> value) { result.emplace(std::move(value)); }
    void failWith(const Error &error) noexcept override
    {
        result.emplace(fail(error));
        finish();
    }
    [[nodiscard]] const Error *error() const noexcept override { return *result ? nullptr : &result->error(); }

    std::optional<Result<T>> result;
};

template <class T, bool Propagates> struct TaskAwaiter {
    std::coroutine_handle<Promise<T>> &child;

    bool await_ready() noexcept { return false; }
    template <class P> bool await_suspend(std::coroutine_handle<P> parent) noexcept
    {
        Promise<T> &promise = child.promise();
        promise.parent = &parent.promise();
        promise.continuation = parent;
        promise.propagates = Propagates;
        child.resume();
        if (!promise.finished)
            return promise.parentSuspended = true;
        if (!Propagates || *promise.result)
            return false; // it finished inline: the caller carries on without suspending
        promise.resumeParent();
        return true;
    }
    auto await_resume()
    {
        Result<T> result = std::move(*child.promise().result);
        std::exchange(child, {}).destroy(); // the child's locals die before the caller carries on
        if constexpr (!Propagates)
            return result;
        else if constexpr (!std::is_void_v<T>)
            return T(std::move(*result));
    }
};

template <class T> struct ResultAwaiter {
    Result<T> result;

    [[nodiscard]] bool await_ready() const noexcept { return result.has_value(); }
    template <class P> void await_suspend(std::coroutine_handle<P> caller) noexcept
    {
        const Error error = result.error(); // whoever hears of it may destroy the caller, and this with it
        caller.promise().failWith(error);
    }
    T await_resume()
    {
        if constexpr (!std::is_void_v<T>)
            return std::move(*result);
    }
};

} // namespace detail

/// In a Task: yields the value, or ends the caller with the same error, as a failed Task does. What the caller holds is then
/// destroyed with its frame, before whoever awaits it carries on.
template <class T> detail::ResultAwaiter<T> operator co_await(Result<T> &&result)
{
    return {std::move(result)};
}

template <class T> class [[nodiscard]] Task {
public:
    using promise_type = detail::Promise<T>;
    using value_type = T;

    Task() noexcept = default;
    explicit Task(std::coroutine_handle<promise_type> handle) noexcept
        : m_handle(handle)
    {
    }
    Task(Task &&other) noexcept
        : m_handle(std::exchange(other.m_handle, {}))
    {
    }
    Task &operator=(Task &&other) noexcept
    {
        if (this != &other) {
            cancel();
            m_handle = std::exchange(other.m_handle, {});
        }
        return *this;
    }
    ~Task() { cancel(); }

    /// Runs to the first suspension. `finished` is called once, possibly before this returns; it must not destroy the
    /// task (Operation and Scope post that).
    void start(std::function<void()> finished = {})
    {
        m_handle.promise().onFinished = std::move(finished);
        m_handle.resume();
    }
    [[nodiscard]] bool isValid() const { return static_cast<bool>(m_handle); }
    [[nodiscard]] bool isFinished() const { return m_handle && m_handle.promise().finished; }
    /// Only when finished.
    [[nodiscard]] Result<T> &result() { return *m_handle.promise().result; }
    void cancel()
    {
        if (auto handle = std::exchange(m_handle, {}))
            handle.destroy();
    }

    auto operator co_await() &&noexcept { return detail::TaskAwaiter<T, true>{m_handle}; }
    struct Attempt {
        std::coroutine_handle<promise_type> &handle;
        auto operator co_await() &&noexcept { return detail::TaskAwaiter<T, false>{handle}; }
    };
    [[nodiscard]] Attempt attempt() &&noexcept { return Attempt{m_handle}; }

private:
    std::coroutine_handle<promise_type> m_handle;
};

template <class T> Task<T> detail::Promise<T>::get_return_object() noexcept
{
    return Task<T>{std::coroutine_handle<Promise>::from_promise(*this)};
}

} // namespace mb
