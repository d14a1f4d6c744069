// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"
#include "model/parametertransfer.h"

#include <QByteArray>
#include <QJsonObject>

namespace mb {

struct Family;

/// What a parameter file is made from and compared with: a device, or its copy in a snapshot. For one call only.
struct ParameterSource {
    const Family &family;
    const Identity &identity;
    std::string selector;
    std::span<const ParameterStore::Entry> entries; ///< in table order
};
[[nodiscard]] ParameterSource sourceOf(const Device &device);

/// The object of `motorbenchctl get`, which is also the file format: {"device","family","serial","firmware","parameters"}.
[[nodiscard]] QJsonObject parametersToJson(const ParameterSource &source, std::span<const ParameterIndex> indices);
[[nodiscard]] QJsonObject parametersToJson(const Device &device, std::span<const ParameterIndex> indices);
/// One value as {"value","raw","unit","state"}; null when unknown.
[[nodiscard]] QJsonObject parameterToJson(const Parameter &parameter, const ParameterStore::Entry &entry);

struct ParameterFile {
    std::string family;
    std::string device;
    std::string serial;
    std::string firmware;
    std::vector<ParameterChange> values; ///< in table order
    std::vector<Message> notes;          ///< rows that were left out and why: their values are unknown
};

/// The family that the file says it is for; nothing when it is no such file.
[[nodiscard]] std::optional<std::string> familyOf(const QByteArray &bytes);
/// OutOfRange with one clear cause: not JSON, another family, an unknown key, a value out of range, `value` and `raw` of one row that say
/// different things. Nothing is half taken.
[[nodiscard]] Result<ParameterFile> parseParameterFile(const QByteArray &bytes, const Family &family);

struct ParameterDifference {
    ParameterIndex index;
    std::optional<std::int64_t> from; ///< in the device, when known
    std::int64_t to = 0;
    bool ofAnotherUnit = false; ///< belongs to the unit that the file was saved from, which this one is not known to be
};

/// The file was saved from the very unit, as the serial numbers of both say.
[[nodiscard]] bool isOfSameUnit(const ParameterSource &source, const ParameterFile &file);

/// What `restore` writes: keys that can be written, are persistent and are settings, and differ from what is known, and
/// those that cannot be read (Access::WriteOnly), whatever is assumed of them: another unit may answer by now.
/// Of a device that keeps nothing without power (Capabilities::keepsSettings) every setting. What is `ofAnotherUnit` is in
/// it, to be told; it is written only when somebody asked for exactly that.
[[nodiscard]] std::vector<ParameterDifference> toRestore(const ParameterSource &source, const ParameterFile &file);
[[nodiscard]] std::vector<ParameterDifference> toRestore(const Device &device, const ParameterFile &file);
/// For showing: those of toRestore() that differ from what is known or assumed.
[[nodiscard]] std::vector<ParameterDifference> differences(const ParameterSource &source, const ParameterFile &file);
[[nodiscard]] std::vector<ParameterDifference> differences(const Device &device, const ParameterFile &file);

} // namespace mb
