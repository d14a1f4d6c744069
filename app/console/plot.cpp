// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/failure.h"
#include "app/console/signals.h"
#include "app/console/verb.h"

#include <QCoreApplication>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

namespace mb::console {
namespace {

struct Arguments {
    std::string file;
    std::string out;
    std::string theme;
    std::string size;
};

/// The program with the window draws; it takes the place of this one, so its words and its exit status are ours. This
/// program links nothing of a screen.
Task<int> plot(Console &console, Arguments a)
{
    const std::string program = QCoreApplication::applicationDirPath().toStdString() + "/motorbench";
    std::vector<std::string> words{program, "--plot", a.file, "--out", a.out};
    if (!a.theme.empty())
        words.insert(words.end(), {"--theme", a.theme});
    if (!a.size.empty())
        words.insert(words.end(), {"--size", a.size});
    if (console.json())
        words.emplace_back("--json");
    struct stat status { };
    if (::stat(a.file.c_str(), &status) == 0 && (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)))
        co_return fail(Fault::OutOfRange, a.file + " is a device and has no end", "name a recording");
    if (a.file.empty() || a.out.empty())
        co_return fail(Fault::Usage, "plot needs a recording and a picture", "add --out PICTURE, a .png, .svg or .pdf");
    std::vector<char *> pointers;
    for (std::string &word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::setenv("QT_LOGGING_RULES", "*.warning=false", 1); // what the toolkit grumbles about is no word of ours
    Signals::release();
    ::execv(program.c_str(), pointers.data());
    co_return fail(
        Fault::OutOfRange, program + " cannot be run: " + std::strerror(errno), "both programs must be in one folder");
}

} // namespace

Job declarePlot(CLI::App &arguments)
{
    const auto a = std::make_shared<Arguments>();
    arguments.add_option("file", a->file, "An .mcap or .csv of this program, or what watch printed")->required();
    arguments.add_option("--out", a->out, "The picture: .png, .svg or .pdf")->required();
    arguments.add_option("--theme", a->theme, "dark or light");
    arguments.add_option("--size", a->size, "Of the picture, such as 1280x800");
    return [a](Console &console) { return plot(console, *a); };
}

} // namespace mb::console
