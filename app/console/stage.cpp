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
    return connectIn(m_console, session(), std::move(target));
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

Experimenting::Experimenting(Console &console, Session &session, Device &device, Notebook &notebook)
    : m_console(console)
    , m_notebook(notebook)
    , m_stream(session.stream(device))
    , m_renewal(session.clock(), m_stream)
{
    if (console.isInterrupted())
        m_interruption.interrupt();
    m_signal = console.interrupted().add([this] { m_interruption.interrupt(); });
}

tuning::ExperimentSurroundings Experimenting::surroundings()
{
    tuning::ExperimentSurroundings surroundings;
    surroundings.journal = m_notebook.book();
    surroundings.directions = &m_directions;
    surroundings.interruption = &m_interruption;
    surroundings.note = [this](const Message &text) { m_console.note(text.english()); };
    return surroundings;
}

} // namespace mb::console
