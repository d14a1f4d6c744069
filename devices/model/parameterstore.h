// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/listeners.h"
#include "model/parameter.h"
#include "model/shared.h"

#include <vector>

namespace mb {

/// How far a value can be trusted, and whether it outlives the power.
enum class ParameterState : std::uint8_t {
    Unknown,  ///< never read
    Stored,   ///< read from the device, and nothing written since that flash may not have
    Ram,      ///< written and in force, not yet proved to be in flash
    Volatile, ///< in force; the device never keeps it
    Assumed,  ///< last written to a device that cannot be asked, or in force after a restart only
    Failed,   ///< the last read had no answer, or an error
};

[[nodiscard]] std::string_view toString(ParameterState state);

/// What is known of one device's parameters. Single-threaded.
class ParameterStore {
public:
    struct Entry {
        std::optional<std::int64_t> raw;
        ParameterState state = ParameterState::Unknown;
        /// Of what is newer in RAM: what flash has; nothing where that was never read. No device tells it.
        std::optional<std::int64_t> flash{};

        /// Of the same parameter once that is known of it.
        [[nodiscard]] Entry with(std::optional<std::int64_t> raw, ParameterState state) const;
    };

    explicit ParameterStore(std::span<const Parameter> table)
        : m_table(table)
        , m_entries(std::vector<Entry>(table.size()))
    {
    }

    [[nodiscard]] std::span<const Parameter> table() const { return m_table; }
    [[nodiscard]] const Parameter &parameter(ParameterIndex index) const { return m_table[index.value]; }
    [[nodiscard]] const Entry &entry(ParameterIndex index) const { return (*m_entries)[index.value]; }
    [[nodiscard]] std::span<const Entry> entries() const { return *m_entries; }
    /// The same object until one of them changes; for other threads.
    [[nodiscard]] const Shared<std::vector<Entry>> &sharedEntries() const { return m_entries.shared(); }

    void setRead(ParameterIndex index, std::int64_t raw);
    /// `now`: of what may be in RAM only.
    void setWritten(ParameterIndex index, std::int64_t raw, std::optional<Instant> now = {});
    /// When something became newer in RAM than in flash last.
    [[nodiscard]] std::optional<Instant> lastWrite() const { return m_lastWrite; }
    void setFailed(ParameterIndex index);
    /// What is in force is not known any more: Unknown, or Failed where an order had no answer.
    void forget(ParameterIndex index, ParameterState state = ParameterState::Unknown);
    /// The device proved that what was in RAM is in flash.
    void setAllStored();
    /// After a restart: volatile values are unknown again.
    void forgetVolatile();
    void forgetAll();

    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

private:
    void set(ParameterIndex index, std::optional<std::int64_t> raw, ParameterState state);
    void touch();

    std::span<const Parameter> m_table;
    Published<std::vector<Entry>> m_entries;
    std::optional<Instant> m_lastWrite;
    std::uint64_t m_revision = 0;
    Listeners<> m_changed;
};

/// Those that RAM has and flash perhaps not, in table order.
[[nodiscard]] std::vector<ParameterIndex> inRam(std::span<const ParameterStore::Entry> entries);

} // namespace mb
