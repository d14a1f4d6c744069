// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/windowprogram.h"

#include <QCoreApplication>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace mb::console {

Error becomeWindow(std::vector<std::string> words)
{
    const std::string program = QCoreApplication::applicationDirPath().toStdString() + "/motorbench";
    std::string name = "motorbenchctl"; // what it complains of was typed to this program
    std::vector<char *> pointers{name.data()};
    for (std::string &word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::setenv("QT_LOGGING_RULES", "*.warning=false", 1); // what the toolkit grumbles about is no word of ours
    ::execv(program.c_str(), pointers.data());
    return {Fault::OutOfRange, say("%1 cannot be run: %2", program, std::strerror(errno)),
        say("both programs must be in one folder")};
}

} // namespace mb::console
