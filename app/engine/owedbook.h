// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/operations.h"
#include "experiment/owedgains.h"
#include "widgets/orders/trialorders.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace mb {

/// Gains that experiments before have changed in units that are here, and that nobody has put back for certain. Engine thread.
class OwedBook {
public:
    explicit OwedBook(const EngineContext &context)
        : m_context(context)
        , m_asking(context.clock)
    {
    }

    /// From now on what trials owe is looked up there. Outlives this.
    void setJournal(tuning::ExperimentJournal *journal) { m_journal = journal; }
    /// Once a second: each unit is looked up once, when it has told who it is.
    void look();
    /// An experiment on it has ended: what it could not put back is offered, and what it put back into a unit that stores later is proved
    /// then.
    void ended(DeviceId device);
    [[nodiscard]] const std::map<DeviceId, std::vector<tuning::OwedGains>> &owed() const { return m_owed; }

    void carryOut(const orders::PayGains &order, const Finished &finished);
    void carryOut(const orders::DismissGains &order, const Finished &finished);

private:
    void lookUp(const Device &device);
    void lookAgain(DeviceId device);
    void notAnswered(DeviceId device, const Error &error);
    void compare(DeviceId device, const std::string &unit);
    void end(DeviceId device, std::int64_t trial);

    EngineContext m_context;
    tuning::ExperimentJournal *m_journal = nullptr;
    std::map<DeviceId, std::string> m_lookedFor; ///< units that were looked up, and who they were
    std::map<DeviceId, Instant> m_lookAgain;     ///< when what was put back must be stored, or the notebook may answer
    std::set<DeviceId> m_told;                   ///< that the notebook does not answer
    std::map<DeviceId, std::vector<tuning::OwedGains>> m_owed;
    Scope m_asking; ///< last: what it asks uses everything above
};

} // namespace mb
