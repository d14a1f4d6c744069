// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/samplestream.h"

#include "app/console/target.h"

#include <array>
#include <cstdio>

namespace mb::console {

SampleStream::SampleStream(Console &console, Device &device, std::vector<ChannelIndex> channels)
    : m_console(console)
    , m_device(device)
    , m_time(device.clock(), device.link().address())
    , m_start(device.clock().now())
    , m_chosen(device.telemetry()->channels().size(), channels.empty())
{
    for (const ChannelIndex channel : channels)
        m_chosen[channel.value] = true;
    device.telemetry()->commit();
    device.link().recount();
    m_lostBefore = lostSoFar();
    if (!console.json())
        console.out().line("t,channel,value,unit");
    m_samples = device.telemetry()->samples().add([this](const Sample &sample) { print(sample); });
}

void SampleStream::print(const Sample &sample)
{
    if (!m_chosen[sample.channel.value] || sample.time < m_start)
        return;
    ++m_count;
    const Channel &channel = m_device.telemetry()->channels()[sample.channel.value];
    if (m_console.json()) {
        m_console.out().json({
            {QStringLiteral("t"), m_time.seconds(sample.time)},
            {QStringLiteral("channel"), qt(channel.key)},
            {QStringLiteral("value"), sample.value},
            {QStringLiteral("unit"), qt(channel.unit)},
        });
        return;
    }
    std::array<char, 40> time{};
    std::snprintf(time.data(), time.size(), "%.6f,", m_time.seconds(sample.time));
    std::string line = time.data();
    line += channel.key;
    line += ',' + numberText(sample.value) + ',';
    line += channel.unit;
    m_console.out().line(line);
}

std::uint64_t SampleStream::lost() const
{
    m_device.telemetry()->commit();
    m_device.link().recount();
    const std::uint64_t now = lostSoFar();
    return now > m_lostBefore ? now - m_lostBefore : 0;
}

std::uint64_t SampleStream::lostSoFar() const
{
    std::uint64_t lost = m_device.link().counters().lost;
    for (std::size_t i = 0; i < m_chosen.size(); ++i) {
        if (m_chosen[i])
            lost += m_device.telemetry()->lost(ChannelIndex{static_cast<std::uint16_t>(i)});
    }
    return lost;
}

Result<std::vector<ChannelIndex>> parseChannels(const Family &family, const std::vector<std::string> &names)
{
    std::vector<std::string_view> known;
    for (const Channel &channel : family.channels)
        known.push_back(channel.key);
    std::vector<ChannelIndex> channels;
    for (const std::string &name : names) {
        const auto channel = findChannel(family.channels, name);
        if (channel) {
            channels.push_back(*channel);
            continue;
        }
        return fail(Fault::Usage, std::string(family.key) + " has no channel '" + name + "'",
            suggestion(name, known, "it has " + joined(known)));
    }
    return channels;
}

} // namespace mb::console
