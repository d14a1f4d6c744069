// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/jsonlines.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cstring>

namespace mb {
namespace {

constexpr std::string_view atLineLiteral = "line %1: %2";

constexpr int deepest = 1024; // objects and lists within each other, as many as QJsonDocument takes

/// Walks a text that may be none: it ends where the text stops to be JSON.
class Walk {
public:
    Walk(const QByteArray &text, JsonLines &lines)
        : m_text(text)
        , m_lines(lines)
        , m_at(text.startsWith("\xEF\xBB\xBF") ? 3 : 0) // the mark that some editors put before UTF-8
    {
    }
    void value(const std::string &path)
    {
        skip();
        const char c = next();
        if (++m_depth > deepest)
            end();
        else if (c == '{')
            members(path);
        else if (c == '[')
            elements(path);
        else if (c == '"')
            (void)string();
        else
            word();
        --m_depth;
    }

private:
    [[nodiscard]] char next() const { return m_at < m_text.size() ? m_text.at(m_at) : '\0'; }
    void skip()
    {
        while (m_at < m_text.size() && (next() == ' ' || next() == '\t' || next() == '\r' || next() == '\n')) {
            m_line += next() == '\n' ? 1 : 0;
            ++m_at;
        }
    }
    void end() { m_at = m_text.size(); }
    void word()
    {
        const int from = m_at;
        while (m_at < m_text.size() && !std::strchr(",]} \t\r\n", next()))
            ++m_at;
        if (m_at == from)
            end();
    }
    std::string string()
    {
        const int from = m_at++;
        while (m_at < m_text.size() && next() != '"')
            m_at += next() == '\\' ? 2 : 1;
        ++m_at;
        const QByteArray quoted = m_text.mid(from, m_at - from);
        return QJsonDocument::fromJson('[' + quoted + ']').array().at(0).toString().toStdString(); // with its escapes
    }
    void members(const std::string &path)
    {
        ++m_at;
        for (skip(); m_at < m_text.size() && next() != '}'; skip()) {
            if (next() == ',') {
                ++m_at;
                continue;
            }
            if (next() != '"')
                return end();
            const int line = m_line;
            const std::string key = string();
            const std::string inside = path.empty() ? key : path + '.' + key;
            if (!m_lines.lines.emplace(inside, line).second && m_lines.repeated.empty()) {
                m_lines.repeated = inside;
                m_lines.lines[inside] = line;
            }
            skip();
            if (next() != ':')
                return end();
            ++m_at;
            value(inside);
        }
        ++m_at;
    }
    void elements(const std::string &path)
    {
        ++m_at;
        int place = 0;
        for (skip(); m_at < m_text.size() && next() != ']'; skip()) {
            if (next() == ',') {
                ++m_at;
                continue;
            }
            const std::string inside = path + '.' + std::to_string(place++);
            m_lines.lines[inside] = m_line;
            value(inside);
        }
        ++m_at;
    }

    const QByteArray &m_text;
    JsonLines &m_lines;
    int m_at;
    int m_line = 1;
    int m_depth = 0;
};

} // namespace

int JsonLines::of(std::string path) const
{
    for (;;) {
        if (const auto found = lines.find(path); found != lines.end())
            return found->second;
        const auto dot = path.rfind('.');
        if (dot == std::string::npos)
            return 1;
        path.resize(dot);
    }
}

Result<void> JsonLines::checkKeys() const
{
    if (repeated.empty())
        return {};
    return fail(Fault::OutOfRange, atLine(of(repeated), say("the key '%1' is there twice", repeated)));
}

JsonLines linesOf(const QByteArray &text)
{
    JsonLines lines;
    Walk(text, lines).value({});
    return lines;
}

int lineAt(const QByteArray &text, int offset)
{
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + std::clamp(offset, 0, text.size()), '\n'));
}

Message atLine(int line, const Message &mistake)
{
    return say("line %1: %2", line, mistake);
}

std::optional<int> lineOf(const Message &mistake)
{
    const auto parts = mistake.arguments();
    if (mistake.literal() == atLineLiteral)
        return static_cast<int>(std::get<std::int64_t>(parts.front().value));
    for (const MessageArgument &part : parts) {
        const auto *const inside = std::get_if<Message>(&part.value);
        if (const auto line = inside ? lineOf(*inside) : std::nullopt)
            return line;
    }
    return {};
}

} // namespace mb
