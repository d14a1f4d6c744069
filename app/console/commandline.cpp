// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/commandline.h"

#include "app/console/target.h"
#include "app/console/verb.h"
#include "async/seconds.h"

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
    Verb{"restore", "DEVICE FILE|snapshot:NAME [--dry-run]",
        "Show how saved settings differ, then write the differences", declareRestore},
    Verb{"snapshot", "DEVICE [--name TEXT]", "Keep all readable parameters under a name", declareSnapshot},
    Verb{"snapshots", "[DEVICE]", "List the snapshots that are kept, unit by unit", declareSnapshots},
    Verb{"diff", "A B", "How two of device, file, snapshot:NAME and defaults differ; status 1 when they do",
        declareDiff},
    Verb{"watch", "DEVICE [--channel C]… [--for S] [--rate HZ]", "Stream samples", declareWatch},
    Verb{
        "drive", "DEVICE --mode M --target X --for S", "Keep a set-point alive for S seconds, then stop", declareDrive},
    Verb{"step", "DEVICE --mode M --to Y [--from X] [--profile P] [--set KEY=VALUE]…",
        "Run one guarded experiment on a loop, and keep the trial", declareStep},
    Verb{"tune", "DEVICE --loop velocity|position|current [--aim calm|normal|brisk] [--propose] [--store] [limits]",
        "Identify the motor, design its gains, prove them, keep them", declareTune},
    Verb{"trials", "[DEVICE] [--export FILE] [--star N] [--note N TEXT] [--delete N]",
        "The notebook: every experiment with its gains", declareTrials, "--note"},
    Verb{"service", "RECIPE [LINK…] [--units N] [--resume] [--station NAME] [--journal URL]",
        "Firmware, parameters, self-test and number for every unit, by a recipe", declareService},
    Verb{"journal", "[--since T] [--serial S] [--export FILE.csv]", "What was done to which unit", declareJournal},
    Verb{"report", "DEVICE|trial:N… --out FILE.pdf|FILE.html",
        "The service card of a unit, or of trials: identity, gains, curves, proof, history", declareReport},
    Verb{"flash", "DEVICE FILE [--dry-run] [--force]", "Update the firmware and verify it", declareFlash},
    Verb{"identify", "DEVICE [--axis N] [--yes]", "Make a device show itself: it blinks, or turns its shaft a little",
        declareIdentify},
    Verb{"restart", "DEVICE", "Stop a device and restart it", declareRestart},
    Verb{"number", "DEVICE NEW", "Give a device another number", declareNumber},
    Verb{"rename", "DEVICE TEXT", "Give a device another name", declareRename},
    Verb{"monitor", "LINK [--for S] [--dialect D]", "Show the traffic of a link, as candump -L does", declareMonitor},
    Verb{"decode", "[FILE] [--dialect D]", "Decode such text, or a Vector ASC log, from a file or standard input",
        declareDecode},
    Verb{"plot", "FILE --out PNG", "Draw a recording into a picture", declarePlot},
    Verb{"simulate", "--on LINK DEVICE… [--on …] [--seed N] [--for S]", "Simulated controllers on real links",
        declareSimulate},
    Verb{"help", "[VERB]", "What the program does, or one verb", declareHelp},
    Verb{"completion", "bash|zsh|fish", "What a shell needs to complete these words", declareCompletion},
};

const Verb *findVerb(std::string_view name)
{
    const auto verb = std::ranges::find(table, name, &Verb::name);
    return verb == table.end() ? nullptr : verb;
}

Result<const Verb *> knownVerb(std::string_view name)
{
    if (const Verb *verb = findVerb(name))
        return verb;
    std::vector<std::string_view> known;
    for (const Verb &each : table)
        known.push_back(each.name);
    return fail(Fault::Usage, say("unknown verb '%1'", name), suggestion(name, known, "there are " + joined(known)));
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
          "--json       standard output is JSON, one object per line\n"
          "--quiet      no progress and no notes on standard error\n"
          "--timeout S  longest wait for an answer, and for a device to be found\n"
          "--retries N  ask so many times more where nothing answers\n"
          "--help       with a verb: its arguments\n"
          "--version    the version of this program\n\n"
          "A LINK is sim:can, socketcan:can0, …; a DEVICE is LINK/FAMILY:ADDRESS, such as sim:can/dmc60c:5.\n"
          "Exit status: 0 done, 1 the device refused or differs, 2 wrong usage, 3 no answer, 4 stopped for safety,\n"
          "5 a link cannot be opened or was lost.\n";
}

