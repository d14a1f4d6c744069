// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/history.h"

#include "telemetry/chunkstore.h"
#include "telemetry/historychunk.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace mb {

History::Micros History::toMicros(Instant time)
{
    return std::chrono::floor<std::chrono::microseconds>(time.time_since_epoch()).count();
}

void History::append(Instant time, double value)
{
    if (!std::isfinite(value)) {
        breakLine(1);
        return;
    }
    Micros micros = toMicros(time);
    if (micros < m_lastTime) {
        micros = m_lastTime;
        ++m_clamped;
    }
    Chunk &chunk = room(micros);
    if (chunk.count == 0)
        m_sums.back().first = value;
    const Position position = positionOf(m_chunks.size() - 1, chunk.count);
    if (m_broken)
        m_breaks.push_back({position, m_lost});
    m_broken = false;
    chunk.values[chunk.count] = value;
    chunk.offsets[chunk.count] = static_cast<std::uint32_t>(micros - m_starts.back());
    Sums &sums = m_sums.back();
    const double difference = value - sums.first;
    sums.sum += difference;
    sums.squares += difference * difference;
    ++chunk.count;
    include(chunk, position, value);
    m_lastTime = micros;
    ++m_size;
    ++m_revision;
}

void History::breakLine(std::uint64_t lost)
{
    m_lost += lost;
    m_broken = true;
    ++m_revision;
}

std::optional<Point> History::first() const
{
    return isEmpty() ? std::nullopt : std::optional(pointAt(0));
}

std::optional<Point> History::last() const
{
    return isEmpty() ? std::nullopt : std::optional(pointAt(previous(end())));
}

std::optional<Point> History::at(Instant time) const
{
    const Position after = search(toMicros(time) + 1);
    return after == 0 ? std::nullopt : std::optional(pointAt(previous(after)));
}

std::optional<History::Extremes> History::extremes(Instant from, Instant to) const
{
    const Position begin = search(toMicros(from));
    const Position after = search(toMicros(to) + 1, begin);
    if (begin >= after)
        return std::nullopt;
    const Node node = range(begin, after);
    return Extremes{node.low, node.high};
}

std::vector<History::Gap> History::gaps(Instant from, Instant to, Duration merge) const
{
    std::vector<Gap> found;
    const Micros stop = toMicros(to);
    auto first = breakFrom(std::max(search(toMicros(from)), Position{1})); // nothing is missing before the first sample
    while (first != m_breaks.end()) {
        const Micros begin = timeAt(previous(first->before));
        if (begin > stop)
            break;
        // A gap begins with the sample before its break, so the break at the limit itself still belongs to the group.
        const Position limit = search(begin + toMicros(Instant(merge)), first->before);
        const auto following = breakFrom(limit + 1);
        const auto last = std::prev(following);
        const std::uint64_t before = first == m_breaks.begin() ? 0 : std::prev(first)->lostSoFar;
        found.push_back({toInstant(begin), toInstant(timeAt(last->before)), last->lostSoFar - before});
        first = following;
    }
    return found;
}

std::size_t History::lowerBound(Instant from) const
{
    return indexOf(search(toMicros(from)));
}

std::size_t History::read(std::size_t index, Instant to, std::size_t most, std::vector<Point> &out) const
{
    out.clear();
    if (index >= m_size)
        return index;
    const Micros stop = toMicros(to);
    Position position = positionAt(index);
    auto gap = breakFrom(position);
    const Position after = end();
    for (std::size_t count = 0; count < most && position != after && timeAt(position) <= stop; ++count) {
        if (gap != m_breaks.end() && gap->before == position) {
            if (index > 0)
                out.push_back({toInstant(timeAt(previous(position)))});
            ++gap;
        }
        out.push_back(pointAt(position));
        position = next(position);
        ++index;
    }
    return index;
}

void History::include(Chunk &chunk, Position position, double value)
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

History::Position History::end() const
{
    return positionOf(m_chunks.size(), 0);
}

History::Position History::next(Position position) const
{
    const bool inside = placeOf(position) + 1 < m_chunks[chunkOf(position)]->count;
    return inside ? position + 1 : positionOf(chunkOf(position) + 1, 0);
}

History::Position History::previous(Position position) const
{
    if (placeOf(position) > 0)
        return position - 1;
    const std::size_t chunk = chunkOf(position) - 1;
    return positionOf(chunk, m_chunks[chunk]->count - 1);
}

std::size_t History::indexOf(Position position) const
{
    return position == end() ? m_size : m_chunks[chunkOf(position)]->firstIndex + placeOf(position);
}

History::Position History::positionAt(std::size_t index) const
{
    const auto after = std::partition_point(
        m_chunks.begin(), m_chunks.end(), [index](const auto &chunk) { return chunk->firstIndex <= index; });
    const auto chunk = static_cast<std::size_t>(after - m_chunks.begin()) - 1;
    return positionOf(chunk, static_cast<std::uint32_t>(index - m_chunks[chunk]->firstIndex));
}

History::Micros History::timeAt(Position position) const
{
    return m_starts[chunkOf(position)] + m_chunks[chunkOf(position)]->offsets[placeOf(position)];
}

Point History::pointAt(Position position) const
{
    return {toInstant(timeAt(position)), m_chunks[chunkOf(position)]->values[placeOf(position)]};
}

History::Position History::search(Micros time, Position from) const
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

History::Node History::range(Position from, Position to) const
{
    Node sum = Node::nothing();
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

void History::addPlaces(std::size_t number, std::uint32_t from, std::uint32_t to, Node &sum) const
{
    const Chunk &chunk = *m_chunks[number];
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
            const Position position = positionOf(number, place);
            sum.add({value, value, position, position});
            ++place;
        }
    }
}

void History::addChunks(std::size_t from, std::size_t to, Node &sum) const
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

History::BreakIterator History::breakFrom(Position position) const
{
    return std::partition_point(
        m_breaks.begin(), m_breaks.end(), [position](const Break &gap) { return gap.before < position; });
}

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
