// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/stage.h"

#include "app/console/simulationclock.h"

namespace mb::console {
namespace {

constexpr Duration leaseRenewal = std::chrono::milliseconds(100);

} // namespace

Stage::Stage(Console &console, const LinkAddress &link)
    : m_console(console)
{
    if (!link.isSimulated())
        return;
    m_clock = std::make_unique<SimulationClock>(console.clock());
    m_session = std::make_unique<Session>(*m_clock, console.families());
}

Stage::~Stage() = default;

Session &Stage::session()
{
    return m_session ? *m_session : m_console.session();
}

Task<Device *> Stage::find(Target target)
{
    if (!m_session) {
        auto connecting = connect(m_console, std::move(target));
        co_return co_await std::move(connecting).attempt();
    }
    auto connecting = m_session->connect(std::move(target.selector));
    co_return co_await std::move(connecting).attempt();
}

LeaseRenewal::LeaseRenewal(Clock &clock, SetPointStream &stream)
    : m_stream(stream)
    , m_timer(clock)
{
    renew();
}

void LeaseRenewal::renew()
{
    m_stream.renew();
    m_timer.startIn(leaseRenewal, [this] { renew(); });
}

} // namespace mb::console
