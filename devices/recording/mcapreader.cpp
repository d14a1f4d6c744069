// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/mcapreader.h"

#include "recording/mcapchunk.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace mb {
namespace {

using mcap::Kind;
using mcap::View;

constexpr std::uint64_t longestRecord = 64U << 20U;
constexpr std::size_t mostSignals = 4000;

constexpr int longestJsonList = 64;
constexpr int deepestJson = 16;

using Tell = std::function<void(const std::string &, double)>;

void walkJson(const QJsonValue &value, const std::string &way, int depth, const Tell &tell)
{
    if (value.isDouble())
        return tell(way, value.toDouble());
    if (value.isBool())
        return tell(way, value.toBool() ? 1.0 : 0.0);
    if (depth == deepestJson)
        return;
    if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (auto part = object.begin(); part != object.end(); ++part)
            walkJson(part.value(), way + '/' + part.key().toStdString(), depth + 1, tell);
    } else if (value.isArray()) {
        const QJsonArray list = value.toArray();
        for (int i = 0; i < std::min(list.size(), longestJsonList); ++i)
            walkJson(list[i], way + '/' + std::to_string(i), depth + 1, tell);
    }
}

/// Every number of a JSON message by its way from the top, `/pose/x`, `/currents/2`: on and off are 1 and 0, texts and nothing are left
/// out, and of a list only the first 64. Whether it is JSON at all.
bool eachNumber(std::span<const unsigned char> json, const Tell &tell)
{
    const QJsonDocument document = QJsonDocument::fromJson(
        QByteArray::fromRawData(reinterpret_cast<const char *>(json.data()), static_cast<int>(json.size())));
    if (document.isNull())
        return false;
    walkJson(document.isArray() ? QJsonValue(document.array()) : QJsonValue(document.object()), {}, 0, tell);
    return true;
}

struct Close {
    void operator()(std::FILE *file) const { std::fclose(file); }
};

/// One pass over a file.
class Pass {
public:
    Pass(const McapReader &reader, const std::string &path)
        : m_reader(reader)
        , m_path(path)
        , m_file(std::fopen(path.c_str(), "rbe"))
    {
    }

    Result<bool> run()
    {
        if (!m_file)
            return fail(unreadable());
        std::array<std::uint8_t, mcap::magic.size()> start{};
        if (std::fread(start.data(), 1, start.size(), m_file.get()) != start.size() || start != mcap::magic)
            return fail(Fault::OutOfRange, say("%1 is not an MCAP file", m_path));
        bool complete = false;
        while (!complete && !(m_reader.enough && m_reader.enough()) && next()) {
            complete = m_kind == Kind::DataEnd;
            if (!complete && !take(m_kind, View(m_content)))
                break;
        }
        if (std::ferror(m_file.get()) != 0)
            return fail(unreadable());
        if (!m_wrong.empty())
            return fail(Fault::OutOfRange, m_wrong);
        if (m_signals.empty())
            return fail(Fault::OutOfRange, say("%1 has no channel of samples", m_path),
                say("messages in JSON can be read, and what this program wrote"));
        return complete;
    }

private:
    [[nodiscard]] Error unreadable() const
    {
        return {Fault::Refused, say("%1 cannot be read: %2", m_path, std::strerror(errno)), {}};
    }
    /// The next whole record; false at the end, wherever that is.
    bool next()
    {
        std::array<std::uint8_t, mcap::recordHead> head{};
        if (std::fread(head.data(), 1, head.size(), m_file.get()) != head.size())
            return false;
        m_kind = static_cast<Kind>(head[0]);
        std::uint64_t length = 0;
        std::memcpy(&length, head.data() + 1, sizeof length);
        if (length > longestRecord)
            return false; // nonsense, such as zeros where a disk had no time to write
        m_content.resize(length);
        return std::fread(m_content.data(), 1, length, m_file.get()) == length;
    }

    bool take(Kind kind, View view)
    {
        switch (kind) {
        case Kind::Schema: takeSchema(view); break;
        case Kind::Channel: takeChannel(view); break;
        case Kind::Message: takeMessage(view); break;
        case Kind::Metadata: {
            const std::string name = view.text();
            const mcap::Map facts = view.map();
            if (view.ok() && m_reader.metadata)
                m_reader.metadata(name, facts);
            break;
        }
        case Kind::Chunk: return takeChunk(view);
        default: break;
        }
        return view.ok();
    }

