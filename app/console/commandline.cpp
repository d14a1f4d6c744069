// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/commandline.h"

#include "app/console/target.h"
#include "app/console/verb.h"

#include <algorithm>
#include <array>

namespace mb::console {
namespace {

constexpr std::array table{
    Verb{"links", "", "List the links that can be opened, and why one cannot", declareLinks},
    Verb{"scan", "[LINK…]", "Find devices; never writes to one. Without LINK, on every CAN interface that is up",
        declareScan},
    Verb{"info", "DEVICE", "Identity, descriptors, faults and link counters", declareInfo},
    Verb{"parameters", "FAMILY", "The parameter table of a family; needs no device", declareParameters},
    Verb{"get", "DEVICE [KEY…] [--file F]", "Read parameters, all readable ones by default", declareGet},
    Verb{"set", "DEVICE KEY=VALUE… [--store]", "Check all, then write, read back and compare", declareSet},
    Verb{"restore", "DEVICE FILE [--dry-run]", "Show how a saved file differs, then write the differences",
        declareRestore},
    Verb{"watch", "DEVICE [--channel C]… [--for S] [--rate HZ]", "Stream samples", declareWatch},
    Verb{
        "drive", "DEVICE --mode M --target X --for S", "Keep a set-point alive for S seconds, then stop", declareDrive},
    Verb{"step", "DEVICE --mode M --to Y [--from X] [--profile P] [--set KEY=VALUE]…",
        "Run one guarded experiment on a loop, and keep the trial", declareStep},
    Verb{"trials", "[DEVICE] [--export FILE] [--star N] [--note N TEXT] [--delete N]",
        "The notebook: every experiment with its gains", declareTrials},
    Verb{"flash", "DEVICE FILE [--dry-run] [--force]", "Update the firmware and verify it", declareFlash},
    Verb{"identify", "DEVICE", "Make a device show itself", declareIdentify},
    Verb{"number", "DEVICE NEW", "Give a device another number", declareNumber},
    Verb{"rename", "DEVICE TEXT", "Give a device another name", declareRename},
    Verb{"monitor", "LINK [--for S] [--dialect D]", "Show the traffic of a link, as candump -L does", declareMonitor},
    Verb{"decode", "[FILE] [--dialect D]", "Decode such text, or a Vector ASC log, from a file or standard input",
        declareDecode},
    Verb{"plot", "FILE --out PNG", "Draw a recording into a picture", declarePlot},
    Verb{"simulate", "--on LINK DEVICE… [--on …] [--seed N] [--for S]", "Simulated controllers on real links",
        declareSimulate},
};

const Verb *findVerb(std::string_view name)
{
    const auto verb = std::find_if(table.begin(), table.end(), [name](const Verb &v) { return v.name == name; });
    return verb == table.end() ? nullptr : verb;
}

std::string overview()
{
    std::string text = "Usage: motorbenchctl [--json] [--quiet] VERB …\n\n"
                       "Finds, sets up, watches, drives and updates motor controllers without a screen.\n\nVerbs:\n";
    for (const Verb &verb : table) {
        text += "  " + std::string(verb.name) + std::string(12 - verb.name.size(), ' ') + std::string(verb.help) + '\n';
    }
    return text
        + "\n"
          "--json     standard output is JSON, one object per line\n"
          "--quiet    no progress and no notes on standard error\n"
          "--help     with a verb: its arguments\n"
          "--version  the version of this program\n\n"
          "A LINK is sim:can, socketcan:can0, …; a DEVICE is LINK/FAMILY:ADDRESS, such as sim:can/dmc60c:5.\n"
          "Exit status: 0 done, 1 the device refused or differs, 2 wrong usage, 3 no answer, 4 stopped for safety,\n"
          "5 a link cannot be opened or was lost.\n";
}

std::string lowered(std::string text)
{
    if (text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' && (text[1] < 'A' || text[1] > 'Z'))
        text[0] = static_cast<char>(text[0] + 32);
    return text;
}

tl::unexpected<Error> unexpectedArgument(const CLI::App &app, const Verb &verb)
{
    const std::vector<std::string> remaining = app.remaining();
    const std::string wrong = remaining.empty() ? std::string() : remaining.front();
    const std::string name(verb.name);
    if (!wrong.starts_with('-'))
        return fail(Fault::OutOfRange,
            name + ": unexpected argument '" + wrong + "'; the usage is motorbenchctl " + name + ' '
                + std::string(verb.usage));
    std::vector<std::string> options;
    for (const CLI::Option *option : app.get_options()) {
        for (const std::string &longName : option->get_lnames())
            options.push_back("--" + longName);
    }
    const std::vector<std::string_view> known(options.begin(), options.end());
    const std::string near = suggestion(wrong.substr(0, wrong.find('=')), known);
    return fail(Fault::OutOfRange,
        name + ": unknown option '" + wrong + '\''
            + (near.empty() ? "; 'motorbenchctl " + name + " --help' lists what it takes" : near));
}

Result<CommandLine> parseVerb(const Verb &verb, std::vector<std::string> arguments, CommandLine line)
{
    const std::string name(verb.name);
    CLI::App app(std::string(verb.help), "motorbenchctl " + name);
    app.set_help_flag("--help,-h", "Show this and end");
    app.add_flag("--json", line.options.json, "Standard output is JSON, one object per line");
    app.add_flag("--quiet", line.options.quiet, "No progress and no notes on standard error");
    line.job = verb.declare(app);
    std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the back
    try {
        app.parse(arguments);
    } catch (const CLI::CallForHelp &) {
        return CommandLine{line.options, {}, app.help()};
    } catch (const CLI::ExtrasError &) {
        return unexpectedArgument(app, verb);
    } catch (const CLI::Error &error) {
        return fail(Fault::OutOfRange,
            name + ": " + lowered(error.what()) + "; the usage is motorbenchctl " + name + ' '
                + std::string(verb.usage));
    }
    return line;
}

} // namespace

std::span<const Verb> verbs()
{
    return table;
}

Result<CommandLine> parseCommandLine(std::vector<std::string> arguments)
{
    CommandLine line;
    std::size_t used = 0;
    for (; used < arguments.size() && arguments[used].starts_with('-'); ++used) {
        if (arguments[used] == "--json")
            line.options.json = true;
        else if (arguments[used] == "--quiet")
            line.options.quiet = true;
        else if (arguments[used] == "--help" || arguments[used] == "-h")
            return CommandLine{line.options, {}, overview()};
        else if (arguments[used] == "--version")
            return CommandLine{line.options, {}, "motorbenchctl " MOTORBENCH_VERSION "\n"};
        else
            return fail(Fault::OutOfRange,
                "unknown option '" + arguments[used] + "' before the verb; only --json and --quiet stand there");
    }
    if (used == arguments.size())
        return fail(Fault::OutOfRange, "a verb is missing; 'motorbenchctl --help' lists them");
    const std::string name = arguments[used];
    const Verb *verb = findVerb(name);
    if (!verb) {
        std::vector<std::string_view> known;
        for (const Verb &each : table)
            known.push_back(each.name);
        const std::string near = suggestion(name, known);
        return fail(Fault::OutOfRange,
            "unknown verb '" + name + '\'' + (near.empty() ? "; 'motorbenchctl --help' lists them" : near));
    }
    arguments.erase(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(used + 1));
    return parseVerb(*verb, std::move(arguments), std::move(line));
}

} // namespace mb::console
