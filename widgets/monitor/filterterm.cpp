// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/filterterm.h"

#include "widgets/monitor/frametext.h"

#include <algorithm>
#include <array>

namespace mb {
namespace {

using Test = FilterTerm::Test;

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool anyMatches(const std::vector<std::string> &patterns, std::string_view text)
{
    return std::ranges::any_of(patterns, [text](const std::string &pattern) { return wildcardMatches(pattern, text); });
}

/// Digits in lower case, as many as the frame is written with.
class HexDigits {
public:
    explicit HexDigits(const CanFrame &frame)
        : m_size(frame.extended || frame.error ? 8U : 3U)
    {
        std::uint32_t rest = frame.id;
        for (std::size_t i = m_size; i-- > 0; rest >>= 4U)
            m_digits.at(i) = "0123456789abcdef"[rest & 0xFU];
    }
    [[nodiscard]] std::string_view all() const { return {m_digits.data(), m_size}; }
    [[nodiscard]] std::string_view significant() const
    {
        const auto from = all().find_first_not_of('0');
        return from == std::string_view::npos ? all().substr(m_size - 1) : all().substr(from);
    }

private:
    std::array<char, 8> m_digits{};
    std::size_t m_size;
};

std::string packedBytes(const TrafficRecord &record)
{
    const std::span<const std::uint8_t> bytes = record.isFrame() ? record.frame.bytes() : std::span(record.bytes);
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += "0123456789abcdef"[byte >> 4U];
        text += "0123456789abcdef"[byte & 0xFU];
    }
    return text;
}

bool holdsId(const FilterTerm &term, const CanFrame &frame)
{
    if (std::ranges::any_of(term.ranges,
            [&frame](const FilterTerm::Range &range) { return frame.id >= range.low && frame.id <= range.high; }))
        return true;
    if (term.patterns.empty())
        return false;
    const HexDigits digits(frame);
    return anyMatches(term.patterns, digits.all()) || anyMatches(term.patterns, digits.significant());
}

bool holdsData(const FilterTerm &term, const TrafficRecord &record)
{
    return !record.frame.remote && anyMatches(term.patterns, packedBytes(record));
}

bool holdsField(const FilterTerm &term, const DecodedFrame &frame)
{
    using Comparison = FilterTerm::Comparison;
    const auto compares = [&term](const DecodedField &field) {
        double number = term.number;
        if (term.percent) {
            const auto scale = fullScale(field.unit);
            if (!scale)
                return false;
            number = term.number / 100.0 * *scale;
        }
        switch (term.comparison) {
        case Comparison::Exists: return true;
        case Comparison::Less: return field.value < number;
        case Comparison::AtMost: return field.value <= number;
        case Comparison::More: return field.value > number;
        case Comparison::AtLeast: return field.value >= number;
        case Comparison::Equal: return field.value == number;
        case Comparison::Differs: return field.value != number;
        }
        return false;
    };
    return std::ranges::any_of(frame.fields,
        [&](const DecodedField &field) { return anyMatches(term.patterns, field.name) && compares(field); });
}

bool holdsWord(const FilterTerm &term, const FrameFacts &facts)
{
    const TrafficRecord &record = facts.record();
    if (record.isFrame() && anyMatches(term.patterns, HexDigits(record.frame).all()))
        return true;
    const FrameMeaning *meaning = facts.meaning();
    return meaning
        && (anyMatches(term.patterns, meaning->frame.message) || anyMatches(term.patterns, meaning->family->key));
}

bool holdsMeaning(const FilterTerm &term, const FrameFacts &facts)
{
    const FrameMeaning &meaning = *facts.meaning();
    switch (term.test) {
    case Test::Family: return anyMatches(term.patterns, meaning.family->key);
    case Test::Message: return anyMatches(term.patterns, meaning.frame.message);
    case Test::Device:
        return std::ranges::any_of(term.ranges, [&meaning](const FilterTerm::Range &range) {
            const auto address = static_cast<std::uint32_t>(meaning.frame.address);
            return meaning.frame.address >= 0 && address >= range.low && address <= range.high;
        });
    case Test::Control: return meaning.frame.control;
    case Test::Field: return holdsField(term, meaning.frame);
    default: return false;
    }
}

} // namespace

bool wildcardMatches(std::string_view pattern, std::string_view text)
{
    std::size_t p = 0;
    std::size_t t = 0;
    std::size_t star = std::string_view::npos;
    std::size_t resume = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = t;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == lower(text[t]))) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++resume;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool holds(const FilterTerm &term, const FrameFacts &facts)
{
    const TrafficRecord &record = facts.record();
    switch (term.test) {
    case Test::Id: return record.isFrame() && holdsId(term, record.frame);
    case Test::Sent: return record.direction == Direction::Sent;
    case Test::Data: return holdsData(term, record);
    case Test::Extended: return record.frame.extended;
    case Test::Remote: return record.frame.remote;
    case Test::Error: return record.frame.error;
    case Test::Unknown: return record.isFrame() && !record.frame.error && !facts.meaning();
    case Test::Word: return holdsWord(term, facts);
    default: return facts.meaning() && holdsMeaning(term, facts);
    }
}

} // namespace mb
