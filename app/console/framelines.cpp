// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/framelines.h"

#include "app/console/target.h"

namespace mb::console {

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

void FrameLines::printJson(
    Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded)
{
    const std::string text = toText(frame);
    QJsonObject fields;
    if (decoded) {
        for (const DecodedField &field : decoded->fields)
            fields.insert(qt(field.name), field.value);
    }
    m_console.out().json({
        {QStringLiteral("t"), secondsOf(time)},
        {QStringLiteral("link"), qt(link)},
        {QStringLiteral("id"), static_cast<qint64>(frame.id)},
        {QStringLiteral("data"), frame.remote ? QString() : qt(std::string_view(text).substr(text.find('#') + 1))},
        {QStringLiteral("family"), decoded ? QJsonValue(qt(decoded->family)) : QJsonValue()},
        {QStringLiteral("message"), decoded ? QJsonValue(qt(decoded->message)) : QJsonValue()},
        {QStringLiteral("address"), decoded ? QJsonValue(decoded->address) : QJsonValue()},
        {QStringLiteral("fields"), fields},
    });
}

void FrameLines::printText(
    Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded)
{
    std::string line = toCandumpLine(time, link, frame);
    if (decoded) {
        line += "  " + std::string(decoded->family) + ':' + std::to_string(decoded->address) + ' '
            + std::string(decoded->message);
        for (const DecodedField &field : decoded->fields) {
            line += ' ' + std::string(field.name) + '=' + numberText(field.value);
            if (!field.unit.empty())
                line += ' ' + std::string(field.unit);
        }
    }
    m_console.out().line(line);
}

} // namespace mb::console
