// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <tl/expected.hpp>

namespace mb {

/// Everything that can go wrong between a request and its answer. Closed: a new way to fail is mapped to one of these.
enum class Fault {
    Timeout,     ///< no answer within the time the protocol allows
    Refused,     ///< the device answered with an error
    BadReply,    ///< an answer that the protocol does not allow
    BadCheck,    ///< a check value or a read-back differs
    LinkLost,    ///< the link cannot be opened, or went away
    OutOfRange,  ///< a value outside its legal range, a file or argument that does not parse
    Usage,       ///< the call itself is wrong: an unknown word, option or name, or one that is missing
    Unsupported, ///< this device or link has no such thing
    Cancelled,   ///< the user asked for it
    Unsafe,      ///< not done because a motor could move when it must not
};

/// A fault, what it was about and what helps, in plain English without trailing full stop; `widgets/common` and the console
/// make user text from it.
struct Error {
    Fault fault = Fault::BadReply;
    std::string detail;   ///< the cause
    std::string remedy{}; ///< what helps; empty where nothing is known that the fault alone does not say

    /// A phrase of both in one piece, as tables and translators have it: "the port is busy; close the other program".
    [[nodiscard]] static Error fromPhrase(Fault fault, std::string_view phrase);
    /// "cause; remedy", or the cause alone.
    [[nodiscard]] std::string text() const;
    /// The same of `what`: "slot0.p: cause".
    [[nodiscard]] Error about(std::string_view what) const;

    friend bool operator==(const Error &, const Error &) = default;
};

template <class T> using Result = tl::expected<T, Error>;

/// `return fail(Fault::Timeout, "slot0.p");`
[[nodiscard]] inline tl::unexpected<Error> fail(Fault fault, std::string detail = {})
{
    return tl::unexpected<Error>(Error{fault, std::move(detail)});
}

/// `return fail(Fault::OutOfRange, path + " is a folder", "name a file");`
[[nodiscard]] inline tl::unexpected<Error> fail(Fault fault, std::string detail, std::string remedy)
{
    return tl::unexpected<Error>(Error{fault, std::move(detail), std::move(remedy)});
}

/// `return fail(result.error());` hands an error on.
[[nodiscard]] inline tl::unexpected<Error> fail(Error error)
{
    return tl::unexpected<Error>(std::move(error));
}

[[nodiscard]] std::string_view toString(Fault fault);

} // namespace mb
