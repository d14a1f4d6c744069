// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/mcapwriter.h"

#include "async/outputfile.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>

namespace mb {
namespace {

using mcap::Content;
using mcap::Kind;

constexpr std::uint16_t schemaId = 1;

/// Field of a message, as descriptor.proto has it: name 1, number 3, label 4 (optional), type 5.
std::string fieldDescription(std::string_view name, std::uint64_t number, std::uint64_t type)
{
    constexpr std::uint64_t optional = 1;
    return Content().field(1, name).field(3, number).field(4, optional).field(5, type).bytes();
}

/// A FileDescriptorSet with one file with one message.
std::string schemaData()
{
    constexpr std::uint64_t typeDouble = 1;
    constexpr std::uint64_t typeUint64 = 4;
    constexpr std::uint64_t typeBool = 8;
    Content message;
    message.field(1, "Sample")
        .field(2, fieldDescription("value", 1, typeDouble))
        .field(2, fieldDescription("lost", 2, typeUint64))
        .field(2, fieldDescription("gap", 3, typeBool));
    Content file;
    file.field(1, "motorbench/sample.proto").field(2, "motorbench").field(4, message.bytes()).field(12, "proto3");
    return Content().field(1, file.bytes()).bytes();
}

std::string schemaRecord()
{
    return Content().put(schemaId).text(mcap::schemaName).text(mcap::schemaEncoding).text(schemaData()).bytes();
}

} // namespace

McapWriter::McapWriter(std::string path, std::FILE *file)
    : m_path(std::move(path))
    , m_file(file)
{
    raw(mcap::magic.data(), mcap::magic.size());
    record(Kind::Header, Content().text("").text("MotorBench").bytes());
    record(Kind::Schema, schemaRecord());
}

McapWriter::~McapWriter() = default;

Result<std::unique_ptr<McapWriter>> McapWriter::create(const std::string &path)
{
    return onto(path, std::fopen(path.c_str(), "wbe"));
}

Result<std::unique_ptr<McapWriter>> McapWriter::create(const OutputFile &place)
{
    const int own = ::fcntl(place.descriptor(), F_DUPFD_CLOEXEC, 0);
    return onto(place.path(), own < 0 ? nullptr : ::fdopen(own, "wb"));
}

Result<std::unique_ptr<McapWriter>> McapWriter::onto(const std::string &path, std::FILE *file)
{
    if (!file)
        return fail(notWritten(Fault::OutOfRange, path, errno));
    std::setvbuf(file, nullptr, _IOFBF, 1U << 18U);
    return std::unique_ptr<McapWriter>(new McapWriter(path, file));
}

void McapWriter::raw(const void *data, std::size_t size)
{
    if (m_error == 0 && std::fwrite(data, 1, size, m_file.get()) != size)
        m_error = errno;
    m_bytes += size;
}

void McapWriter::record(Kind kind, const std::string &content)
{
    std::array<std::uint8_t, mcap::recordHead> head{static_cast<std::uint8_t>(kind)};
    const std::uint64_t length = content.size();
    std::memcpy(head.data() + 1, &length, sizeof length);
    raw(head.data(), head.size());
    raw(content.data(), content.size());
}

std::uint16_t McapWriter::addChannel(const McapChannel &channel)
{
    const auto id = static_cast<std::uint16_t>(m_channels.size());
    m_channels.push_back(
        Content().put(id).put(schemaId).text(channel.topic).text(mcap::schemaEncoding).map(channel.about).bytes());
    m_counts.push_back(0);
    record(Kind::Channel, m_channels.back());
    return id;
}

void McapWriter::write(std::uint16_t channel, std::int64_t nanoseconds, double value, std::uint64_t lost, bool gap)
{
    const auto time = static_cast<std::uint64_t>(std::max<std::int64_t>(nanoseconds, 0));
    m_content.clear();
    m_content.put(channel).put(m_sequence++).put(time).put(time);
    constexpr std::uint8_t valueTag = 1U << 3U | 1U; // field 1, eight bytes
    m_content.put(valueTag).put(value);
    if (lost > 0)
        m_content.field(2, lost);
    if (gap)
        m_content.field(3, std::uint64_t{1});
    record(Kind::Message, m_content.bytes());
    m_firstTime = m_samples == 0 ? time : std::min(m_firstTime, time);
    m_lastTime = std::max(m_lastTime, time);
    ++m_samples;
    ++m_counts[channel];
}

void McapWriter::metadata(const std::string &name, const mcap::Map &facts)
{
    const std::string content = Content().text(name).map(facts).bytes();
    m_facts.push_back({m_bytes, content.size() + mcap::recordHead, name});
    record(Kind::Metadata, content);
}

Result<void> McapWriter::flush()
{
    if (m_error == 0 && std::fflush(m_file.get()) != 0)
        m_error = errno;
    if (m_error != 0)
        return fail(notWritten(Fault::NotKept, m_path, m_error));
    return {};
}

void McapWriter::writeSummary()
{
    record(Kind::Schema, schemaRecord());
    for (const std::string &channel : m_channels)
        record(Kind::Channel, channel);
    Content counts;
    for (std::size_t i = 0; i < m_counts.size(); ++i)
        counts.put(static_cast<std::uint16_t>(i)).put(m_counts[i]);
    Content statistics;
    statistics.put(m_samples).put(std::uint16_t{1}).put(static_cast<std::uint32_t>(m_channels.size()));
    statistics.put(std::uint32_t{0}).put(static_cast<std::uint32_t>(m_facts.size())).put(std::uint32_t{0});
    statistics.put(m_firstTime).put(m_lastTime).text(counts.bytes());
    record(Kind::Statistics, statistics.bytes());
    for (const Fact &fact : m_facts)
        record(Kind::MetadataIndex, Content().put(fact.offset).put(fact.length).text(fact.name).bytes());
}

Result<void> McapWriter::finish()
{
    constexpr std::uint32_t noCheck = 0; // the format's "not computed"
    record(Kind::DataEnd, Content().put(noCheck).bytes());
    const std::uint64_t summary = m_bytes;
    writeSummary();
    record(Kind::Footer, Content().put(summary).put(std::uint64_t{0}).put(noCheck).bytes());
    raw(mcap::magic.data(), mcap::magic.size());
    return flush();
}

} // namespace mb
