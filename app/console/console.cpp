// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console.h"

#include "app/folders/userfolders.h"

namespace mb::console {

Console::Console(Clock &clock, std::span<const Family *const> families, Options options)
    : m_options(options)
    , m_output(clock)
    , m_session(clock, families, &m_guardian)
    , m_remarked(
          m_session.linkBook().remarked().add([this](const Link &, const Message &text) { note(text.english()); }))
    , m_memoryTrouble(m_session.memory().scanTrouble().add([this](const Message &text) { note(text.english()); }))
    , m_profileTrouble(m_session.memory().profileTrouble().add([](const Message &text) { complain(text.english()); }))
{
    m_session.keepHistoriesIn(nullptr); // it never looks back
    m_session.memory().keepProfiles(profileFolder());
    m_session.memory().keepScans(scanFolder());
}

void Console::note(std::string_view text) const
{
    if (!m_options.quiet)
        complain(text);
}

std::uint64_t Console::sentIn(const Session &session)
{
    std::uint64_t all = 0;
    for (const Link *link : session.links())
        all += link->counters().tx;
    return all;
}

int Console::fails(const Error &error) const
{
    const int status = exitStatusOf(error.fault, hasSent());
    tell(error, status, m_options);
    return status;
}

void tell(const Error &error, int status, const Options &options)
{
    if (options.json)
        complainPlain(jsonOf(error, status, options.verb));
    else
        complainAtLast(lineOf(error, options.verb));
}

void Console::interrupt()
{
    m_isInterrupted = true;
    m_interruptions.notify();
}

double secondsOf(Duration time)
{
    const auto whole = std::chrono::floor<std::chrono::seconds>(time);
    return static_cast<double>(whole.count()) + static_cast<double>((time - whole).count()) / 1e9;
}

TimeOrigin::TimeOrigin(const Clock &clock, const LinkAddress &link)
    : m_offset(link.isSimulated() ? -clock.now().time_since_epoch() : clock.unixOffset())
    , m_awake(link.isSimulated() ? nullptr : &clock)
    , m_slept(clock.slept())
{
}

} // namespace mb::console
