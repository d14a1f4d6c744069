// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"

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
    NotKept,     ///< this computer could not write what it keeps: a full disk, a notebook that is held or damaged
    Usage,       ///< the call itself is wrong: an unknown word, option or name, or one that is missing
    Unsupported, ///< this device or link has no such thing
    Cancelled,   ///< the user asked for it
    Unsafe,      ///< not done because a motor could move when it must not
};

/// What is wrong with a link: one cause, the first that explains the others.
enum class Ailment {
    None,
    NoCan,    ///< the kernel has no CAN
    NotThere, ///< no such interface, port or adapter
    Down,     ///< switched off
    NoPermission,
    Busy, ///< somebody else has it, or leaves no room on it
    Gone, ///< was there, and was unplugged
    BusOff,
    ListenOnly,         ///< configured so that nothing can be sent
    WrongBitrate,       ///< only disturbed frames arrive
    NobodyAcknowledges, ///< nobody else is on the bus, or the wire or the termination is missing
    Disturbed,          ///< it works, with many errors
    Losing,             ///< it works, and frames were lost for lack of room
    Failed,             ///< anything else: the cause says what
};

/// A fault, what it was about and what helps, each a part of its own, decided where the fault is known; `widgets/common` and the
/// console make user text from it.
struct Error {
    Fault fault = Fault::BadReply;
    Message detail{};                ///< the cause
    Message remedy{};                ///< what helps; empty where nothing is known that the fault alone does not say
    std::string command{};           ///< for a terminal, as it stands: what does it; empty when none helps
    Ailment ailment = Ailment::None; ///< of a link that cannot be opened or was lost: which

    /// "cause; remedy: command", what there is of it, in English.
    [[nodiscard]] std::string text() const { return message().english(); }
    /// The same to be translated.
    [[nodiscard]] Message message() const;
    /// The remedy with its command.
    [[nodiscard]] Message help() const;
    /// The same of `what`: "slot0.p: cause".
    [[nodiscard]] Error about(const MessageArgument &what) const;

    friend bool operator==(const Error &, const Error &) = default;
};

template <class T> using Result = tl::expected<T, Error>;

/// `return fail(Fault::Timeout, say("%1 does not answer", name));`
[[nodiscard]] inline tl::unexpected<Error> fail(Fault fault, Message cause = {})
{
    return tl::unexpected<Error>(Error{fault, std::move(cause)});
}

/// `return fail(Fault::OutOfRange, say("%1 is a folder", path), say("name a file"));`
[[nodiscard]] inline tl::unexpected<Error> fail(Fault fault, Message cause, Message remedy, std::string command = {})
{
    return tl::unexpected<Error>(Error{fault, std::move(cause), std::move(remedy), std::move(command)});
}

/// `return fail(result.error());` hands an error on.
[[nodiscard]] inline tl::unexpected<Error> fail(Error error)
{
    return tl::unexpected<Error>(std::move(error));
}

[[nodiscard]] std::string_view toString(Fault fault);

} // namespace mb

/// What `co_await` is in a Task, for a plain function that yields a Result: the value, or the end of the function with the
/// same error. A statement of its own in a block: `MB_TRY(const auto index, parseKey(family, key));`
#define MB_TRY(declaration, ...)                                                                                       \
    auto MB_NAME_OF_LINE(tried, __LINE__) = __VA_ARGS__;                                                               \
    if (!MB_NAME_OF_LINE(tried, __LINE__))                                                                             \
        return ::mb::fail(std::move(MB_NAME_OF_LINE(tried, __LINE__)).error());                                        \
    declaration = *std::move(MB_NAME_OF_LINE(tried, __LINE__))

/// The same of a Result<void>, or of a value that nobody wants: `MB_TRY_VOID(check(options));`
#define MB_TRY_VOID(...)                                                                                               \
    if (auto MB_NAME_OF_LINE(tried, __LINE__) = __VA_ARGS__; !MB_NAME_OF_LINE(tried, __LINE__))                        \
    return ::mb::fail(std::move(MB_NAME_OF_LINE(tried, __LINE__)).error())

#define MB_NAME_OF_LINE(name, line) MB_JOINED(name, line)
#define MB_JOINED(name, line) name##line
