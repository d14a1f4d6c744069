// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/sampletape.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace mb {

SampleTape::~SampleTape()
{
    clear();
}

Micros SampleTape::toMicros(Instant time)
{
    return std::chrono::floor<std::chrono::microseconds>(time.time_since_epoch()).count();
}

TapePosition SampleTape::append(Micros time, double value)
{
    SampleChunk &chunk = chunkFor(time);
    if (chunk.count == 0)
        m_sums.back().first = value;
    const TapePosition position = positionOf(m_chunks.size() - 1, chunk.count);
    chunk.values[chunk.count] = value;
    chunk.offsets[chunk.count] = static_cast<std::uint32_t>(time - m_starts.back());
    Sums &sums = m_sums.back();
    const double difference = value - sums.first;
    sums.sum += difference;
    sums.squares += difference * difference;
    ++chunk.count;
    include(chunk, position, value);
    m_lastTime = time;
    ++m_size;
    return position;
}

void SampleTape::keepIn(std::shared_ptr<ChunkStore> store)
{
    if (m_chunks.empty())
        m_store = std::move(store);
}

void SampleTape::clear()
{
    if (m_store)
        m_store->shrink((m_chunks.size() - m_movedOut) * sizeof(SampleChunk));
    m_chunks.clear();
    m_movedOut = 0;
    m_sums.clear();
    m_starts.clear();
    for (auto &level : m_levels)
        level.clear();
    m_size = 0;
    m_lastTime = std::numeric_limits<Micros>::min();
}

TapePosition SampleTape::next(TapePosition position) const
{
    const bool inside = placeOf(position) + 1 < m_chunks[chunkOf(position)]->count;
    return inside ? position + 1 : positionOf(chunkOf(position) + 1, 0);
}

TapePosition SampleTape::previous(TapePosition position) const
{
    if (placeOf(position) > 0)
        return position - 1;
    const std::size_t chunk = chunkOf(position) - 1;
    return positionOf(chunk, m_chunks[chunk]->count - 1);
}

std::size_t SampleTape::indexOf(TapePosition position) const
{
    return position == end() ? m_size : m_chunks[chunkOf(position)]->firstIndex + placeOf(position);
}

TapePosition SampleTape::positionAt(std::size_t index) const
{
    const auto after = std::partition_point(
        m_chunks.begin(), m_chunks.end(), [index](const auto &chunk) { return chunk->firstIndex <= index; });
    const auto chunk = static_cast<std::size_t>(after - m_chunks.begin()) - 1;
    return positionOf(chunk, static_cast<std::uint32_t>(index - m_chunks[chunk]->firstIndex));
}

Micros SampleTape::timeAt(TapePosition position) const
{
    return m_starts[chunkOf(position)] + m_chunks[chunkOf(position)]->offsets[placeOf(position)];
}

Point SampleTape::pointAt(TapePosition position) const
{
    return {toInstant(timeAt(position)), m_chunks[chunkOf(position)]->values[placeOf(position)]};
}

TapePosition SampleTape::search(Micros time, TapePosition from) const
{
    if (from == end())
        return from;
    // The last chunk that begins before `time` has it, or ends before it.
    std::size_t chunk = chunkOf(from);
    std::size_t ahead = 1;
    while (chunk + ahead < m_starts.size() && m_starts[chunk + ahead] < time) {
        chunk += ahead;
        ahead *= 2;
    }
    const auto high = m_starts.begin() + static_cast<std::ptrdiff_t>(std::min(chunk + ahead, m_starts.size()));
    const auto begin = m_starts.begin() + static_cast<std::ptrdiff_t>(chunk + 1);
    chunk = static_cast<std::size_t>(std::lower_bound(std::min(begin, high), high, time) - m_starts.begin()) - 1;
    const std::uint32_t least = chunk == chunkOf(from) ? placeOf(from) : 0;
    const std::uint32_t place = m_chunks[chunk]->search(time - m_starts[chunk], least, m_visited);
    return place < m_chunks[chunk]->count ? positionOf(chunk, place) : positionOf(chunk + 1, 0);
}

Extent SampleTape::range(TapePosition from, TapePosition to) const
{
    Extent sum = Extent::nothing();
    const std::size_t last = chunkOf(to);
    std::size_t chunk = chunkOf(from);
    if (placeOf(from) > 0) {
        addPlaces(chunk, placeOf(from), chunk == last ? placeOf(to) : m_chunks[chunk]->count, sum);
        if (chunk == last)
            return sum;
        ++chunk;
    }
    addChunks(chunk, last, sum);
    if (placeOf(to) > 0)
        addPlaces(last, 0, placeOf(to), sum);
    return sum;
}

SampleTape::Moments SampleTape::moments(TapePosition from, TapePosition to) const
{
    Moments moments;
    for (std::size_t chunk = chunkOf(from); chunk <= chunkOf(to) && chunk < m_chunks.size(); ++chunk) {
        const std::uint32_t first = chunk == chunkOf(from) ? placeOf(from) : 0;
        const std::uint32_t last = chunk == chunkOf(to) ? placeOf(to) : m_chunks[chunk]->count;
        addMoments(chunk, first, last, moments);
    }
    return moments;
}

