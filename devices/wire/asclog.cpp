// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/asclog.h"

#include "wire/ascdate.h"
#include "wire/decimaltime.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

namespace mb {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::string_view ourMark = "// MotorBench ";
constexpr std::string_view startMark = "start ";
constexpr std::string_view channelMark = "channel ";
constexpr std::string_view directionsMark = "directions ";
constexpr std::uint64_t mostChannels = 255;

bool equalsAnyCase(std::string_view a, std::string_view lower)
{
    return a.size() == lower.size() && std::equal(a.begin(), a.end(), lower.begin(), [](char x, char y) {
        return (x >= 'A' && x <= 'Z' ? static_cast<char>(x + 32) : x) == y;
    });
}

std::optional<std::uint64_t> number(std::string_view text, int base)
{
    std::uint64_t value = 0;
    const char *end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value, base);
    if (text.empty() || parsed.ec != std::errc{} || parsed.ptr != end)
        return std::nullopt;
    return value;
}

tl::unexpected<Error> malformed(Message cause)
{
    return fail(Fault::OutOfRange, std::move(cause));
}

std::string quoted(std::string_view text)
{
    std::string out = "'";
    for (const char c : text.substr(0, 40))
        out += c >= ' ' && c != 0x7F ? c : '?';
    return out + '\'';
}

/// `2061405x`, `123`; nothing when it is no identifier.
bool readId(std::string_view text, bool hex, CanFrame &frame)
{
    frame.extended = text.ends_with('x') || text.ends_with('X');
    if (frame.extended)
        text.remove_suffix(1);
    const auto id = number(text, hex ? 16 : 10);
    if (!id || *id > (frame.extended ? 0x1FFFFFFFU : 0x7FFU))
        return false;
    frame.id = static_cast<std::uint32_t>(*id);
    return true;
}

} // namespace

struct AscParser::Words {
    std::string_view rest;

    std::string_view take()
    {
        rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(blanks)));
        const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
        rest.remove_prefix(word.size());
        return word;
    }
};

bool AscParser::begins(std::string_view line)
{
    Words words{line};
    const std::string_view word = words.take();
    return word.starts_with("//") || equalsAnyCase(word, "date") || equalsAnyCase(word, "base")
        || equalsAnyCase(word, "begin") || (equalsAnyCase(word, "internal") && words.take() == "events");
}

Result<std::optional<LoggedFrame>> AscParser::parse(std::string_view line)
{
    const std::optional<LoggedFrame> none;
    Words words{line};
    const std::string_view first = words.take();
    if (first.empty())
        return none;
    if (first.front() >= '0' && first.front() <= '9')
        return readEvent(first, words);
    if (first.starts_with("//")) {
        readComment(line);
        return none;
    }
    if (equalsAnyCase(first, "base")) {
        MB_TRY_VOID(readBase(words));
        return none;
    }
    if (equalsAnyCase(first, "date")) {
        m_start = unixTimeOfAscDate(words.rest).value_or(Duration::zero());
        return none;
    }
    static constexpr std::array<std::string_view, 4> passedOver{"begin", "end", "internal", "no"};
    if (std::ranges::any_of(passedOver, [&](std::string_view w) { return equalsAnyCase(first, w); }))
        return none;
    return malformed(say("%1 begins no line of such a log", quoted(first)));
}

/// `base hex  timestamps absolute`
Result<void> AscParser::readBase(Words words)
{
    const std::string_view base = words.take();
    m_hex = equalsAnyCase(base, "hex");
    if (!m_hex && !equalsAnyCase(base, "dec"))
        return malformed(say("the base of the numbers is %1, not hex or dec", quoted(base)));
    if (!equalsAnyCase(words.take(), "timestamps"))
        return {};
    const std::string_view kind = words.take();
    m_relative = equalsAnyCase(kind, "relative");
    if (!m_relative && !equalsAnyCase(kind, "absolute"))
        return malformed(say("the time stamps are %1, not absolute or relative", quoted(kind)));
    return {};
}

