// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameterfile.h"

#include <optional>
#include <string>
#include <vector>

namespace mb::settings {

/// What a device, a file, a snapshot or the data sheet says of the parameters of a family.
struct Side {
    const Family *family = nullptr;
    std::string serial; ///< of the unit; empty where there is none
    /// In table order; nothing for a parameter that it does not speak of.
    std::vector<std::optional<ParameterStore::Entry>> entries;
};

/// What is known of it now.
[[nodiscard]] Side sideOf(const Device &device);
[[nodiscard]] Side sideOf(const ParameterSource &source);
/// A parameter file. OutOfRange as parseParameterFile() has it.
[[nodiscard]] Result<Side> sideOf(const QByteArray &file, const Family &family);
/// The data sheet's values.
[[nodiscard]] Side defaultsOf(const Family &family);

struct SideDifference {
    ParameterIndex index;
    ParameterStore::Entry a; ///< its raw value is nothing where it is not known
    ParameterStore::Entry b;
};

/// A parameter that a person sets: neither read-only, nor live, nor a counter.
[[nodiscard]] bool isSetting(const Parameter &parameter);

/// Settings that both sides speak of and that are not the same, in table order: what one of them does not know differs from
/// what the other one knows. Both of one family.
[[nodiscard]] std::vector<SideDifference> compare(const Side &a, const Side &b);

} // namespace mb::settings
