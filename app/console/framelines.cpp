// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/framelines.h"

#include "app/console/optionwords.h"
#include "app/console/target.h"
#include "model/registry.h"
#include "wire/bytelog.h"

#include <algorithm>

namespace mb::console {
namespace {

constexpr std::size_t mostUndecided = 4096; ///< bytes

QJsonObject objectOf(Duration time, std::string_view link, const std::optional<DecodedFrame> &decoded)
{
    QJsonObject fields;
    if (decoded) {
        for (const DecodedField &field : decoded->fields)
            fields.insert(qt(field.name), field.value);
    }
    return {
        {QStringLiteral("t"), secondsOf(time)},
        {QStringLiteral("link"), qt(link)},
        {QStringLiteral("id"), QJsonValue()},
        {QStringLiteral("data"), QString()},
        {QStringLiteral("family"), decoded ? QJsonValue(qt(decoded->family)) : QJsonValue()},
        {QStringLiteral("message"), decoded ? QJsonValue(qt(decoded->message)) : QJsonValue()},
        {QStringLiteral("address"), decoded && decoded->address >= 0 ? QJsonValue(decoded->address) : QJsonValue()},
        {QStringLiteral("fields"), fields},
    };
}

/// What follows a line of the log.
std::string textOf(const std::optional<DecodedFrame> &decoded)
{
    if (!decoded)
        return {};
    const std::string address = decoded->address < 0 ? "?" : std::to_string(decoded->address);
    std::string text = "  " + std::string(decoded->family) + ':' + address + ' ' + std::string(decoded->message);
    for (const DecodedField &field : decoded->fields) {
        text += ' ' + std::string(field.name) + '=' + numberText(field.value);
        if (!field.unit.empty())
            text += ' ' + std::string(field.unit);
    }
    return text;
}

} // namespace

FrameLines::FrameLines(Console &console, std::string dialect, std::optional<LinkKind> kind)
    : m_console(console)
    , m_dialect(std::move(dialect))
    , m_kind(kind)
{
}

void FrameLines::print(Duration time, std::string_view link, const CanFrame &frame)
{
    CanFrame timed = frame;
    timed.time = Instant(time);
    const auto decoded = decode(link, timed);
    if (m_console.json())
        printJson(time, link, frame, decoded);
    else
        printText(time, link, frame, decoded);
}

std::optional<DecodedFrame> FrameLines::decode(std::string_view link, const CanFrame &frame)
{
    if (frame.error)
        return std::nullopt;
    auto bus = m_buses.find(link);
    if (bus == m_buses.end())
        bus = m_buses.emplace(std::string(link), decoders()).first;
    std::optional<DecodedFrame> known;
    for (const CanDecoder &decoder : bus->second) { // all of them: each follows the whole bus
        auto decoded = decoder(frame);
        if (!known)
            known = std::move(decoded);
    }
    return known;
}

std::vector<CanDecoder> FrameLines::decoders() const
{
    std::vector<CanDecoder> all;
    for (const Family *family : m_console.families()) {
        if (family->followCan)
            all.push_back(family->followCan(m_dialect));
        else if (family->decodeCan)
            all.emplace_back(
                [family, dialect = m_dialect](const CanFrame &frame) { return family->decodeCan(frame, dialect); });
    }
    return all;
}

FrameLines::Stream &FrameLines::streamOf(std::string_view link)
{
    if (const auto known = m_streams.find(link); known != m_streams.end())
        return known->second;
    Stream &stream = m_streams[std::string(link)];
    for (const Family *family : m_console.families()) {
        const auto &kinds = family->links;
        const bool speaks = !m_kind || std::ranges::find(kinds, *m_kind) != kinds.end();
        if (family->decodeBytes && speaks)
            stream.readings.push_back({family->decodeBytes(m_dialect), {}});
    }
    if (stream.readings.size() == 1)
        stream.chosen = 0;
    return stream;
}

void FrameLines::print(Duration time, std::string_view link, Direction direction, std::span<const std::uint8_t> bytes)
{
    Stream &stream = streamOf(link);
    if (stream.readings.empty())
        print(link, DecodedBytes{time, direction, {bytes.begin(), bytes.end()}, {}});
    for (Reading &reading : stream.readings)
        reading.decoder->take(time, direction, bytes, reading.found);
    stream.undecided += bytes.size();
    flush(link, stream, stream.undecided > mostUndecided);
}

void FrameLines::finish()
{
    for (auto &[link, stream] : m_streams) {
        for (Reading &reading : stream.readings)
            reading.decoder->finish(reading.found);
        flush(link, stream, true);
    }
    m_streams.clear();
}

/// `now`: although nobody has found a frame yet.
void FrameLines::flush(std::string_view link, Stream &stream, bool now)
{
    for (std::size_t i = 0; i < stream.readings.size() && !stream.chosen; ++i) {
        const auto &found = stream.readings[i].found;
        if (std::ranges::any_of(found, [](const DecodedBytes &bytes) { return bytes.frame.has_value(); }))
            stream.chosen = i;
    }
    if (stream.readings.empty() || (!stream.chosen && !now))
        return;
    for (const DecodedBytes &bytes : stream.readings[stream.chosen.value_or(0)].found)
        print(link, bytes);
    for (Reading &reading : stream.readings)
        reading.found.clear();
    stream.undecided = 0;
}

void FrameLines::print(std::string_view link, const DecodedBytes &bytes)
{
    if (m_console.json()) {
        QJsonObject line = objectOf(bytes.time, link, bytes.frame);
        line.insert(QStringLiteral("data"), qt(toHexText(bytes.bytes)));
        m_console.out().json(line);
        return;
    }
    const auto direction = bytes.direction == Direction::Sent ? LogDirection::Sent : LogDirection::Received;
    m_console.out().line(toByteLine(bytes.time, link, direction, bytes.bytes) + textOf(bytes.frame));
}

void FrameLines::printJson(
    Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded)
{
    const std::string text = toText(frame);
    QJsonObject line = objectOf(time, link, decoded);
    line.insert(QStringLiteral("id"), static_cast<qint64>(frame.id));
    line.insert(
        QStringLiteral("data"), frame.remote ? QString() : qt(std::string_view(text).substr(text.find('#') + 1)));
    m_console.out().json(line);
}

void FrameLines::printText(
    Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded)
{
    m_console.out().line(toCandumpLine(time, link, frame) + textOf(decoded));
}

std::string dialectHelp()
{
    std::string help = "How frames are read of families with dialects, the usual one first:";
    for (const Family *family : mb::families()) {
        for (const DialectChoice &row : family->dialects) {
            if (family->decodeCan)
                help += (&row == &family->dialects.front() ? ' ' + std::string(family->title) + ' ' : ", ")
                    + std::string(row.key);
        }
    }
    return help;
}

Result<void> checkDialect(const Console &console, const std::string &dialect)
{
    std::string known;
    for (const std::string_view word : dialectWords(console.families())) {
        if (word == dialect)
            return {};
        known += (known.empty() ? "" : ", ") + std::string(word);
    }
    if (dialect.empty())
        return {};
    return fail(Fault::Usage, say("--dialect: '%1' is unknown", dialect), say("%1 are known", known));
}

} // namespace mb::console
