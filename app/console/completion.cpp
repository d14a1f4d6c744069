// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/commandline.h"
#include "app/console/optionwords.h"
#include "app/console/target.h"
#include "app/console/verb.h"

#include <functional>

namespace mb::console {
namespace {

/// Settings that are no device and no file.
constexpr std::string_view settingsWords = "defaults snapshot:";
constexpr std::string_view linkWords = "sim:can sim:serial sim:spi socketcan: serial: spidev: unix: replay:";

/// What the shells complete, of a table that the program itself reads.
template <class Table, class Word = std::identity> std::string wordsOf(const Table &table, Word word = {})
{
    std::string all;
    for (const auto &row : table)
        all += (all.empty() ? "" : " ") + std::string(std::invoke(word, row));
    return all;
}

std::string optionsWords(std::string_view verb)
{
    return wordsOf(optionsOf(verb), &OptionRow::name);
}
std::string keysOf(const Family &family)
{
    return wordsOf(family.parameters, &Parameter::key);
}
std::string channelsOf(const Family &family)
{
    const std::string states = wordsOf(family.states, &StateRow::key);
    return wordsOf(family.channels, &Channel::key) + (states.empty() ? "" : " " + states);
}
std::string modesOf(const Family &family)
{
    return std::string(toString(Mode::Off)) + ' ' + wordsOf(family.modes, [](Mode mode) { return toString(mode); });
}

/// `case "$what" in PATTERN) words=… ;;` of each family, by the DEVICE on the line.
std::string caseOfFamilies(
    std::span<const Family *const> families, std::string (*words)(const Family &), const std::string &indent)
{
    std::string text;
    for (const Family *family : families)
        text += indent + "*/" + std::string(family->key) + ":*) words=\"" + words(*family) + "\" ;;\n";
    return text;
}

std::string caseOfVerbs(const std::string &indent)
{
    std::string text;
    for (const Verb &verb : verbs())
        text += indent + std::string(verb.name) + ") words=\"" + optionsWords(verb.name) + "\" ;;\n";
    return text;
}

/// Of bash and zsh: what may follow the option in `before`, when it is one that wants something known.
std::string valuesOfOptions(std::span<const Family *const> families)
{
    return R"(    case "$before" in
    --file|--out|--save|--export) words="FILES"; return ;;
    --theme) words="dark light contrast system"; return ;;
    --target) [ "$verb" = flash ] && words=")"
        + wordsOf(targetWords(families)) + R"("; return ;;
    --size) [ "$verb" = report ] && words=")"
        + wordsOf(reportSizes) + R"("; return ;;
    --loop) words=")"
        + wordsOf(tunableLoops()) + R"("; return ;;
    --aim) words=")"
        + wordsOf(aimWords()) + R"("; return ;;
    --profile) words=")"
        + wordsOf(profileWords()) + R"("; return ;;
    --dialect) words=")"
        + wordsOf(dialectWords(families)) + R"("; return ;;
    --channel)
        case "$device" in
)" + caseOfFamilies(families, channelsOf, "        ")
        + R"(        esac
        return ;;
    --mode)
        case "$device" in
)" + caseOfFamilies(families, modesOf, "        ")
        + R"(        esac
        return ;;
    esac
)";
}

/// What may stand behind `verb` where no option stands.
std::string valuesOfVerbs(std::span<const Family *const> families)
{
    const auto assign = [](const std::string &list) { return "words=\"" + list + "\""; };
    const std::string anyLink = assign(std::string(linkWords));
    return "    case \"$verb\" in\n    help) " + assign(wordsOf(verbs(), &Verb::name)) + " ;;\n    completion) "
        + assign("bash zsh fish") + " ;;\n    parameters) " + assign(wordsOf(families, &Family::key))
        + " ;;\n    decode|plot) " + assign("FILES") + " ;;\n    scan|monitor) " + anyLink
        + " ;;\n    get|set)\n        case \"$device\" in\n        \"\") " + anyLink + " ;;\n"
        + caseOfFamilies(families, keysOf, "        ") + "        esac ;;\n    diff) "
        + assign(std::string(settingsWords) + ' ' + std::string(linkWords) + " FILES")
        + " ;;\n    restore|flash) if [ -n \"$device\" ]; then " + assign("FILES") + "; else " + anyLink
        + "; fi ;;\n    service) if [ -z \"$device\" ]; then " + assign("FILES") + "; else " + anyLink
        + "; fi ;;\n    *) [ -z \"$device\" ] && " + anyLink + " ;;\n    esac\n";
}

/// Both shells understand it: finds out in `words` what may stand at the cursor.
std::string chooser(std::span<const Family *const> families)
{
    return R"(_motorbenchctl_words() {
    # arguments: the words in front of the cursor, then the one that is being typed
    words=""
    local verb="" device="" before="" word current
    while [ $# -gt 1 ]; do
        word=$1
        shift
        case "$before" in
        --timeout|--retries) [ -z "$verb" ] && before="" && continue ;;
        esac
        before=$word
        case "$word" in
        -*) ;;
        *) if [ -z "$verb" ]; then verb=$word; elif [ -z "$device" ]; then device=$word; fi ;;
        esac
    done
    current=$1
)" + valuesOfOptions(families)
        + R"(    if [ -z "$verb" ]; then
        words=")"
        + wordsOf(verbs(), &Verb::name) + " " + optionsWords({}) + R"( --version"
        return
    fi
    case "$current" in
    -*)
        case "$verb" in
)" + caseOfVerbs("        ")
        + R"(        esac
        return ;;
    esac
)" + valuesOfVerbs(families)
        + "}\n";
}

