// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/parameterjobs.h"

#include <map>
#include <string>

namespace mb {

/// The snapshot of every unit when it is found, once, as soon as it has told who it is and nothing else works on it. Engine thread.
class FirstSnapshots {
public:
    FirstSnapshots(const EngineContext &context, const ParameterJobs &parameters, ProvisionalChanges &provisional)
        : m_context(context)
        , m_parameters(parameters)
        , m_provisional(provisional)
    {
    }

    /// Once a second.
    void look();
    /// What it has may not be what it was found with: it is met again.
    void forget(DeviceId device) { m_met.erase(device); }

private:
    [[nodiscard]] bool isReady(const Device &device) const;
    void met(const Operations::Job &job, const Result<settings::ParameterSnapshot> &taken);

    EngineContext m_context;
    const ParameterJobs &m_parameters;
    ProvisionalChanges &m_provisional;
    std::map<DeviceId, std::string> m_met; ///< who they were
};

} // namespace mb
