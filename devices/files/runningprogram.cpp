// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/runningprogram.h"

#include <fstream>
#include <sstream>

#include <unistd.h>

namespace mb {

/// "4711:93041", the process and when it began after the start of the system: numbers of processes are used again.
std::string programOf(const std::string &process)
{
    std::ifstream file("/proc/" + process + "/stat");
    std::string line;
    std::getline(file, line);
    const std::size_t name = line.rfind(')'); // it may hold blanks
    if (name == std::string::npos)
        return {};
    std::istringstream fields(line.substr(name + 1));
    std::string field;
    fields >> field;
    if (field == "Z" || field == "X") // it has ended, and its parent has not asked how
        return {};
    for (int i = 4; i <= 22; ++i) // the name was the second, and the 22nd is when it began
        fields >> field;
    return fields ? process + ':' + field : std::string();
}

std::string thisProgram()
{
    return programOf(std::to_string(::getpid()));
}

bool isAnotherRunning(const std::string &program)
{
    return !program.empty() && program != thisProgram() && programOf(program.substr(0, program.find(':'))) == program;
}

} // namespace mb
