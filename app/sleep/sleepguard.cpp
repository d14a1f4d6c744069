// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sleep/sleepguard.h"

#include "model/session.h"

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr Duration lookEvery = std::chrono::milliseconds(100);

} // namespace

SleepGuard::SleepGuard(Session &session, Clock &clock, SleepInhibitor &inhibitor, std::function<bool()> also)
    : m_session(session)
    , m_inhibitor(inhibitor)
    , m_also(std::move(also))
    , m_look(clock)
{
    look();
}

SleepGuard::~SleepGuard()
{
    if (m_awake)
        m_inhibitor.keepAwake(false);
}

bool SleepGuard::isNeeded() const
{
    if (m_also && m_also())
        return true;
    const auto devices = m_session.devices();
    return std::ranges::any_of(devices, [this](Device *device) {
        const LinkAddress &link = device->link().address();
        if (link.isSimulated() || link.isRecording())
            return false;
        const SetPointStream &stream = m_session.stream(*device);
        const bool ours = stream.isRunning() || stream.end() != SetPointStream::End::None;
        return !device->gate().busy().empty() || stream.isRunning() || (ours && device->liveness().moving);
    });
}

void SleepGuard::look()
{
    if (const bool needed = isNeeded(); needed != m_awake) {
        m_awake = needed;
        m_inhibitor.keepAwake(needed);
    }
    m_look.startIn(lookEvery, [this] { look(); });
}

} // namespace mb
