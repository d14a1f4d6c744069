// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"
#include "async/noncopyable.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace mb {

/// Where recordings go beyond their memory budget: a file without a name that is mapped into memory, so that the kernel
/// writes old chunks to disk and fetches them when somebody scrolls back. The file is gone when the process is, however
/// it ends. Shared by all histories of a session; thread-safe.
class ChunkStore : NonCopyable {
public:
    /// `folder` must exist and should be on a disk, not in memory. `budget`: bytes of chunks that may stay in memory. `spared`: bytes
    /// of the disk that are left to others.
    ChunkStore(std::string folder, std::size_t budget, std::uint64_t spared = 1ULL << 30U);
    ~ChunkStore();

    [[nodiscard]] std::size_t budget() const { return m_budget; }
    /// Chunks in memory, as their histories report it.
    [[nodiscard]] std::size_t resident() const { return m_resident.load(std::memory_order_relaxed); }
    void grow(std::size_t bytes) { m_resident.fetch_add(bytes, std::memory_order_relaxed); }
    void shrink(std::size_t bytes) { m_resident.fetch_sub(bytes, std::memory_order_relaxed); }
    [[nodiscard]] bool isOverBudget() const { return resident() > m_budget; }

    /// Room for `bytes` in the file, aligned for anything; always the same size. nullptr when there is no room or no
    /// file: the chunk then stays in memory, and failure() says why.
    [[nodiscard]] void *take(std::size_t bytes);
    void giveBack(void *room);
    /// Bytes of the file that are in use.
    [[nodiscard]] std::size_t stored() const;
    /// Why the file cannot grow, in English; empty while all is well.
    [[nodiscard]] Message failure() const;

private:
    [[nodiscard]] bool extend(std::size_t bytes);
    [[nodiscard]] bool openFile();

    std::string m_folder;
    std::size_t m_budget;
    std::uint64_t m_spared;
    std::atomic<std::size_t> m_resident{0};
    mutable std::mutex m_mutex; ///< guards the rest
    int m_file = -1;
    std::size_t m_fileSize = 0;
    std::size_t m_room = 0; ///< bytes of each
    std::vector<std::pair<void *, std::size_t>> m_extents;
    std::vector<void *> m_free;
    Message m_failure;
};

} // namespace mb
