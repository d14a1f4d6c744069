// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/samplestream.h"

#include "app/console/target.h"
#include "model/identity.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace mb::console {
namespace {

/// What follows the link in its selector: a link's own slashes would be levels of a topic.
std::string nameOf(const Device &device)
{
    return std::string(partsOf(device.selector()).device);
}

} // namespace

SampleStream::SampleStream(Console &console, Device &device, Watched watched, Publisher *publisher)
    : m_console(console)
    , m_device(device)
    , m_publisher(publisher)
    , m_name(publisher ? nameOf(device) : std::string())
    , m_driven(watched.driven)
    , m_time(device.clock(), device.link().address())
    , m_start(device.clock().now())
    , m_chosen(device.telemetry()->channels().size(), watched.channels.empty() && watched.states.empty())
    , m_ofChannel(m_chosen.size())
    , m_silence(device.telemetry()->channels().size(),
          [&device](ChannelIndex channel) { return device.telemetry()->lost(channel); })
    , m_states(std::move(watched.states))
    , m_noted(device.states())
    , m_faults(device.liveness().faults)
{
    for (const ChannelIndex channel : watched.channels)
        m_chosen[channel.value] = true;
    device.telemetry()->commit();
    device.link().recount();
    m_lostBefore = lostSoFar();
    if (!console.json() && !publisher)
        console.out().line("t,channel,value,unit");
    m_samples = device.telemetry()->samples().add([this](const Sample &sample) { print(sample); });
    m_stateChanged = device.statesChanged().add([this](Instant time) { printStates(time); });
    m_heardChanged = device.changed().add(
        [this] { m_silence.setHeard(m_device.liveness().heard || m_device.link().address().isRecording()); });
    printStates(m_start);
    if (console.json())
        return; // programs name the states they want
    m_changed = device.changed().add([this] { noteStates(); });
    for (const StateRow *const row : conditionsOf(device.family().states, m_noted)) {
        if (isNews(*row))
            console.note(device.selector() + ": " + std::string(row->clause));
    }
}

void SampleStream::print(const Sample &sample)
{
    if (!m_chosen[sample.channel.value] || sample.time < m_start)
        return;
    ++m_count;
    ++m_ofChannel[sample.channel.value];
    m_silence.sample(sample.channel, sample.time);
    const Channel &channel = m_device.telemetry()->channels()[sample.channel.value];
    print(sample.time, channel.key, sample.value, channel.unit, sample.value);
}

void SampleStream::print(
    Instant time, std::string_view key, double value, std::string_view unit, const QJsonValue &json)
{
    if (m_publisher) {
        m_publisher->publish(m_name, key, m_time.seconds(time), value, unit);
        return;
    }
    if (m_console.json()) {
        m_console.out().json({
            {QStringLiteral("t"), m_time.seconds(time)},
            {QStringLiteral("channel"), qt(key)},
            {QStringLiteral("value"), json},
            {QStringLiteral("unit"), qt(unit)},
        });
        return;
    }
    std::array<char, 40> seconds{};
    std::snprintf(seconds.data(), seconds.size(), "%.6f,", m_time.seconds(time));
    std::string line = seconds.data();
    line += key;
    line += ',' + numberText(value) + ',';
    line += unit;
    m_console.out().line(line);
}

void SampleStream::printStates(Instant time)
{
    const LiveStates now = m_device.states();
    for (const StateIndex index : m_states) {
        const auto on = now[index];
        if (!on || on == m_printed[index])
            continue;
        ++m_count;
        print(std::max(time, m_start), m_device.family().states[index.value].key, *on ? 1.0 : 0.0, {}, *on);
    }
    m_printed = now;
}

void SampleStream::noteStates()
{
    const auto table = m_device.family().states;
    const LiveStates now = m_device.states();
    for (std::size_t i = 0; i < table.size(); ++i) {
        const StateIndex index{static_cast<std::uint16_t>(i)};
        if (isNews(table[i]) && m_noted.isOn(index) != now.isOn(index))
            m_console.note(
                m_device.selector() + ": " + std::string(table[i].clause) + (now.isOn(index) ? "" : ": over"));
    }
    m_noted = now;
    const std::vector<std::string> &faults = m_device.liveness().faults;
    if (faults == m_faults)
        return;
    for (const std::string &fault : faults) {
        if (std::ranges::find(m_faults, fault) == m_faults.end())
            m_console.note(m_device.selector() + ": fault " + fault);
    }
    for (const std::string &fault : m_faults) {
        if (std::ranges::find(faults, fault) == faults.end())
            m_console.note(m_device.selector() + ": fault " + fault + ": over");
    }
    m_faults = faults;
}

std::uint64_t SampleStream::lost() const
{
    m_device.telemetry()->commit();
    m_device.link().recount();
    const std::uint64_t now = lostSoFar();
    return (now > m_lostBefore ? now - m_lostBefore : 0) + m_silence.missed(m_device.clock().now());
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

Result<Watched> parseWatched(const Family &family, const std::vector<std::string> &names)
{
    std::vector<std::string_view> known;
    for (const Channel &channel : family.channels)
        known.push_back(channel.key);
    for (const StateRow &state : family.states)
        known.push_back(state.key);
    Watched watched;
    for (const std::string &name : names) {
        if (const auto channel = findChannel(family.channels, name))
            watched.channels.push_back(*channel);
        else if (const auto state = findState(family.states, name))
            watched.states.push_back(*state);
        else
            return fail(Fault::Usage, say("%1 has no channel '%2'", family.key, name),
                suggestion(name, known, "it has " + joined(known)));
    }
    return watched;
}

} // namespace mb::console
