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
    Unsupported, ///< this device or link has no such thing
    Cancelled,   ///< the user asked for it
    Unsafe,      ///< not done because a motor could move when it must not
};

/// A fault and what it was about, in plain English without trailing full stop; `widgets/common` and the console make
/// user text from it.
struct Error {
    Fault fault = Fault::BadReply;
    std::string detail;

    friend bool operator==(const Error &, const Error &) = default;
};

template <class T> using Result = tl::expected<T, Error>;

/// `return fail(Fault::Timeout, "slot0.p");`
[[nodiscard]] inline tl::unexpected<Error> fail(Fault fault, std::string detail = {})
{
    return tl::unexpected<Error>(Error{fault, std::move(detail)});
}

/// `return fail(result.error());` hands an error on.
[[nodiscard]] inline tl::unexpected<Error> fail(Error error)
{
    return tl::unexpected<Error>(std::move(error));
}

[[nodiscard]] std::string_view toString(Fault fault);

} // namespace mb
