// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string> // first: moc does not understand <concepts> without it

#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// Marks a label of a table for scripts/translate; Message::label() looks it up.
#define MB_LABEL(english) english

namespace mb {

struct MessageArgument;

/// A sentence or clause for people as data: an English literal with places %1 … %9, and what stands in them. Whoever shows it words it: the
/// console in English (english()), the window in its language (`messageText()` in widgets/common/devicetext). Written without
/// trailing full stop, to read well behind a colon. Immutable and shared, so that copies are cheap; any thread.
class Message {
public:
    Message() = default; ///< says nothing
    /// What is not ours to translate: a name, what another program or the system says.
    [[nodiscard]] static Message verbatim(std::string text);
    /// A label of a table (`QT_TRANSLATE_NOOP("table", …)`), which has a translation of its own.
    [[nodiscard]] static Message label(std::string_view english);
    /// For say(), and for whoever reads one that was saved.
    [[nodiscard]] static Message composed(std::string_view literal, std::vector<MessageArgument> arguments);

    [[nodiscard]] bool empty() const { return !m_body; }
    /// Numbers with a dot.
    [[nodiscard]] const std::string &english() const;
    [[nodiscard]] bool isVerbatim() const;
    /// What is looked up for a translation.
    [[nodiscard]] std::string_view literal() const;
    /// In the order of their places.
    [[nodiscard]] std::span<const MessageArgument> arguments() const;

    /// Whether they say the same.
    friend bool operator==(const Message &a, const Message &b)
    {
        return a.m_body == b.m_body || a.english() == b.english();
    }
    friend bool operator==(const Message &message, std::string_view english) { return message.english() == english; }
    friend std::ostream &operator<<(std::ostream &out, const Message &message);

private:
    struct Body;
    explicit Message(std::shared_ptr<const Body> body)
        : m_body(std::move(body))
    {
    }
    std::shared_ptr<const Body> m_body;
};

/// A number as a message says it: with so many decimals, or shortest where that is negative, and its unit behind a blank.
struct MessageNumber {
    double value = 0.0;
    int decimals = -1;
    std::string unit{};
};

/// What stands in a place of a message: text stands as it is, a message is translated with it.
struct MessageArgument {
    std::variant<std::int64_t, MessageNumber, std::string, Message> value;

    template <std::integral T>
    requires(!std::same_as<T, bool> && !std::same_as<T, char>)
        MessageArgument(T number) // NOLINT(google-explicit-constructor)
        : value(static_cast<std::int64_t>(number))
    {
    }
    template <std::floating_point T>
    MessageArgument(T number) // NOLINT(google-explicit-constructor)
        : value(MessageNumber{number})
    {
    }
    template <std::convertible_to<std::string_view> T>
    requires(!std::same_as<T, Message>) MessageArgument(const T &text) // NOLINT(google-explicit-constructor)
        : value(std::string(std::string_view(text)))
    {
    }
    MessageArgument(MessageNumber quantity) // NOLINT(google-explicit-constructor)
        : value(std::move(quantity))
    {
    }
    MessageArgument(Message message) // NOLINT(google-explicit-constructor)
        : value(std::move(message))
    {
    }
};

/// A literal whose places are as many as the arguments: checked by the compiler.
template <class... Arguments> class MessageLiteral {
public:
    template <std::size_t N>
    consteval MessageLiteral(const char (&text)[N]) // NOLINT
        : m_text(text, N - 1)
    {
        for (std::size_t i = 0; i + 1 < m_text.size(); ++i) {
            if (m_text[i] == '%' && m_text[i + 1] >= '1' && m_text[i + 1] <= '9')
                m_places |= 1U << static_cast<unsigned>(m_text[i + 1] - '1');
        }
        if (m_places != (1U << sizeof...(Arguments)) - 1U)
            everyArgumentNeedsItsPlace();
    }
    [[nodiscard]] std::string_view text() const { return m_text; }

private:
    static void everyArgumentNeedsItsPlace() { } ///< not constexpr, so that calling it ends the compilation

    std::string_view m_text;
    unsigned m_places = 0;
};

/// `say("%1 units answer as number %2", count, number)`. The literal stands in the call, where scripts/translate finds it.
template <class... Arguments>
[[nodiscard]] Message say(MessageLiteral<std::type_identity_t<Arguments>...> literal, const Arguments &...arguments)
{
    std::vector<MessageArgument> list;
    list.reserve(sizeof...(Arguments));
    (list.emplace_back(arguments), ...);
    return Message::composed(literal.text(), std::move(list));
}

/// "one; other", or the one that says something.
[[nodiscard]] Message joined(const Message &one, const Message &other);

/// Shortest text that reads back equal: "0.1", "250", "1e+20"; always with a dot.
[[nodiscard]] std::string numberText(double number);
/// "0.1", "250", "12.50 V".
[[nodiscard]] std::string textOf(const MessageNumber &quantity);

} // namespace mb