std::size_t SampleTape::memoryUse() const
{
    std::size_t bytes = (m_chunks.size() - m_movedOut) * sizeof(SampleChunk)
        + m_chunks.capacity() * sizeof(m_chunks.front()) + m_starts.capacity() * sizeof(Micros)
        + m_sums.capacity() * sizeof(Sums);
    for (const auto &level : m_levels)
        bytes += level.capacity() * sizeof(Extent);
    return bytes;
}

void SampleTape::Release::operator()(SampleChunk *chunk) const
{
    static_assert(std::is_trivially_copyable_v<SampleChunk> && std::is_trivially_destructible_v<SampleChunk>);
    if (store)
        store->giveBack(chunk);
    else
        delete chunk;
}

SampleChunk &SampleTape::chunkFor(Micros time)
{
    const bool fits = !m_chunks.empty() && m_chunks.back()->count < SampleChunk::size
        && time - m_starts.back() <= std::numeric_limits<std::uint32_t>::max();
    if (!fits) {
        if (m_store)
            moveOut();
        m_chunks.emplace_back(std::make_unique_for_overwrite<SampleChunk>().release());
        if (m_store)
            m_store->grow(sizeof(SampleChunk));
        m_chunks.back()->count = 0;
        m_chunks.back()->firstIndex = m_size;
        m_sums.emplace_back();
        m_starts.push_back(time);
    }
    return *m_chunks.back();
}

void SampleTape::moveOut()
{
    while (m_movedOut < m_chunks.size() && m_store->isOverBudget()) {
        void *there = m_store->take(sizeof(SampleChunk));
        if (!there)
            return; // no disk: it stays in memory, and the store says why
        auto &chunk = m_chunks[m_movedOut];
        std::memcpy(there, chunk.get(), sizeof(SampleChunk));
        chunk = std::unique_ptr<SampleChunk, Release>(static_cast<SampleChunk *>(there), Release{m_store.get()});
        ++m_movedOut;
        m_store->shrink(sizeof(SampleChunk));
    }
}

void SampleTape::include(SampleChunk &chunk, TapePosition position, double value)
{
    const std::uint32_t place = placeOf(position);
    // What changes nothing in a node changes nothing above it.
    if (!chunk.fine[place / 16].take(place % 16 == 0, position, value))
        return;
    if (!chunk.coarse[place / 256].take(place % 256 == 0, position, value))
        return;
    std::size_t index = chunkOf(position);
    for (auto &level : m_levels) {
        const bool fresh = index == level.size();
        if (fresh)
            level.emplace_back();
        if (!level[index].take(fresh, position, value))
            return;
        index /= 16;
    }
}

void SampleTape::join(Moments &moments, const Sums &sums, double count)
{
    if (count <= 0.0)
        return;
    const double mean = sums.first + sums.sum / count;
    const double total = moments.count + count;
    const double difference = mean - moments.mean;
    moments.squares += std::max(0.0, sums.squares - sums.sum * sums.sum / count)
        + difference * difference * moments.count * count / total;
    moments.mean += difference * count / total;
    moments.count = total;
}

void SampleTape::addMoments(std::size_t number, std::uint32_t from, std::uint32_t to, Moments &moments) const
{
    const SampleChunk &chunk = *m_chunks[number];
    if (from == 0 && to == chunk.count) {
        join(moments, m_sums[number], to);
        return;
    }
    if (from >= to)
        return;
    Sums sums{chunk.values[from], 0.0, 0.0};
    for (std::uint32_t place = from; place < to; ++place) {
        const double difference = chunk.values[place] - sums.first;
        sums.sum += difference;
        sums.squares += difference * difference;
    }
    join(moments, sums, to - from);
}

void SampleTape::addPlaces(std::size_t number, std::uint32_t from, std::uint32_t to, Extent &sum) const
{
    const SampleChunk &chunk = *m_chunks[number];
    const bool open = to == chunk.count; // then its last nodes end there, too
    std::uint32_t place = from;
    while (place < to) {
        ++m_visited;
        if (place % 256 == 0 && (open || place + 256 <= to)) {
            sum.add(chunk.coarse[place / 256]);
            place += 256;
        } else if (place % 16 == 0 && (open || place + 16 <= to)) {
            sum.add(chunk.fine[place / 16]);
            place += 16;
        } else {
            const double value = chunk.values[place];
            const TapePosition position = positionOf(number, place);
            sum.add({value, value, position, position});
            ++place;
        }
    }
}

void SampleTape::addChunks(std::size_t from, std::size_t to, Extent &sum) const
{
    const bool open = to == m_chunks.size();
    while (from < to) {
        ++m_visited;
        std::size_t level = 0;
        std::size_t size = 1;
        while (level + 1 < levelCount && from % (size * 16) == 0 && (open || from + size * 16 <= to)) {
            size *= 16;
            ++level;
        }
        sum.add(m_levels[level][from / size]);
        from += size;
    }
}

} // namespace mb
