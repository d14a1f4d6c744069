// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatorflash.h"
#include "families/dmc60c/simulatorprocessor.h"

#include <string_view>

namespace mb::dmc60c::simulation {

/// The configuration of a unit, in RAM and in flash. A change goes to flash at once, or a while after the last one.
class ConfigMemory {
public:
    /// `note` tells of each write, with its sequence number. The processor, which does it, outlives this.
    ConfigMemory(Clock &clock, Processor &processor, const ConfigImage &factory,
        std::function<void(std::string_view, double)> note);

    [[nodiscard]] ConfigImage &ram() { return m_ram; }
    [[nodiscard]] const ConfigImage &ram() const { return m_ram; }
    /// After a start.
    void load() { m_ram = m_flash; }
    /// Something changed that is kept; `then` when that has been written, or will be.
    void changed(std::function<void()> then);
    /// What is in RAM is in flash now.
    void commit();
    /// A reset: what was to be written later is lost.
    void stop() { m_timer.stop(); }
    /// The next change is the first one.
    void forgetChange() { m_changedAt.reset(); }

private:
    void write(std::function<void()> then);

    Clock &m_clock;
    Processor &m_processor;
    ConfigImage m_flash;
    ConfigImage m_ram;
    std::function<void(std::string_view, double)> m_note;
    std::optional<Instant> m_changedAt;
    Timer m_timer;
};

} // namespace mb::dmc60c::simulation
