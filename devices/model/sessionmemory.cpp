// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sessionmemory.h"

#include "async/event.h"
#include "files/qttext.h"
#include "model/family.h"
#include "model/identity.h"
#include "model/unit.h"

#include <QFile>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr Duration saveAgain = std::chrono::seconds(10);
constexpr Duration longestSave = std::chrono::seconds(10);

/// Simulated devices are factory-fresh in every process, and a recording has its own.
bool isKept(const Link &link)
{
    return !link.address().isSimulated() && !link.address().isRecording();
}

/// Of the place: a profile is asked for before a unit has told its serial number. The name of a link may be another adapter's tomorrow.
std::string keyOf(const Device &device)
{
    Identity place = device.identity();
    place.serial.clear();
    const std::string selector = device.selector();
    return unitKeyOf(place, device.link().line(), false)
        .append(partsOf(selector).session); // of one of several with one number
}

/// What an earlier build kept under the name of the link, where nothing is kept of the place. Taken over once: another adapter may have
/// that name tomorrow.
Result<DeviceProfile> keptOf(const ProfileBook &book, const Device &device, const std::string &key)
{
    if (QFile::exists(qt(book.pathOf(key))))
        return book.load(key);
    auto earlier = book.load(device.selector());
    if (!earlier || earlier->isEmpty())
        return earlier;
    MB_TRY_VOID(book.save(key, *earlier));
    const QString path = qt(book.pathOf(device.selector()));
    QFile::remove(path + QStringLiteral(".moved"));
    if (QFile::rename(path, path + QStringLiteral(".moved")))
        return earlier;
    MB_TRY_VOID(book.save(device.selector(), {}));
    return earlier;
}

/// Whoever answered takes the place of what was known under its address; a complete scan takes the place of all.
Result<void> rememberIn(const ScanBook &book, const std::string &link, std::vector<Identity> found, bool complete)
{
    auto known = book.load(link);
    std::vector<Identity> all = complete || !known ? std::vector<Identity>() : std::move(*known);
    for (Identity &identity : found) {
        std::erase_if(all, [&identity](const Identity &other) {
            return other.family == identity.family && other.address == identity.address;
        });
        all.push_back(std::move(identity));
    }
    return book.save(link, all);
}

} // namespace

SessionMemory::SessionMemory(Clock &clock)
    : m_clock(clock)
    , m_again(clock)
{
}

void SessionMemory::recall(Device &device)
{
    if (!m_profiles || !isKept(device.link()))
        return;
    const std::string key = keyOf(device);
    if (const auto unsaved = m_unsaved.find(key); unsaved != m_unsaved.end()) {
        device.knowledge().setProfile(unsaved->second.profile);
        return;
    }
    auto profile = keptOf(*m_profiles, device, key);
    if (!profile)
        m_profileTrouble.notify(profile.error().message());
    else if (!profile->isEmpty())
        device.knowledge().setProfile(std::move(*profile));
}

/// Until it is on the disk it is read from here.
void SessionMemory::keep(const Device &device)
{
    if (!m_profiles || !isKept(device.link()))
        return;
    const std::string key = keyOf(device);
    m_unsaved[key].profile = device.knowledge().profile();
    save(key, true);
}

/// In the order in which they were given.
void SessionMemory::save(const std::string &key, bool tells)
{
    UnsavedProfile &unsaved = m_unsaved[key];
    ++unsaved.writes;
    const auto kept = std::make_shared<Result<void>>();
    write(
        m_profiles->pathOf(key),
        [book = *m_profiles, key, profile = unsaved.profile, kept] { *kept = book.save(key, profile); },
        [this, key, tells, kept] {
            if (!*kept && tells)
                m_profileTrouble.notify(kept->error().message());
            saved(key, *kept);
        });
}

void SessionMemory::saved(const std::string &key, const Result<void> &kept)
{
    UnsavedProfile &unsaved = m_unsaved.at(key);
    unsaved.kept = kept;
    if (--unsaved.writes > 0)
        return;
    if (kept)
        m_unsaved.erase(key);
    else
        m_again.startIn(saveAgain, [this] { saveUnsaved(); });
    m_saved.notify();
}

/// Without a word: that it is not kept was told.
void SessionMemory::saveUnsaved()
{
    for (const auto &[key, unsaved] : std::map(m_unsaved)) {
        if (unsaved.writes == 0)
            save(key, false);
    }
}

Task<void> SessionMemory::kept(const Device &device)
{
    const std::string key = keyOf(device);
    if (const auto unsaved = m_unsaved.find(key); unsaved != m_unsaved.end() && unsaved->second.writes == 0)
        save(key, false);
    Event settled;
    const auto look = [this, &settled, key] {
        const auto unsaved = m_unsaved.find(key);
        if (unsaved == m_unsaved.end() || unsaved->second.writes == 0)
            settled.set();
    };
    const Subscription saving = m_saved.add(look);
    Timer late(m_clock);
    late.startIn(longestSave, [&settled] { settled.set(); });
    look();
    co_await settled.wait();
    const auto unsaved = m_unsaved.find(key);
    if (unsaved == m_unsaved.end())
        co_return {};
    if (unsaved->second.writes > 0)
        co_return fail(Fault::NotKept, say("this takes too long"));
    Error trouble = unsaved->second.kept.error();
    trouble.fault = Fault::NotKept;
    co_return fail(std::move(trouble));
}

/// `done` only while this is here.
void SessionMemory::write(const std::string &file, const std::function<void()> &work, const std::function<void()> &done)
{
    if (m_background) {
        m_background->run(file, work, [self = std::weak_ptr(m_self), done] {
            if (self.lock())
                done();
        });
        return;
    }
    work();
    done();
}

void SessionMemory::tellScanTrouble(const std::string &link, const Error &error)
{
    if (m_told.insert(link + error.text()).second)
        m_scanTrouble.notify(error.message());
}

std::vector<Identity> SessionMemory::seenOn(const Link &link, const Family &family)
{
    if (!m_scans || !family.probe || !isKept(link))
        return {};
    auto all = m_scans->load(link.address().text());
    if (!all) {
        tellScanTrouble(link.address().text(), all.error());
        return {};
    }
    std::erase_if(*all, [&family](const Identity &identity) { return identity.family != family.key; });
    return std::move(*all);
}

void SessionMemory::remember(const Link &link, const std::vector<Device *> &seen, bool complete)
{
    if (!m_scans || !isKept(link))
        return;
    std::vector<Identity> found;
    for (const Device *device : seen) {
        if (device->family().probe)
            found.push_back(device->identity());
    }
    if (found.empty())
        return;
    const std::string key = link.address().text();
    const auto trouble = std::make_shared<Result<void>>();
    write(
        m_scans->pathOf(key),
        [book = *m_scans, key, found, complete, trouble] { *trouble = rememberIn(book, key, found, complete); },
        [this, key, trouble] {
            if (!*trouble)
                tellScanTrouble(key, trouble->error());
        });
}

} // namespace mb
