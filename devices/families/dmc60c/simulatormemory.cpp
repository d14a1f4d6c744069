// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatormemory.h"

#include <utility>

namespace mb::dmc60c::simulation {

ConfigMemory::ConfigMemory(
    Clock &clock, Processor &processor, const ConfigImage &factory, std::function<void(std::string_view, double)> note)
    : m_clock(clock)
    , m_processor(processor)
    , m_flash(factory)
    , m_ram(factory)
    , m_note(std::move(note))
    , m_timer(clock)
{
}

void ConfigMemory::changed(std::function<void()> then)
{
    const Instant now = m_clock.now();
    const bool quiet = !m_changedAt || now - *m_changedAt >= flashDelay;
    m_changedAt = now;
    if (quiet)
        return write(std::move(then));
    m_timer.startIn(flashDelay, [this] { write({}); });
    if (then)
        then();
}

void ConfigMemory::write(std::function<void()> then)
{
    m_processor.stall(writeTime, [this, then = std::move(then)] {
        commit();
        if (then)
            then();
    });
}

void ConfigMemory::commit()
{
    ++m_ram.sequence;
    m_flash = m_ram;
    m_note("config-flash", m_ram.sequence);
}

} // namespace mb::dmc60c::simulation
