// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/firstsnapshots.h"
#include "app/engine/trials.h"

#include <map>
#include <string>

namespace mb {

/// Who came, who fell silent and who restarted since the last look. Engine thread.
class DevicePresence {
public:
    DevicePresence(
        const EngineContext &context, ParameterJobs &parameters, FirstSnapshots &firstSnapshots, Trials &trials)
        : m_context(context)
        , m_parameters(parameters)
        , m_firstSnapshots(firstSnapshots)
        , m_trials(trials)
    {
    }

    /// Once a second. Silence of a unit that is busy, such as during an update, is no news.
    void look();
    /// Once a second: the parameters of units that have restarted are read again.
    void refreshRestarted();

private:
    struct Presence {
        std::string name;
        bool heard = false; ///< it answered since it was found, or found again
        bool lost = false;  ///< and was told to have fallen silent
    };

    void hear(const Device &device, Presence &presence);

    EngineContext m_context;
    ParameterJobs &m_parameters;
    FirstSnapshots &m_firstSnapshots;
    Trials &m_trials;
    std::map<DeviceId, Presence> m_present;
};

} // namespace mb
