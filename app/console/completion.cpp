// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/commandline.h"
#include "app/console/optionwords.h"
#include "app/console/target.h"
#include "app/console/verb.h"

#include <memory>

namespace mb::console {
namespace {

/// Settings that are no device and no file.
constexpr std::string_view settingsWords = "defaults snapshot:";
constexpr std::string_view linkWords = "sim:can sim:serial sim:spi socketcan: serial: spidev: unix: replay:";

/// What the shells complete, of the tables that the program itself reads.
class Words {
public:
    explicit Words(std::span<const Family *const> families)
        : m_families(families)
    {
    }
    [[nodiscard]] static std::string verbNames()
    {
        std::string all;
        for (const Verb &verb : verbs())
            add(all, verb.name);
        return all;
    }
    [[nodiscard]] static std::string options(std::string_view verb)
    {
        std::string all;
        for (const OptionRow &row : optionsOf(verb))
            add(all, row.name);
        return all;
    }
    [[nodiscard]] std::string families() const
    {
        std::string all;
        for (const Family *family : m_families)
            add(all, family->key);
        return all;
    }
    [[nodiscard]] static std::string keys(const Family &family)
    {
        std::string all;
        for (const Parameter &parameter : family.parameters)
            add(all, parameter.key);
        return all;
    }
    [[nodiscard]] static std::string channels(const Family &family)
    {
        std::string all;
        for (const Channel &channel : family.channels)
            add(all, channel.key);
        for (const StateRow &state : family.states)
            add(all, state.key);
        return all;
    }
    [[nodiscard]] static std::string modes(const Family &family)
    {
        std::string all(toString(Mode::Off));
        for (const Mode mode : family.modes)
            add(all, toString(mode));
        return all;
    }
    template <class List> [[nodiscard]] static std::string list(const List &words)
    {
        std::string all;
        for (const std::string_view word : words)
            add(all, word);
        return all;
    }
    [[nodiscard]] std::string dialects() const { return list(dialectWords(m_families)); }

private:
    static void add(std::string &all, std::string_view word) { all += (all.empty() ? "" : " ") + std::string(word); }

    std::span<const Family *const> m_families;
};

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
        text += indent + std::string(verb.name) + ") words=\"" + Words::options(verb.name) + "\" ;;\n";
    return text;
}

/// Of bash and zsh: what may follow the option in `before`, when it is one that wants something known.
std::string valuesOfOptions(std::span<const Family *const> families)
{
    return R"(    case "$before" in
    --file|--out|--save|--export) words="FILES"; return ;;
    --theme) words="dark light"; return ;;
    --target) [ "$verb" = flash ] && words="f1 f4"; return ;;
    --size) [ "$verb" = report ] && words=")"
        + Words::list(reportSizes) + R"("; return ;;
    --loop) words=")"
        + Words::list(tunableLoops()) + R"("; return ;;
    --aim) words=")"
        + Words::list(aimWords()) + R"("; return ;;
    --profile) words=")"
        + Words::list(profileWords()) + R"("; return ;;
    --dialect) words=")"
        + Words(families).dialects() + R"("; return ;;
    --channel)
        case "$device" in
)" + caseOfFamilies(families, Words::channels, "        ")
        + R"(        esac
        return ;;
    --mode)
        case "$device" in
)" + caseOfFamilies(families, Words::modes, "        ")
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
    return "    case \"$verb\" in\n    help) " + assign(Words::verbNames()) + " ;;\n    completion) "
        + assign("bash zsh fish") + " ;;\n    parameters) " + assign(Words(families).families())
        + " ;;\n    decode|plot) " + assign("FILES") + " ;;\n    scan|monitor) " + anyLink
        + " ;;\n    get|set)\n        case \"$device\" in\n        \"\") " + anyLink + " ;;\n"
        + caseOfFamilies(families, Words::keys, "        ") + "        esac ;;\n    diff) "
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
        + Words::verbNames() + " " + Words::options({}) + R"( --version"
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
    const Words words(families);
    const auto offer = [&text](std::string_view verb, const std::string &list) {
        text += "complete -c motorbenchctl -n '__fish_seen_subcommand_from " + std::string(verb) + "' -a '" + list
            + "'\n";
    };
    offer("parameters", words.families());
    offer("help", Words::verbNames());
    offer("completion", "bash zsh fish");
    for (const char *verb : {"scan", "monitor", "info", "watch", "drive", "identify", "number", "rename"})
        offer(verb, std::string(linkWords));
    offer("diff", std::string(settingsWords) + ' ' + std::string(linkWords));
    const auto take = [&text](std::string_view verbsOf, std::string_view option, const std::string &list) {
        text += "complete -c motorbenchctl -n '__fish_seen_subcommand_from " + std::string(verbsOf) + "' -l "
            + std::string(option) + " -x -a '" + list + "'\n";
    };
    take("tune", "loop", Words::list(tunableLoops()));
    take("tune", "aim", Words::list(aimWords()));
    take("step", "profile", Words::list(profileWords()));
    take("report", "size", Words::list(reportSizes));
    take("decode monitor", "dialect", words.dialects());
    for (const Family *family : families) {
        const std::string device = "string match -q \"*/" + std::string(family->key) + ":*\" (commandline -opc)";
        const auto onDevice
            = [&](const std::string &rest) { text += "complete -c motorbenchctl -n '" + device + rest + "'\n"; };
        onDevice("; and __fish_seen_subcommand_from get set' -a '" + Words::keys(*family));
        onDevice("' -l channel -x -a '" + Words::channels(*family));
        onDevice("' -l mode -x -a '" + Words::modes(*family));
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
