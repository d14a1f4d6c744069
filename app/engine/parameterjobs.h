// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/provisionalchanges.h"
#include "model/heardsince.h"
#include "settings/settingslog.h"
#include "settings/writing.h"
#include "widgets/orders/parameterorders.h"
#include "widgets/orders/settingsorders.h"

#include <map>
#include <memory>

namespace mb {

/// Reading, writing and storing parameters, and taking back what was written. What is kept of a place, not of a unit, is put back by
/// the second such order while the unit is heard; the first is Unsafe. Engine thread.
class ParameterJobs {
public:
    ParameterJobs(const EngineContext &context, ProvisionalChanges &provisional)
        : m_context(context)
        , m_provisional(provisional)
    {
    }

    /// From now on snapshots are kept and every write is in the history. The log outlives this.
    void setLog(settings::SettingsLog *log) { m_settings = log; }
    [[nodiscard]] settings::SettingsLog *log() const { return m_settings; }
    /// A snapshot before something that changes much. Where it cannot be kept that fails, and nothing may be written; a unit that does
    /// not tell its values is a line of the log.
    [[nodiscard]] Task<void> keepBefore(Device &device, settings::Occasion occasion, Progress &progress) const;

    void carryOut(const orders::ReadParameters &order, const Finished &finished);
    void carryOut(const orders::WriteParameters &order, const Finished &finished);
    void carryOut(const orders::StoreParameters &order, const Finished &finished);
    void carryOut(const orders::RewriteSettings &order, const Finished &finished);
    void carryOut(const orders::RestoreParameters &order, const Finished &finished);
    void carryOut(const orders::UndoWrite &order, const Finished &finished);
    void carryOut(const orders::TakeSnapshot &order, const Finished &finished);

private:
    [[nodiscard]] Result<void> tellRead(
        Operations::Job &job, const Result<std::vector<TransferOutcome>> &outcomes) const;
    void write(
        DeviceId device, std::vector<ParameterChange> changes, settings::Purpose purpose, const Finished &finished);
    [[nodiscard]] Task<std::vector<TransferOutcome>> writeWhole(
        Device &device, std::vector<ParameterChange> changes, settings::Purpose purpose, Progress &progress);
    [[nodiscard]] Task<settings::SettingsChange> takeBack(Device &device, bool again, Progress &progress);
    [[nodiscard]] Task<void> askWhose(Device &device);
    [[nodiscard]] settings::Begun begins(const Device &device);
    [[nodiscard]] Result<void> tellWritten(DeviceId device, const std::vector<ParameterStore::Entry> &before,
        const Result<std::vector<TransferOutcome>> &outcomes) const;

    EngineContext m_context;
    ProvisionalChanges &m_provisional;
    settings::SettingsLog *m_settings = nullptr;
    std::map<DeviceId, std::unique_ptr<HeardSince>> m_consents; ///< what is kept of its place is of this unit
};

} // namespace mb
