// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/stage.h"

#include "app/console/pace.h"
#include "app/console/simulationclock.h"
#include "async/sleep.h"
#include "experiment/gains.h"

namespace mb::console {
Stage::Stage(Console &console, const LinkAddress &link)
    : m_console(console)
{
    if (!link.isSimulated())
        return;
    m_clock = std::make_unique<SimulationClock>(console.clock());
    m_session = std::make_unique<Session>(*m_clock, console.families());
}

Stage::~Stage()
{
    if (m_session)
        m_console.countSent(*m_session);
}

Task<Device *> Stage::find(Target target)
{
    Device *const device = co_await connectIn(m_console, session(), std::move(target));
    co_await needsApplication(*device);
    co_await Sleep(device->clock(), masterListen);
    m_console.onlyAsk(); // what an experiment refuses it refuses before it writes or moves; the rest is its result
    co_return device;
}

namespace {

/// What a window has a box for is an option here.
Error inWordsOfTheConsole(Error error)
{
    if (error.remedy == tuning::writeOrKeep())
        error.remedy = say("write the gains of this loop once, or give --keep");
    return error;
}

Task<int> performOnDevice(Console &console, Stage &stage, Target target, const Performance &performance)
{
    Device *const device = co_await stage.find(std::move(target));
    const Result<int> performed = co_await performance(stage.session(), *device).attempt();
    if (device->liveness().restarted) // more than the experiment knows of
        noteLost(console, *device);
    co_return performed;
}

} // namespace

Task<int> performOn(Console &console, Target target, Performance performance)
{
    const Subscription patient = console.interrupted().add([] {});
    Stage stage(console, target.selector.link);
    const Result<int> performed = co_await performOnDevice(console, stage, std::move(target), performance).attempt();
    co_await Sleep(console.clock(), Duration::zero()); // a session is never ended from inside its own work
    if (!performed)
        co_return fail(inWordsOfTheConsole(performed.error()));
    co_return performed;
}

Error putsNothingBack(const Error &trouble)
{
    return {Fault::Usage, say("nothing could put the gains back after a crash: %1", trouble.detail),
        trouble.help().empty() ? say("see to its rights, or --keep what is tried") : trouble.help()};
}

Experimenting::Experimenting(Console &console, Session &session, Device &device, Notebook &notebook, int axis)
    : m_console(console)
    , m_notebook(notebook)
    , m_stream(session.stream(device))
    , m_renewal(session.clock(), [this] { m_stream.renew(); })
{
    notebook.noteTrouble();
    if (const double lag = notebook.lagOf(device, axis); lag > 0.0)
        m_directions.setLag(device.selector(), axis, lag);
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