void AscParser::readComment(std::string_view comment)
{
    if (!comment.starts_with(ourMark))
        return;
    comment.remove_prefix(ourMark.size());
    if (comment.starts_with(startMark)) {
        Words words{comment.substr(startMark.size())};
        if (const auto start = parseSeconds(words.take()))
            m_start = *start;
    } else if (comment.starts_with(channelMark)) {
        Words words{comment.substr(channelMark.size())};
        const auto channel = number(words.take(), 10);
        const std::string_view name = words.take();
        if (!channel || *channel < 1 || *channel > mostChannels || name.empty())
            return;
        m_names.resize(std::max<std::size_t>(m_names.size(), *channel));
        m_names[*channel - 1] = name;
    } else if (comment.starts_with(directionsMark)) {
        Words words{comment.substr(directionsMark.size())};
        m_directions = words.take() != "unknown";
    }
}

std::string AscParser::nameOf(std::uint64_t channel) const
{
    if (channel >= 1 && channel <= m_names.size() && !m_names[channel - 1].empty())
        return m_names[channel - 1];
    return "ch" + std::to_string(channel);
}

Result<void> AscParser::readTime(std::string_view time)
{
    const auto stamp = parseSeconds(time);
    if (!stamp)
        return malformed(say("%1 is no time stamp", quoted(time)));
    const Duration room = Duration::max() - m_start;
    if (m_relative ? m_last > room || *stamp > room - m_last : *stamp > room)
        return malformed(say("the time stamp %1 is out of range", quoted(time)));
    m_last = m_relative ? m_last + *stamp : *stamp;
    return {};
}

Result<std::optional<LoggedFrame>> AscParser::readEvent(std::string_view time, Words words)
{
    const std::optional<LoggedFrame> none;
    MB_TRY_VOID(readTime(time));
    const std::string_view where = words.take();
    if (equalsAnyCase(where, "canfd")) {
        ++m_fdFrames;
        return none;
    }
    const auto channel = number(where, 10);
    if (!channel)
        return none;
    const std::string_view what = words.take();
    const std::string_view direction = words.take();
    LoggedFrame logged;
    if (equalsAnyCase(what, "errorframe")) {
        logged = readErrorFrame(direction == "//" ? words : Words{});
    } else if (equalsAnyCase(direction, "rx") || equalsAnyCase(direction, "tx")) {
        MB_TRY(auto frame, readFrame(what, direction, words));
        logged = std::move(frame);
    } else {
        CanFrame frame;
        if (readId(what, m_hex, frame) && !equalsAnyCase(direction, "txrq"))
            return malformed(say("the frame says %1 in the place of Rx or Tx", quoted(direction)));
        return none;
    }
    if (!m_directions)
        logged.direction = LogDirection::Unknown;
    logged.time = m_start + m_last;
    logged.link = nameOf(*channel);
    return logged;
}

LoggedFrame AscParser::readErrorFrame(Words ours)
{
    LoggedFrame logged;
    const auto kept = canFrameFromText(ours.take());
    logged.frame.error = true;
    logged.frame.id = 8; // protocol violation, unspecified (linux/can/error.h)
    logged.frame.size = 8;
    if (kept && kept->error)
        logged.frame = *kept;
    logged.direction = ours.take() == "Tx" ? LogDirection::Sent : LogDirection::Received;
    return logged;
}

