// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <QByteArray>

#include <string>

namespace mb {

/// writeFile() for Qt's bytes.
[[nodiscard]] Result<void> saveFile(const std::string &path, const QByteArray &bytes);
/// readTextFile() for Qt's bytes; also of a resource of the program (":/…").
[[nodiscard]] Result<QByteArray> loadFile(const std::string &path, std::int64_t limit);

} // namespace mb
