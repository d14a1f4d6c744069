// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace mb {

/// One entry a version: statements that make it out of the version before, each ended by a semicolon at a line's end. Entries are
/// never changed once released; the next version is a new one at the end.
[[nodiscard]] std::span<const char *const> schemaVersions();

/// The part of it that stations share: the same statements make it on a server, whose versions are counted by themselves.
[[nodiscard]] std::span<const char *const> journalSchemaVersions();

} // namespace mb
