// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/parameterfile.h"

#include <QString>

namespace mb {

/// Files of parameters as a person meets them: one clear line where a file is refused.

struct RefusedFile {
    QString cause; ///< "tuning.json is for Supermodified, DMC60C #5 is a DMC60C."
    QString remedy;
};
template <class T> using FromFile = tl::expected<T, RefusedFile>;

/// The values of a file for one family; nothing is half taken. `owner` names the device in the refusal.
[[nodiscard]] FromFile<ParameterFile> loadParameterFile(
    const QString &path, const Family &family, const QString &owner);
/// The family that a file is for, when this build knows it.
[[nodiscard]] FromFile<const Family *> loadFamily(const QString &path);
/// One entry per parameter of the family, unknown where the file says nothing.
[[nodiscard]] std::vector<ParameterStore::Entry> entriesOf(const Family &family, const ParameterFile &file);
/// The same text as `motorbenchctl get --file` writes.
[[nodiscard]] QByteArray parameterFileText(const ParameterSource &source);
/// Name without folder.
[[nodiscard]] QString fileNameOf(const QString &path);
/// For askForFile() and askWhereToSave().
[[nodiscard]] QString parameterFilters();

} // namespace mb
