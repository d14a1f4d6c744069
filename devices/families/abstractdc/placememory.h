// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/entryspeed.h"
#include "model/deviceprofile.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace mb::abstractdc {

/// Where a drive was seen to stand last and where its velocity loop passed last, kept in its profile: a drive that another run of
/// this program finds there has neither restarted nor been moved (README.md#restarts, README.md#first-pass). Engine thread.
class PlaceMemory {
public:
    using Counters = std::map<std::string, std::int64_t>;

    /// `count` writes DeviceProfile::counters, and the profile to the disk; the profile outlives this.
    PlaceMemory(const DeviceProfile &profile, std::function<void(const Counters &values)> count);

    /// Counts; nothing where nobody knows, and where a drive that was just switched on may be, too.
    [[nodiscard]] std::optional<std::int64_t> place() const;
    /// The last pass of a drive that is found at `position`; nothing where it may have moved since.
    [[nodiscard]] std::optional<EntrySpeed::Seen> passed(std::int32_t position, Instant now) const;
    /// It stands there.
    void stands(std::int32_t position, const std::optional<EntrySpeed::Seen> &passed);

private:
    [[nodiscard]] std::int64_t counted(std::string_view key) const;

    const DeviceProfile &m_profile;
    std::function<void(const Counters &)> m_count;
};

} // namespace mb::abstractdc
