// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/orders/order.h"

#include <functional>
#include <memory>

namespace mb {

/// The answer that is owed to whoever gave an order. It is given exactly once: by the first that gives one, else, when the last
/// copy of this goes without, as Cancelled, "the order was dropped". Copies share what they owe; one thread at a time.
class Reply {
public:
    using Finished = std::function<void(Result<Answer>)>;

    /// Nobody wants to know.
    Reply() = default;
    explicit Reply(Finished finished);

    /// What comes after the first is not told.
    void give(Result<Answer> answer) const;
    /// The same as a function that takes what the order is answered with, or nothing; empty where nobody wants to know.
    template <class T> [[nodiscard]] std::function<void(Result<T>)> as() const;

    /// A function for one kind of answer as one for all of them, and back. Empty stays empty.
    template <class T> [[nodiscard]] static Finished from(std::function<void(Result<T>)> finished);
    template <class T> [[nodiscard]] static std::function<void(Result<T>)> to(Finished finished);

private:
    struct Owed;
    std::shared_ptr<Owed> m_owed;
};

template <class T> std::function<void(Result<T>)> Reply::as() const
{
    if (!m_owed)
        return {};
    return to<T>([reply = *this](Result<Answer> answer) { reply.give(std::move(answer)); });
}

template <class T> std::function<void(Result<T>)> Reply::to(Finished finished)
{
    if (!finished)
        return {};
    return [finished = std::move(finished)](Result<T> result) {
        if (!result)
            finished(fail(std::move(result.error())));
        else if constexpr (std::is_void_v<T>)
            finished(Answer());
        else
            finished(Answer(std::move(*result)));
    };
}

template <class T> Reply::Finished Reply::from(std::function<void(Result<T>)> finished)
{
    if (!finished)
        return {};
    return [finished = std::move(finished)](Result<Answer> answer) {
        if (!answer)
            finished(fail(std::move(answer.error())));
        else if constexpr (std::is_void_v<T>)
            finished({});
        else
            finished(std::get<T>(std::move(*answer)));
    };
}

} // namespace mb
