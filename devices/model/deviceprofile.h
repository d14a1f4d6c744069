// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace mb {

/// What a check of the direction of motor and sensor found out.
enum class DirectionVerdict { Foreign, Agrees, Reversed, NoMotion }; ///< Foreign: the word of another version

/// Its word in the file.
[[nodiscard]] std::string_view toString(DirectionVerdict verdict);

/// What this program keeps of one device because the device cannot tell it: what its user knows, and what was last written to
/// settings that cannot be read back. Keys are those of the family's tables.
struct DeviceProfile {
    std::string dialect;                         ///< chosen by the user; empty: as the scan finds it
    std::map<std::string, double> calibration;   ///< of Family::calibrations; what is missing is unknown
    std::map<std::string, std::int64_t> written; ///< raw values, by parameter key
    std::set<std::string> lost; ///< keys of `written` that a reset has taken from the device since they were written
    std::map<std::string, std::int64_t> counters;     ///< what a family counts over the life of the device
    std::map<std::string, DirectionVerdict> verdicts; ///< by directionKey(); for people to see
    std::string foreign; ///< JSON of what the file had beyond that: fields and words of another version, which are kept

    [[nodiscard]] double calibrated(std::string_view key, double unknown = 0.0) const
    {
        const auto found = calibration.find(std::string(key));
        return found == calibration.end() ? unknown : found->second;
    }
    [[nodiscard]] bool isEmpty() const { return *this == DeviceProfile(); }
    friend bool operator==(const DeviceProfile &, const DeviceProfile &) = default;
};

/// Of an axis from 1 on, 0 where the device has one: "direction", "ch1.direction".
[[nodiscard]] std::string directionKey(int axis);

/// The name of a file about what this text names: readable, and different for different texts.
[[nodiscard]] std::string fileNameOf(std::string_view text, std::string_view ending = ".json");

/// The profiles of all devices as JSON files of one directory, one a device, named after its key (unit.h). The directory is made
/// when the first one is saved.
class ProfileBook {
public:
    explicit ProfileBook(std::string directory)
        : m_directory(std::move(directory))
    {
    }
    /// An empty profile when there is none yet. A file that is none is put aside as `NAME.damaged` and told: OutOfRange.
    [[nodiscard]] Result<DeviceProfile> load(std::string_view key) const;
    /// Writes the whole file or nothing; an empty profile is written too.
    [[nodiscard]] Result<void> save(std::string_view key, const DeviceProfile &profile) const;
    [[nodiscard]] std::string pathOf(std::string_view key) const;

private:
    std::string m_directory;
};

} // namespace mb
