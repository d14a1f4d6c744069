// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/message.h"

#include <array>
#include <charconv>
#include <cmath>
#include <ostream>

namespace mb {
namespace {

std::string textOf(const MessageArgument &argument)
{
    struct Wording {
        std::string operator()(std::int64_t number) const { return std::to_string(number); }
        std::string operator()(const MessageNumber &quantity) const { return mb::textOf(quantity); }
        std::string operator()(const std::string &text) const { return text; }
        std::string operator()(const Message &message) const { return message.english(); }
    };
    return std::visit(Wording{}, argument.value);
}

std::string filled(std::string_view literal, std::span<const MessageArgument> arguments)
{
    std::string text;
    for (std::size_t i = 0; i < literal.size(); ++i) {
        const char next = i + 1 < literal.size() ? literal[i + 1] : ' ';
        const auto which = static_cast<std::size_t>(next - '1');
        if (literal[i] != '%' || next < '1' || next > '9' || which >= arguments.size()) {
            text += literal[i];
            continue;
        }
        text += textOf(arguments[which]);
        ++i;
    }
    return text;
}

} // namespace

struct Message::Body {
    std::string literal;
    std::vector<MessageArgument> arguments;
    bool verbatim = false;
    std::string english;
};

Message Message::verbatim(std::string text)
{
    return text.empty() ? Message() : Message(std::make_shared<const Body>(Body{{}, {}, true, std::move(text)}));
}

Message Message::label(std::string_view english)
{
    return composed(english, {});
}

Message Message::composed(std::string_view literal, std::vector<MessageArgument> arguments)
{
    if (literal.empty())
        return {};
    std::string english = filled(literal, arguments);
    return Message(
        std::make_shared<const Body>(Body{std::string(literal), std::move(arguments), false, std::move(english)}));
}

const std::string &Message::english() const
{
    static const std::string nothing;
    return m_body ? m_body->english : nothing;
}

bool Message::isVerbatim() const
{
    return m_body && m_body->verbatim;
}

std::string_view Message::literal() const
{
    return m_body ? std::string_view(m_body->literal) : std::string_view();
}

std::span<const MessageArgument> Message::arguments() const
{
    return m_body ? std::span<const MessageArgument>(m_body->arguments) : std::span<const MessageArgument>();
}

std::ostream &operator<<(std::ostream &out, const Message &message)
{
    return out << message.english();
}

Message joined(const Message &one, const Message &other)
{
    return one.empty() ? other : other.empty() ? one : say("%1; %2", one, other);
}

std::string numberText(double number)
{
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number == 0.0 ? 0.0 : number,
        std::abs(number) >= 1e-6 && std::abs(number) < 1e15 ? std::chars_format::fixed : std::chars_format::general);
    return number == 0.0 ? "0" : std::string(buffer.data(), end.ptr);
}

std::string textOf(const MessageNumber &quantity)
{
    std::string text = numberText(quantity.value);
    if (quantity.decimals >= 0 && std::isfinite(quantity.value)) {
        std::array<char, 400> buffer{};
        const auto end = std::to_chars(
            buffer.data(), buffer.data() + buffer.size(), quantity.value, std::chars_format::fixed, quantity.decimals);
        text.assign(buffer.data(), end.ptr);
    }
    return quantity.unit.empty() ? text : text + ' ' + quantity.unit;
}

} // namespace mb
