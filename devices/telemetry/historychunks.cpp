// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/chunkstore.h"
#include "telemetry/historychunk.h"

#include <cstring>
#include <type_traits>

namespace mb {

void History::Release::operator()(Chunk *chunk) const
{
    static_assert(std::is_trivially_copyable_v<Chunk> && std::is_trivially_destructible_v<Chunk>);
    if (store)
        store->giveBack(chunk);
    else
        delete chunk;
}

History::History() = default;

History::~History()
{
    clear();
}

void History::keepIn(std::shared_ptr<ChunkStore> store)
{
    if (m_chunks.empty())
        m_store = std::move(store);
}

void History::clear()
{
    if (m_store)
        m_store->shrink((m_chunks.size() - m_movedOut) * sizeof(Chunk));
    m_chunks.clear();
    m_movedOut = 0;
    m_sums.clear();
    m_starts.clear();
    for (auto &level : m_levels)
        level.clear();
    m_breaks.clear();
    m_size = 0;
    m_lastTime = std::numeric_limits<Micros>::min();
    m_lost = 0;
    m_clamped = 0;
    m_broken = false;
    ++m_generation;
    ++m_revision;
}

History::Chunk &History::room(Micros time)
{
    const bool fits = !m_chunks.empty() && m_chunks.back()->count < chunkSize
        && time - m_starts.back() <= std::numeric_limits<std::uint32_t>::max();
    if (!fits) {
        if (m_store)
            moveOut();
        m_chunks.emplace_back(std::make_unique_for_overwrite<Chunk>().release());
        if (m_store)
            m_store->grow(sizeof(Chunk));
        m_chunks.back()->count = 0;
        m_chunks.back()->firstIndex = m_size;
        m_sums.emplace_back();
        m_starts.push_back(time);
    }
    return *m_chunks.back();
}

void History::moveOut()
{
    while (m_movedOut < m_chunks.size() && m_store->isOverBudget()) {
        void *there = m_store->take(sizeof(Chunk));
        if (!there)
            return; // no disk: it stays in memory, and the store says why
        auto &chunk = m_chunks[m_movedOut];
        std::memcpy(there, chunk.get(), sizeof(Chunk));
        chunk = std::unique_ptr<Chunk, Release>(static_cast<Chunk *>(there), Release{m_store.get()});
        ++m_movedOut;
        m_store->shrink(sizeof(Chunk));
    }
}

std::size_t History::memoryUse() const
{
    std::size_t bytes = (m_chunks.size() - m_movedOut) * sizeof(Chunk) + m_chunks.capacity() * sizeof(m_chunks.front())
        + m_starts.capacity() * sizeof(Micros) + m_sums.capacity() * sizeof(Sums) + m_breaks.capacity() * sizeof(Break);
    for (const auto &level : m_levels)
        bytes += level.capacity() * sizeof(Node);
    return bytes;
}

/// Number, mean and sum of squared differences from it; two of them join without loss.
struct History::Moments {
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;

    void add(const Sums &sums, double n)
    {
        if (n <= 0.0)
            return;
        const Moments other{n, sums.first + sums.sum / n, std::max(0.0, sums.squares - sums.sum * sums.sum / n)};
        const double total = count + n;
        const double difference = other.mean - mean;
        squares += other.squares + difference * difference * count * n / total;
        mean += difference * n / total;
        count = total;
    }
};

void History::addMoments(std::size_t number, std::uint32_t from, std::uint32_t to, Moments &moments) const
{
    const Chunk &chunk = *m_chunks[number];
    if (from == 0 && to == chunk.count) {
        moments.add(m_sums[number], to);
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
    moments.add(sums, to - from);
}

std::optional<History::Statistics> History::statistics(Instant from, Instant to) const
{
    const Position begin = search(toMicros(from));
    const Position after = search(toMicros(to) + 1, begin);
    if (begin >= after)
        return std::nullopt;
    Moments moments;
    for (std::size_t chunk = chunkOf(begin); chunk <= chunkOf(after) && chunk < m_chunks.size(); ++chunk) {
        const std::uint32_t first = chunk == chunkOf(begin) ? placeOf(begin) : 0;
        const std::uint32_t last = chunk == chunkOf(after) ? placeOf(after) : m_chunks[chunk]->count;
        addMoments(chunk, first, last, moments);
    }
    const Node node = range(begin, after);
    Statistics found;
    found.count = indexOf(after) - indexOf(begin);
    found.mean = moments.mean;
    found.deviation = std::sqrt(moments.squares / moments.count);
    found.rms = std::sqrt(moments.mean * moments.mean + moments.squares / moments.count);
    found.low = node.low;
    found.high = node.high;
    // A gap before the first of them lies outside.
    const auto firstGap = breakFrom(begin + 1);
    const auto lastGap = breakFrom(after);
    if (firstGap != lastGap) {
        const std::uint64_t before = firstGap == m_breaks.begin() ? 0 : std::prev(firstGap)->lostSoFar;
        found.lost = std::prev(lastGap)->lostSoFar - before;
    }
    return found;
}

} // namespace mb
