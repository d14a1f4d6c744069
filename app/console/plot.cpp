// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/verb.h"
#include "app/console/windowprogram.h"

#include <sys/stat.h>

namespace mb::console {
namespace {

struct PlotArguments {
    std::string file;
    std::string out;
    std::string theme;
    std::string size;
};

Task<int> plot(Console &console, PlotArguments a)
{
    std::vector<std::string> words{"--plot", a.file, "--out", a.out};
    if (!a.theme.empty())
        words.insert(words.end(), {"--theme", a.theme});
    if (!a.size.empty())
        words.insert(words.end(), {"--size", a.size});
    if (console.json())
        words.emplace_back("--json");
    struct stat status { };
    const bool isThere = ::stat(a.file.c_str(), &status) == 0;
    if (isThere && S_ISDIR(status.st_mode))
        co_return fail(Fault::OutOfRange, say("%1 is a folder", a.file), say("name a recording"));
    if (isThere && (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)))
        co_return fail(Fault::OutOfRange, say("%1 is a device and has no end", a.file), say("name a recording"));
    if (a.file.empty() || a.out.empty())
        co_return fail(
            Fault::Usage, say("plot needs a recording and a picture"), say("add --out PICTURE, a .png, .svg or .pdf"));
    co_return fail(becomeWindow(std::move(words)));
}

} // namespace

Job declarePlot(CLI::App &arguments)
{
    const auto a = std::make_shared<PlotArguments>();
    arguments.add_option("file", a->file, "An .mcap or .csv of this program, or what watch printed")->required();
    arguments.add_option("--out", a->out, "The picture: .png, .svg or .pdf")->required();
    arguments.add_option("--theme", a->theme, "dark, light, contrast or system");
    arguments.add_option("--size", a->size, "Of the picture, such as 1280x800");
    return [a](Console &console) { return plot(console, *a); };
}

} // namespace mb::console
