// SPDX-License-Identifier: GPL-3.0-or-later
#include "place/firstline.h"

#include <fstream>

namespace mb {

std::string firstLine(const std::filesystem::path &file)
{
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

} // namespace mb
