// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/debts.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

namespace mb::guardian {
namespace {

constexpr std::size_t largestBook = 1U << 20U;

/// Names of lines have slashes; all that matters is that another line has another name (FNV-1a).
std::string fileName(std::string_view line)
{
    std::uint64_t hash = 14695981039346656037U;
    for (const char letter : line)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

template <class T> void put(Bytes &bytes, T value)
{
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof value);
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

template <class T> bool take(std::span<const std::uint8_t> &rest, T &value)
{
    if (rest.size() < sizeof value)
        return false;
    std::memcpy(&value, rest.data(), sizeof value);
    rest = rest.subspan(sizeof value);
    return true;
}

bool isOurs(const std::string &folder)
{
    struct stat state { };
    return ::lstat(folder.c_str(), &state) == 0 && S_ISDIR(state.st_mode) && state.st_uid == ::geteuid()
        && (state.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

/// A login may have left its name behind, or it is that of somebody else (sudo -E).
bool isOurRuntimeFolder(const char *path)
{
    struct stat state { };
    return ::stat(path, &state) == 0 && S_ISDIR(state.st_mode) && state.st_uid == ::geteuid()
        && ::access(path, W_OK | X_OK) == 0;
}

/// Of one process at a time, for as long as it lives; a process that was stopped while it has it is not waited for.
class Turn {
public:
    explicit Turn(const std::string &path)
        : m_file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600))
    {
        for (int tries = 0; m_file >= 0 && ::flock(m_file, LOCK_EX | LOCK_NB) != 0 && tries < 50; ++tries)
            ::usleep(1000);
    }
    Turn(const Turn &) = delete;
    Turn &operator=(const Turn &) = delete;
    ~Turn()
    {
        if (m_file >= 0)
            ::close(m_file);
    }

private:
    int m_file;
};

} // namespace

std::string_view unitOf(std::string_view name)
{
    return name.substr(name.rfind('/') + 1);
}

std::chrono::milliseconds runTime()
{
    timespec time{};
    ::clock_gettime(CLOCK_BOOTTIME, &time);
    return std::chrono::seconds(time.tv_sec)
        + std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::nanoseconds(time.tv_nsec));
}

std::string debtFolder()
{
    if (const char *runtime = std::getenv("XDG_RUNTIME_DIR"); runtime && isOurRuntimeFolder(runtime))
        return std::string(runtime) + "/motorbench";
    return P_tmpdir "/motorbench-" + std::to_string(::geteuid());
}

DebtBook::DebtBook(std::string folder, std::string_view line)
    : m_folder(std::move(folder))
    , m_path(m_folder + '/' + fileName(line))
{
}

DebtBook::~DebtBook()
{
    disown();
}

DebtBook::Claim DebtBook::claim()
{
    struct stat held { };
    if (m_lock >= 0 && ::fstat(m_lock, &held) == 0 && held.st_nlink > 0)
        return Claim::Mine;
    disown(); // nobody else finds a file that was removed
    ::mkdir(m_folder.c_str(), 0700);
    if (!isOurs(m_folder))
        return Claim::Unusable;
    m_lock = ::open((m_path + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (m_lock < 0)
        return Claim::Unusable;
    if (::flock(m_lock, LOCK_EX | LOCK_NB) == 0)
        return Claim::Mine;
    const bool isTaken = errno == EWOULDBLOCK;
    disown();
    return isTaken ? Claim::Others : Claim::Unusable;
}

void DebtBook::disown()
{
    if (m_lock >= 0)
        ::close(m_lock);
    m_lock = -1;
}

bool DebtBook::exists() const
{
    return ::access((m_path + ".stops").c_str(), F_OK) == 0;
}

/// The file that gives turns stays for as long as its folder does.
bool DebtBook::isSettled() const
{
    return !exists() && isOurs(m_folder) && ::access((m_path + ".turn").c_str(), F_OK) == 0;
}

std::vector<Debt> DebtBook::read() const
{
    std::vector<Debt> debts;
    Bytes bytes;
    if (!isOurs(m_folder))
        return debts;
    const int file = ::open((m_path + ".stops").c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0)
        return debts;
    std::array<std::uint8_t, 4096> part{};
    for (ssize_t got = 1; got > 0 && bytes.size() < largestBook;) {
        got = ::read(file, part.data(), part.size());
        bytes.insert(bytes.end(), part.begin(), part.begin() + std::max<ssize_t>(got, 0));
    }
    ::close(file);
    std::span<const std::uint8_t> rest(bytes);
    std::chrono::milliseconds since{};
    std::uint32_t size = 0;
    while (take(rest, since) && take(rest, size) && size <= rest.size()) {
        const auto order = decodeOrder(rest.first(size));
        rest = rest.subspan(size);
        if (order && order->kind == Order::Kind::Watch)
            debts.push_back({order->name, order->script, since});
    }
    return debts;
}

/// A new file in place of the old one, so that nobody reads half of it.
bool DebtBook::write(const std::vector<Debt> &debts) const
{
    if (debts.empty())
        return ::unlink((m_path + ".stops").c_str()) == 0;
    Bytes bytes;
    for (const Debt &debt : debts) {
        const Bytes packet = encode(Order{Order::Kind::Watch, 0, debt.name, debt.script});
        put(bytes, debt.since);
        put(bytes, static_cast<std::uint32_t>(packet.size()));
        bytes.insert(bytes.end(), packet.begin(), packet.end());
    }
    const std::string fresh = m_path + ".new" + std::to_string(::gettid());
    const int file = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (file < 0)
        return false;
    const bool whole = ::write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
    ::close(file);
    if (whole && ::rename(fresh.c_str(), (m_path + ".stops").c_str()) == 0)
        return true;
    ::unlink(fresh.c_str());
    return false;
}

bool DebtBook::change(const std::function<void(std::vector<Debt> &)> &with) const
{
    const Turn turn(m_path + ".turn");
    const std::vector<Debt> before = read();
    std::vector<Debt> debts = before;
    with(debts);
    return debts.empty() && before.empty() ? true : write(debts);
}

bool DebtBook::add(const Debt &debt)
{
    ::mkdir(m_folder.c_str(), 0700);
    if (!isOurs(m_folder))
        return false;
    return change([&debt](std::vector<Debt> &debts) {
        std::erase_if(debts, [&debt](const Debt &known) { return unitOf(known.name) == unitOf(debt.name); });
        debts.push_back(debt);
    });
}

void DebtBook::remove(std::string_view name)
{
    if (exists())
        (void)change([name](std::vector<Debt> &debts) {
            std::erase_if(debts, [name](const Debt &known) { return unitOf(known.name) == unitOf(name); });
        });
}

} // namespace mb::guardian