std::string forBash(std::span<const Family *const> families)
{
    return "# completion of motorbenchctl: source <(motorbenchctl completion bash)\n" + chooser(families)
        + R"(_motorbenchctl() {
    local words typed=${COMP_LINE:0:COMP_POINT} current prefix
    local -a line
    read -r -a line <<< "$typed"
    case "$typed" in *' ') line+=("") ;; esac # the cursor stands on a new word
    _motorbenchctl_words "${line[@]:1}"
    current=${line[${#line[@]}-1]}
    mapfile -t COMPREPLY < <(compgen -W "${words%FILES}" -- "$current")
    case "$words" in *FILES)
        local -a files
        mapfile -t files < <(compgen -f -- "$current")
        COMPREPLY+=("${files[@]}") ;;
    esac
    prefix=${current%"${current##*[:=]}"} # bash takes these for the beginning of a word
    case "$COMP_WORDBREAKS" in *:*) COMPREPLY=("${COMPREPLY[@]#"$prefix"}") ;; esac
}
complete -o nospace -F _motorbenchctl motorbenchctl
)";
}

std::string forZsh(std::span<const Family *const> families)
{
    return "#compdef motorbenchctl\n# completion of motorbenchctl: source <(motorbenchctl completion zsh)\n"
        + chooser(families) + R"(_motorbenchctl() {
    local -a typed=("${(@)words[2,CURRENT]}")
    local words
    _motorbenchctl_words "${typed[@]}"
    compadd -- ${=words%FILES}
    case "$words" in *FILES) _files ;; esac
}
compdef _motorbenchctl motorbenchctl
)";
}

std::string fishText(std::string_view text)
{
    std::string out = "'";
    for (const char c : text)
        out += c == '\'' ? std::string("\\'") : std::string(1, c);
    return out + '\'';
}

std::string forFish(std::span<const Family *const> families)
{
    std::string text = "# completion of motorbenchctl: motorbenchctl completion fish | source\n"
                       "complete -c motorbenchctl -f\n";
    for (const Verb &verb : verbs()) {
        const std::string name(verb.name);
        text += "complete -c motorbenchctl -n __fish_use_subcommand -a " + name + " -d " + fishText(verb.help) + '\n';
        const std::string seen = "complete -c motorbenchctl -n '__fish_seen_subcommand_from " + name + "' ";
        for (const OptionRow &row : optionsOf(verb.name))
            text += seen + "-l " + row.name.substr(2) + (row.takesValue ? " -r" : "") + " -d " + fishText(row.help)
                + '\n';
    }
    const auto offer = [&text](std::string_view verb, const std::string &list) {
        text += "complete -c motorbenchctl -n '__fish_seen_subcommand_from " + std::string(verb) + "' -a '" + list
            + "'\n";
    };
    offer("parameters", wordsOf(families, &Family::key));
    offer("help", wordsOf(verbs(), &Verb::name));
    offer("completion", "bash zsh fish");
    for (const char *verb : {"scan", "monitor", "info", "watch", "drive", "identify", "number", "rename"})
        offer(verb, std::string(linkWords));
    offer("diff", std::string(settingsWords) + ' ' + std::string(linkWords));
    const auto take = [&text](std::string_view verbsOf, std::string_view option, const std::string &list) {
        text += "complete -c motorbenchctl -n '__fish_seen_subcommand_from " + std::string(verbsOf) + "' -l "
            + std::string(option) + " -x -a '" + list + "'\n";
    };
    take("tune", "loop", wordsOf(tunableLoops()));
    take("tune", "aim", wordsOf(aimWords()));
    take("step", "profile", wordsOf(profileWords()));
    take("report", "size", wordsOf(reportSizes));
    take("flash", "target", wordsOf(targetWords(families)));
    take("decode monitor", "dialect", wordsOf(dialectWords(families)));
    for (const Family *family : families) {
        const std::string device = "string match -q \"*/" + std::string(family->key) + ":*\" (commandline -opc)";
        const auto onDevice
            = [&](const std::string &rest) { text += "complete -c motorbenchctl -n '" + device + rest + "'\n"; };
        onDevice("; and __fish_seen_subcommand_from get set' -a '" + keysOf(*family));
        onDevice("' -l channel -x -a '" + channelsOf(*family));
        onDevice("' -l mode -x -a '" + modesOf(*family));
    }
    for (const char *verb : {"restore", "flash", "decode", "plot", "service", "diff"})
        text += "complete -c motorbenchctl -n '__fish_seen_subcommand_from " + std::string(verb) + "' -F\n";
    return text;
}

Task<int> complete(Console &console, std::string shell)
{
    std::string text;
    if (shell == "bash")
        text = forBash(console.families());
    else if (shell == "zsh")
        text = forZsh(console.families());
    else if (shell == "fish")
        text = forFish(console.families());
    else
        co_return fail(Fault::Usage, say("completion for '%1' is unknown", shell), say("there is bash, zsh and fish"));
    text.pop_back(); // line() adds it
    if (console.json())
        console.out().json({{QStringLiteral("completion"), qt(text)}});
    else
        console.out().line(text);
    co_return exitDone;
}

} // namespace

Job declareCompletion(CLI::App &arguments)
{
    const auto shell = std::make_shared<std::string>();
    arguments.add_option("shell", *shell, "bash, zsh or fish")->required();
    return [shell](Console &console) { return complete(console, *shell); };
}

} // namespace mb::console
