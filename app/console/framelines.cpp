// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/framelines.h"

#include "app/console/target.h"
#include "wire/bytelog.h"

namespace mb::console {
namespace {

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
        {QStringLiteral("address"), decoded ? QJsonValue(decoded->address) : QJsonValue()},
        {QStringLiteral("fields"), fields},
    };
}

/// What follows a line of the log.
std::string textOf(const std::optional<DecodedFrame> &decoded)
{
    if (!decoded)
        return {};
    std::string text = "  " + std::string(decoded->family) + ':' + std::to_string(decoded->address) + ' '
        + std::string(decoded->message);
    for (const DecodedField &field : decoded->fields) {
        text += ' ' + std::string(field.name) + '=' + numberText(field.value);
        if (!field.unit.empty())
            text += ' ' + std::string(field.unit);
    }
    return text;
}

} // namespace

FrameLines::FrameLines(Console &console, std::string dialect)
    : m_console(console)
    , m_dialect(std::move(dialect))
{
}

void FrameLines::print(Duration time, std::string_view link, const CanFrame &frame)
{
    const auto decoded = decode(frame);
    if (m_console.json())
        printJson(time, link, frame, decoded);
    else
        printText(time, link, frame, decoded);
}

std::optional<DecodedFrame> FrameLines::decode(const CanFrame &frame) const
{
    if (frame.error)
        return std::nullopt;
    for (const Family *family : m_console.families()) {
        if (!family->decodeCan)
            continue;
        if (auto decoded = family->decodeCan(frame, m_dialect))
            return decoded;
    }
    return std::nullopt;
}

FrameLines::Stream &FrameLines::streamOf(std::string_view link)
{
    if (const auto known = m_streams.find(link); known != m_streams.end())
        return known->second;
    Stream &stream = m_streams[std::string(link)];
    for (const Family *family : m_console.families()) {
        if (family->decodeBytes)
            stream.decoders.push_back(family->decodeBytes(m_dialect));
    }
    return stream;
}

void FrameLines::print(Duration time, std::string_view link, Direction direction, std::span<const std::uint8_t> bytes)
{
    Stream &stream = streamOf(link);
    if (stream.decoders.empty())
        print(link, DecodedBytes{time, direction, {bytes.begin(), bytes.end()}, {}});
    for (std::size_t i = 0; i < stream.decoders.size(); ++i) {
        std::vector<DecodedBytes> found;
        stream.decoders[i]->take(time, direction, bytes, found);
        print(link, stream, i, found);
    }
}

void FrameLines::finish()
{
    for (auto &[link, stream] : m_streams) {
        for (std::size_t i = 0; i < stream.decoders.size(); ++i) {
            std::vector<DecodedBytes> found;
            stream.decoders[i]->finish(found);
            print(link, stream, i, found);
        }
    }
    m_streams.clear();
}

void FrameLines::print(
    std::string_view link, Stream &stream, std::size_t decoder, const std::vector<DecodedBytes> &found)
{
    for (const DecodedBytes &bytes : found) {
        if (bytes.frame)
            stream.leading = decoder;
        if (stream.leading == decoder)
            print(link, bytes);
    }
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

Result<void> checkDialect(const Console &console, const std::string &dialect)
{
    std::string known;
    for (const Family *family : console.families()) {
        for (const DialectChoice &row : family->dialects) {
            if (!family->decodeCan)
                continue;
            if (row.key == dialect)
                return {};
            known += (known.empty() ? "" : ", ") + std::string(row.key);
        }
    }
    if (dialect.empty())
        return {};
    return fail(Fault::Usage, "--dialect: '" + dialect + "' is unknown", known + " are known");
}

} // namespace mb::console
