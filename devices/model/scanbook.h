// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/identity.h"

#include <string>
#include <string_view>
#include <vector>

namespace mb {

/// Who answered on each link in its last scan, as JSON files of one directory, one a link, named after its address. It only
/// saves time: a scan asks these first, and believes nothing of it.
class ScanBook {
public:
    explicit ScanBook(std::string directory)
        : m_directory(std::move(directory))
    {
    }
    /// Family, address, dialect and descriptors of each; nobody when there is no file. A file that is none: OutOfRange,
    /// it is ignored, and replaced by the next save().
    [[nodiscard]] Result<std::vector<Identity>> load(std::string_view link) const;
    /// The whole file or nothing.
    [[nodiscard]] Result<void> save(std::string_view link, const std::vector<Identity> &seen) const;
    [[nodiscard]] std::string pathOf(std::string_view link) const;

private:
    std::string m_directory;
};

} // namespace mb
