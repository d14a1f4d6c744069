// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/listeners.h"
#include "families/abstractdc/logsense.h"
#include "families/abstractdc/powercycledebt.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mb::abstractdc {

/// Writes the settings of one drive and saves them, a loop at a time. The drive can be asked for none and acknowledges nothing;
/// each save uses up a part of a page, and is counted (README.md#saves). Engine thread; outlives its tasks.
class SettingsDesk {
public:
    /// `count` writes DeviceProfile::counters. All outlive this.
    SettingsDesk(Device &device, CanLink &link, const LogSense &logs, PowerCycleDebt &debt,
        std::function<void(const std::string &key, std::int64_t value)> count);

    /// Ends when the drive answers a question that was sent behind the order, which is all that can be known; or Timeout.
    [[nodiscard]] Task<void> expectAnswer();
    /// Unsafe, OutOfRange: this value cannot be written now.
    [[nodiscard]] Result<void> mayWrite(const Parameter &parameter, std::int64_t raw) const;
    /// Yields what was sent. Whoever calls it has asked mayWrite().
    [[nodiscard]] Task<std::int64_t> write(const Parameter &parameter, std::int64_t raw);
    /// Saves the loops that were written since their last save; Device::store().
    [[nodiscard]] Task<bool> store(Progress &progress);
    /// The settings pages are blank, or another drive's (`fresh`), or hold what this program did not write.
    void replaced(bool fresh);
    /// Somebody wrote it, and it is not in flash.
    void written(ParameterIndex index, std::int64_t raw);
    /// Somebody else saved this loop.
    void saved(Loop loop);
    /// The drive has begun anew: what was not saved is not in force any more.
    void restarted();
    /// What was sent and may be in force, although no answer has proved it yet.
    [[nodiscard]] std::span<const ParameterChange> unproven() const
    {
        return *m_unproven ? std::span(&**m_unproven, 1) : std::span<const ParameterChange>();
    }
    /// The averaging in force is none of 1 … 500 (somebody else wrote it), and so it is when the drive begins anew.
    [[nodiscard]] bool overrunsEver() const;
    /// How often each loop was saved since its page was erased, for Identity::descriptors.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> saves() const;

private:
    [[nodiscard]] Task<void> owe(const Parameter &parameter, std::int64_t raw);
    [[nodiscard]] bool mayOverrun(std::int64_t averaging) const;
    [[nodiscard]] std::int64_t savesOf(Loop loop) const;
    /// How often it was saved before; Unsafe where one more is too many.
    [[nodiscard]] Result<std::int64_t> maySave(Loop loop) const;
    [[nodiscard]] Task<void> save(Loop loop, Progress &progress);
    void settle(Loop loop);
    /// In the order of the table.
    [[nodiscard]] std::vector<ParameterIndex> unsaved() const;
    [[nodiscard]] bool isUnsaved(ParameterIndex index) const;
    void setUnsaved(ParameterIndex index, bool unsaved);

    Device &m_device;
    CanLink &m_can;
    const LogSense &m_logs;
    PowerCycleDebt &m_debt;
    std::function<void(const std::string &, std::int64_t)> m_count;
    std::shared_ptr<std::optional<ParameterChange>> m_unproven
        = std::make_shared<std::optional<ParameterChange>>(); ///< an order may outlive this
    std::optional<std::int64_t> m_averaging;                  ///< written last, by anybody, since this run began
    Subscription m_exchanged;
};

} // namespace mb::abstractdc