/// As typed, before it is understood: of every verb, in front of it or behind it.
struct Globals {
    bool json = false;
    bool quiet = false;
    std::string timeout;
    std::string retries;
};

void declareGlobals(CLI::App &app, Globals &globals)
{
    app.set_help_flag("--help,-h", "Show this and end");
    app.add_flag("--json", globals.json, "Standard output is JSON, one object per line");
    app.add_flag("--quiet", globals.quiet, "No progress and no notes on standard error");
    app.add_option("--timeout", globals.timeout, "Longest wait in seconds for an answer, and for a device to be found");
    app.add_option("--retries", globals.retries, "Ask so many times more where nothing answers");
}

Result<Options> optionsFrom(const Globals &globals)
{
    Options options;
    options.json = globals.json;
    options.quiet = globals.quiet;
    if (!globals.timeout.empty()) {
        MB_TRY(const auto seconds, parseNumber("--timeout", globals.timeout, 0.01, 3600.0));
        options.patience.timeout = fromSeconds(seconds);
    }
    if (!globals.retries.empty()) {
        MB_TRY(const auto retries, parseInteger("--retries", globals.retries, 0, 1000));
        options.patience.retries = retries;
    }
    return options;
}

std::string lowered(std::string text)
{
    if (text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' && text[1] >= 'a' && text[1] <= 'z')
        text[0] = static_cast<char>(text[0] + 32);
    return text;
}

Message usageOf(const Verb &verb)
{
    return say("the usage is motorbenchctl %1",
        std::string(verb.name) + (verb.usage.empty() ? "" : " ") + std::string(verb.usage));
}

tl::unexpected<Error> isTwice(std::string_view verb, std::string_view name)
{
    return fail(Fault::Usage, say("%1: %2 is there twice", verb, name), say("leave one of the two out"));
}

/// An option that was given more often, or with fewer values, than it can be.
tl::unexpected<Error> wrongCount(const CLI::App &app, const Verb &verb, std::string_view name)
{
    const CLI::Option *const option = app.get_option_no_throw(std::string(name));
    if (option && static_cast<int>(option->count()) > option->get_items_expected_max())
        return isTwice(verb.name, name);
    return fail(Fault::Usage, say("%1: a value of %2 is missing", verb.name, name), usageOf(verb));
}

tl::unexpected<Error> unexpectedArgument(const CLI::App &app, const Verb &verb)
{
    const std::vector<std::string> remaining = app.remaining();
    const std::string wrong = remaining.empty() ? std::string() : remaining.front();
    const std::string name(verb.name);
    if (!wrong.starts_with('-'))
        return fail(Fault::Usage, say("%1: unexpected argument '%2'", name, wrong), usageOf(verb));
    std::vector<std::string> options;
    for (const CLI::Option *option : app.get_options()) {
        for (const std::string &longName : option->get_lnames())
            options.push_back("--" + longName);
    }
    const std::vector<std::string_view> known(options.begin(), options.end());
    return fail(Fault::Usage, say("%1: unknown option '%2'", name, wrong),
        suggestion(wrong.substr(0, wrong.find('=')), known, "it takes " + joined(known)));
}

tl::unexpected<Error> emptyValue(std::string_view verb, std::string_view name)
{
    return fail(Fault::Usage, say("%1: the value of %2 is empty", verb, name), say("give one, or leave %1 out", name));
}

/// CLI11 would take `--store=0` for a flag that is not set, `--store=3` for one that is, and the next word where `--speed=` ends.
Result<void> checkFlags(const CLI::App &app, const Verb &verb, const std::vector<std::string> &arguments)
{
    for (const std::string &word : arguments) {
        if (word == "--")
            break;
        const auto equals = word.find('=');
        if (!word.starts_with("--") || equals == std::string::npos)
            continue;
        const CLI::Option *const option = app.get_option_no_throw(word.substr(0, equals));
        if (option && option->get_items_expected_max() == 0 && option->get_fnames().empty()) // but `{word}` has one
            return fail(Fault::Usage, say("%1: %2 takes no value", verb.name, word.substr(0, equals)), usageOf(verb));
        if (option && equals + 1 == word.size())
            return emptyValue(verb.name, word.substr(0, equals));
    }
    return {};
}

/// An argument that was given never counts as one that was not: a script with an unset variable would lose a limit.
Result<void> checkValues(const CLI::App &app, const Verb &verb)
{
    for (const CLI::Option *option : app.get_options()) {
        const std::vector<std::string> &values = option->results();
        const bool isPlain = !option->get_inject_separator(); // otherwise "" ends a group, and an empty one is refused
        if (isPlain && std::ranges::find(values, "") != values.end() && option->get_name() != verb.mayBeEmpty)
            return emptyValue(verb.name, option->get_name());
    }
    return {};
}

Result<CommandLine> parseVerb(const Verb &verb, std::vector<std::string> arguments)
{
    const std::string name(verb.name);
    CLI::App app(std::string(verb.help), "motorbenchctl " + name);
    Globals globals;
    declareGlobals(app, globals);
    CommandLine line;
    line.job = verb.declare(app);
    MB_TRY_VOID(checkFlags(app, verb, arguments));
    std::ranges::reverse(arguments); // CLI11 takes them from the back
    try {
        app.parse(arguments);
    } catch (const CLI::CallForHelp &) {
        return CommandLine{{}, {}, app.help(), "help", app.help()};
    } catch (const CLI::ExtrasError &) {
        return unexpectedArgument(app, verb);
    } catch (const CLI::ArgumentMismatch &error) {
        const std::string_view words = error.what();
        return wrongCount(app, verb, words.substr(0, words.find(':')));
    } catch (const CLI::Error &error) {
        return fail(Fault::Usage, say("%1: %2", name, lowered(error.what())), usageOf(verb));
    }
    MB_TRY_VOID(checkValues(app, verb));
    MB_TRY(const auto options, optionsFrom(globals));
    line.options = options;
    line.options.verb = verb.name;
    return line;
}

/// How many words stand in front of the verb, which are understood behind it as well; or what only prints something.
Result<std::size_t> parseFront(const std::vector<std::string> &arguments, CommandLine &printed)
{
    std::size_t used = 0;
    for (; used < arguments.size() && arguments[used].starts_with('-'); ++used) {
        const std::string &word = arguments[used];
        const std::string name = word.substr(0, word.find('='));
        const bool takesValue = name == "--timeout" || name == "--retries";
        if (word == "--help" || word == "-h")
            printed = {{}, {}, overview(), "help", overview()};
        else if (word == "--version")
            printed = {{}, {}, "motorbenchctl " MOTORBENCH_VERSION "\n", "version", MOTORBENCH_VERSION};
        else if (!takesValue && word != "--json" && word != "--quiet")
            return fail(Fault::Usage, say("'%1' cannot stand before the verb", word),
                say("there stand --json, --quiet, --timeout S, --retries N, --help and --version"));
        if (!printed.text.empty())
            break;
        if (takesValue && word == name)
            ++used;
    }
    return std::min(used, arguments.size());
}

} // namespace