Result<LoggedFrame> AscParser::readFrame(std::string_view id, std::string_view direction, Words words) const
{
    LoggedFrame logged;
    CanFrame &frame = logged.frame;
    if (!readId(id, m_hex, frame))
        return malformed(m_hex ? say("%1 is no CAN identifier in hex", quoted(id))
                               : say("%1 is no CAN identifier in dec", quoted(id)));
    logged.direction = equalsAnyCase(direction, "tx") ? LogDirection::Sent : LogDirection::Received;
    const std::string_view kind = words.take();
    frame.remote = equalsAnyCase(kind, "r");
    if (!frame.remote && !equalsAnyCase(kind, "d"))
        return malformed(say("the frame is of the kind %1, not d or r", quoted(kind)));
    const std::string_view length = words.take();
    const auto size = number(length, 16);
    if (frame.remote && !size) // the length may be missing, and `Length = …` follow
        return logged;
    if (!size || *size > 15)
        return malformed(say("the length of the frame is %1", quoted(length)));
    frame.size = static_cast<std::uint8_t>(std::min<std::uint64_t>(*size, frame.data.size())); // 9…15 mean 8
    MB_TRY_VOID(readBytes(words, frame));
    return logged;
}

Result<void> AscParser::readBytes(Words words, CanFrame &frame) const
{
    for (std::size_t i = 0; !frame.remote && i < frame.size; ++i) {
        const auto byte = number(words.take(), m_hex ? 16 : 10);
        if (!byte || *byte > 0xFF)
            return malformed(say("the frame has %1 of %2 bytes", i, frame.size));
        frame.data[i] = static_cast<std::uint8_t>(*byte);
    }
    return {};
}

void AscWriter::begin(Duration start, std::string &out)
{
    m_start = std::chrono::floor<std::chrono::milliseconds>(std::max(start, Duration::zero()));
    if (!m_begun) {
        out += "date " + toAscDate(m_start) + "\nbase hex  timestamps absolute\ninternal events logged\n";
        out += ourMark;
        out += "writes dates in UTC\n";
    }
    out += ourMark;
    out += startMark;
    appendSeconds(out, m_start, 1, '0');
    out += '\n';
    if (!m_begun)
        out += "Begin Triggerblock " + toAscDate(m_start) + "\n   0.000000 Start of measurement\n";
    m_begun = true;
}

std::size_t AscWriter::channelOf(const std::string &link, std::string &out)
{
    const auto known = std::ranges::find(m_names, link);
    const auto channel = static_cast<std::size_t>(known - m_names.begin()) + 1;
    if (known == m_names.end()) {
        m_names.push_back(link);
        out += ourMark;
        out += channelMark;
        out += std::to_string(channel) + ' ' + link + '\n';
    }
    return channel;
}

void AscWriter::write(const LoggedFrame &logged, std::string &out)
{
    const CanFrame &frame = logged.frame;
    if (!m_begun || logged.time < m_start)
        begin(logged.time, out);
    const std::size_t channel = channelOf(logged.link, out);
    if (const bool known = logged.direction != LogDirection::Unknown; known != m_directions) {
        m_directions = known;
        out += ourMark;
        out += directionsMark;
        out += known ? "known\n" : "unknown\n";
    }
    out += "   ";
    appendSeconds(out, logged.time - m_start, 1, ' ');
    out += ' ' + std::to_string(channel) + "  ";
    const std::string text = toText(frame);
    if (frame.error) {
        out += "ErrorFrame // " + text + (logged.direction == LogDirection::Sent ? " Tx\n" : "\n");
        return;
    }
    std::array<char, 12> id{};
    std::snprintf(id.data(), id.size(), "%X", frame.id);
    std::string word = id.data();
    word += frame.extended ? "x" : "";
    word.resize(std::max<std::size_t>(word.size(), 15), ' ');
    out += word + (logged.direction == LogDirection::Sent ? " Tx   " : " Rx   ");
    out += frame.remote ? "r " : "d ";
    out += std::to_string(frame.size);
    for (std::size_t at = text.find('#') + 1; !frame.remote && at + 1 < text.size(); at += 2)
        out.append(" ").append(text, at, 2);
    out += '\n';
}

void AscWriter::finish(std::string &out) const
{
    if (m_begun)
        out += "End TriggerBlock\n";
}

} // namespace mb