    void takeSchema(View &view)
    {
        const auto id = view.get<std::uint16_t>();
        if (view.text() == mcap::schemaName)
            m_schemas.insert(id);
    }

    /// Records inside a record, as most other programs write them.
    bool takeChunk(View view)
    {
        const auto unpacked = mcap::recordsOf(view);
        if (!unpacked) {
            m_wrong = say("%1 cannot be read: %2", m_path, unpacked.error().message());
            return false;
        }
        View records(*unpacked);
        while (!records.isEmpty()) {
            const auto kind = static_cast<Kind>(records.get<std::uint8_t>());
            const View inside(records.take(static_cast<std::size_t>(records.get<std::uint64_t>())));
            if (!records.ok() || kind == Kind::Chunk || !take(kind, inside))
                return false;
        }
        return true;
    }

    void takeChannel(View &view)
    {
        const auto id = view.get<std::uint16_t>();
        const bool ours = m_schemas.count(view.get<std::uint16_t>()) > 0;
        const std::string topic = view.text();
        const std::string encoding = view.text();
        const mcap::Map about = view.map();
        if (!view.ok() || m_ours.count(id) > 0)
            return;
        if (ours)
            m_ours[id] = signalOf(topic + '\0' + std::to_string(id), topic, about);
        else if (encoding == "json")
            m_topics.emplace(id, topic);
    }

    /// Numbered in the order in which the file names them.
    std::uint16_t signalOf(const std::string &key, const std::string &name, const mcap::Map &about)
    {
        const auto number = static_cast<std::uint16_t>(m_signals.size());
        const auto [signal, isNew] = m_signals.try_emplace(key, number);
        if (isNew && m_reader.channel)
            m_reader.channel(number, name, about);
        return signal->second;
    }

    void takeMessage(View &view)
    {
        const auto channel = view.get<std::uint16_t>();
        (void)view.get<std::uint32_t>();
        const auto time = static_cast<std::int64_t>(view.get<std::uint64_t>());
        (void)view.get<std::uint64_t>();
        if (const auto topic = m_topics.find(channel); topic != m_topics.end())
            takeNumbers(topic->second, time, view);
        else if (const auto ours = m_ours.find(channel); ours != m_ours.end())
            takeSample(ours->second, time, view);
    }

    void takeNumbers(const std::string &topic, std::int64_t time, View &view)
    {
        eachNumber(view.rest(), [&](const std::string &way, double value) {
            const std::string name = topic + way;
            if (m_signals.size() >= mostSignals && m_signals.count(name) == 0)
                return;
            const std::uint16_t signal = signalOf(name, name, {});
            if (m_reader.sample)
                m_reader.sample(signal, time, value, 0, false);
        });
    }

    void takeSample(std::uint16_t signal, std::int64_t time, View &view)
    {
        double value = 0.0;
        std::uint64_t lost = 0;
        bool gap = false;
        while (view.ok() && !view.isEmpty()) {
            const std::uint64_t tag = view.varint();
            if (tag == (1U << 3U | 1U))
                value = view.get<double>();
            else if (tag == (2U << 3U))
                lost = view.varint();
            else if (tag == (3U << 3U))
                gap = view.varint() != 0;
            else
                return;
        }
        if (view.ok() && m_reader.sample)
            m_reader.sample(signal, time, value, lost, gap);
    }

    const McapReader &m_reader;
    const std::string &m_path;
    std::unique_ptr<std::FILE, Close> m_file;
    Kind m_kind = Kind::Header;
    std::vector<std::uint8_t> m_content;
    std::set<std::uint16_t> m_schemas;
    std::map<std::uint16_t, std::uint16_t> m_ours; ///< channels of our samples, and their signals
    std::map<std::uint16_t, std::string> m_topics; ///< channels of messages in JSON
    std::map<std::string, std::uint16_t> m_signals;
    Message m_wrong;
};

} // namespace

Result<bool> McapReader::read(const std::string &path) const
{
    return Pass(*this, path).run();
}

} // namespace mb