std::span<const Verb> verbs()
{
    return table;
}

Result<std::string> helpText(std::string_view name)
{
    if (name.empty())
        return overview();
    MB_TRY(const auto verb, knownVerb(name));
    CLI::App app(std::string(verb->help), "motorbenchctl " + std::string(name));
    Globals globals;
    declareGlobals(app, globals);
    (void)verb->declare(app);
    return app.help();
}

std::vector<OptionRow> optionsOf(std::string_view name)
{
    CLI::App app;
    Globals globals;
    declareGlobals(app, globals);
    if (const Verb *verb = findVerb(name))
        (void)verb->declare(app);
    std::vector<OptionRow> rows;
    for (const CLI::Option *option : app.get_options()) {
        for (const std::string &longName : option->get_lnames())
            rows.push_back({"--" + longName, option->get_items_expected_max() > 0, option->get_description()});
    }
    return rows;
}

Result<CommandLine> parseCommandLine(std::vector<std::string> arguments)
{
    CommandLine printed;
    MB_TRY(const auto used, parseFront(arguments, printed));
    if (!printed.text.empty())
        return printed;
    if (used == arguments.size())
        return fail(Fault::Usage, say("a verb is missing"), say("'motorbenchctl help' lists them"));
    MB_TRY(const auto verb, knownVerb(arguments[used]));
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(used));
    return parseVerb(*verb, std::move(arguments));
}

} // namespace mb::console
