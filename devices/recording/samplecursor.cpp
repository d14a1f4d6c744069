// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/samplecursor.h"

#include <utility>

namespace mb {
namespace {

constexpr std::size_t blockSize = 4096;

} // namespace

SampleCursor::SampleCursor(std::shared_ptr<const Telemetry> telemetry, ChannelIndex channel, Instant from)
    : m_telemetry(std::move(telemetry))
    , m_channel(channel)
    , m_from(from)
    , m_generation(m_telemetry->generation(channel))
{
}

const Point *SampleCursor::peek(Instant to)
{
    if (m_place >= m_block.size()) {
        const std::uint64_t generation = m_telemetry->generation(m_channel);
        const bool isNew = std::exchange(m_generation, generation) != generation;
        if (isNew || (!m_begun && m_index == 0 && m_from != Instant::min()))
            m_index = m_from == Instant::min() ? 0 : m_telemetry->lowerBound(m_channel, m_from);
        m_blockBegin = m_index;
        m_index = m_telemetry->read(m_channel, m_index, Instant::max(), blockSize, m_block);
        m_place = 0;
        // A gap before the first sample of the stretch lies outside it.
        if (!m_begun && !m_block.empty()) {
            m_begun = true;
            m_place = m_block.front().isGap() ? 1 : 0;
        }
    }
    if (m_place >= m_block.size())
        return nullptr;
    const Point &next = m_block[m_place];
    const Point &sample = next.isGap() && m_place + 1 < m_block.size() ? m_block[m_place + 1] : next;
    return sample.time <= to ? &next : nullptr;
}

void SampleCursor::rewind(Place place)
{
    if (place.generation != m_telemetry->generation(m_channel))
        place = {0, 0, place.begun, m_telemetry->generation(m_channel)};
    m_begun = place.begun;
    m_blockBegin = place.block;
    m_place = place.point;
    m_generation = place.generation;
    m_index = m_telemetry->read(m_channel, place.block, Instant::max(), blockSize, m_block);
}

} // namespace mb
