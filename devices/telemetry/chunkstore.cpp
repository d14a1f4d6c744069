// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/chunkstore.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr std::size_t roomsPerExtent = 64;
constexpr std::size_t alignment = 64;

std::size_t roundedUp(std::size_t bytes, std::size_t step)
{
    return (bytes + step - 1) / step * step;
}

} // namespace

ChunkStore::ChunkStore(std::string folder, std::size_t budget, std::uint64_t spared)
    : m_folder(std::move(folder))
    , m_budget(budget)
    , m_spared(spared)
{
}

ChunkStore::~ChunkStore()
{
    for (const auto &[address, size] : m_extents)
        ::munmap(address, size);
    if (m_file >= 0)
        ::close(m_file);
}

bool ChunkStore::openFile()
{
    if (m_file >= 0)
        return true;
    m_file = ::open(m_folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (m_file < 0) { // a file system that knows no unnamed files
        std::string name = m_folder + "/history-XXXXXX";
        m_file = ::mkostemp(name.data(), O_CLOEXEC);
        if (m_file >= 0)
            ::unlink(name.c_str());
    }
    if (m_file < 0)
        m_failure = say("%1 cannot take old samples: %2", m_folder, std::strerror(errno));
    return m_file >= 0;
}

bool ChunkStore::extend(std::size_t bytes)
{
    if (!openFile())
        return false;
    const std::size_t room = roundedUp(bytes, alignment);
    m_room = room;
    const std::size_t size = roundedUp(room * roomsPerExtent, static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)));
    struct statvfs disk { };
    if (::fstatvfs(m_file, &disk) == 0 && disk.f_bavail * disk.f_frsize < size + m_spared) {
        m_failure = say("%1 cannot take old samples: %2", m_folder, say("the rest of its disk is left to others"));
        return false;
    }
    // Allocated at once: a hole that cannot be filled later would end the program at a write.
    const int error = ::posix_fallocate(m_file, static_cast<off_t>(m_fileSize), static_cast<off_t>(size));
    void *address = error == 0
        ? ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, m_file, static_cast<off_t>(m_fileSize))
        : MAP_FAILED;
    if (address == MAP_FAILED) {
        m_failure = say("%1 cannot take old samples: %2", m_folder, std::strerror(error != 0 ? error : errno));
        return false;
    }
    m_failure = {};
    m_fileSize += size;
    m_extents.emplace_back(address, size);
    for (std::size_t i = roomsPerExtent; i > 0; --i) // the first room is taken first
        m_free.push_back(static_cast<std::byte *>(address) + (i - 1) * room);
    return true;
}

void *ChunkStore::take(std::size_t bytes)
{
    const std::lock_guard lock(m_mutex);
    if (m_free.empty() && !extend(bytes))
        return nullptr;
    void *room = m_free.back();
    m_free.pop_back();
    return room;
}

void ChunkStore::giveBack(void *room)
{
    const std::lock_guard lock(m_mutex);
    m_free.push_back(room);
}

std::size_t ChunkStore::stored() const
{
    const std::lock_guard lock(m_mutex);
    return (m_extents.size() * roomsPerExtent - m_free.size()) * m_room;
}

Message ChunkStore::failure() const
{
    const std::lock_guard lock(m_mutex);
    return m_failure;
}

} // namespace mb
