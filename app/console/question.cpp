// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/question.h"

#include <unistd.h>

#include <iostream>

namespace mb::console {

bool isAgreedTo(const std::string &question)
{
    if (::isatty(STDIN_FILENO) != 1 || ::isatty(STDERR_FILENO) != 1)
        return false;
    std::cerr << question << " [y/N] " << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "Y" || answer == "yes";
}

} // namespace mb::console
