// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"
#include "app/console/target.h"
#include "app/console/trialtext.h"
#include "app/console/verb.h"
#include "async/outputfile.h"
#include "storage/trialfile.h"
#include "storage/unittags.h"

#include <memory>
#include <optional>
#include <set>
#include <tuple>

namespace mb::console {
namespace {

struct TrialsArguments {
    std::string device;
    std::string file;
    std::string star;
    std::vector<std::string> note; ///< number and text
    std::string remove;
};

using Units = std::set<std::string>;

constexpr int mostTrials = 2'000'000'000;

/// What is to be changed; all of it is understood before any is.
struct Changes {
    std::optional<std::int64_t> star;
    std::optional<std::int64_t> note;
    std::optional<std::int64_t> remove;
};

Result<Changes> parse(const TrialsArguments &a)
{
    Changes changes;
    const std::tuple<const char *, bool, std::string, std::optional<std::int64_t> *> numbers[]
        = {{"--star", !a.star.empty(), a.star, &changes.star},
            {"--note", !a.note.empty(), a.note.empty() ? "" : a.note.front(), &changes.note},
            {"--delete", !a.remove.empty(), a.remove, &changes.remove}};
    for (const auto &[option, isGiven, text, number] : numbers) {
        if (!isGiven)
            continue;
        MB_TRY(const auto parsed, parseInteger(option, text, 1, mostTrials));
        *number = parsed;
    }
    MB_TRY_VOID(a.note.empty() ? Result<void>() : checkName("a note", a.note.back()));
    if (changes.remove && (changes.star == changes.remove || changes.note == changes.remove))
        return fail(
            Fault::Usage, say("--delete %1 leaves nothing to mark", *changes.remove), say("leave one of the two out"));
    return changes;
}

Result<void> change(
    TrialBook &book, const Changes &changes, const TrialsArguments &a, const std::optional<Units> &units)
{
    for (const auto &number : {changes.star, changes.note, changes.remove}) {
        if (!number || !units)
            continue;
        MB_TRY(const auto kept, book.find(*number));
        if (!units->contains(kept.trial.unit))
            return fail(Fault::Usage, say("trial %1 is not one of %2", *number, a.device), say("leave the device out"));
    }
    if (changes.star) {
        MB_TRY(const auto kept, book.find(*changes.star));
        MB_TRY_VOID(book.setStar(*changes.star, !kept.star));
    }
    if (changes.note) {
        MB_TRY_VOID(book.setNote(*changes.note, a.note.back()));
    }
    return changes.remove ? book.remove(*changes.remove) : Result<void>();
}

Task<int> trials(Console &console, TrialsArguments a)
{
    std::optional<Target> target;
    if (!a.device.empty()) {
        target = co_await parseTarget(console, a.device);
    }
    const auto wanted = co_await parse(a);
    if (auto writable = a.file.empty() ? Result<void>() : checkWritable(a.file); !writable)
        co_return fail(writable.error());
    auto database = co_await openNotebook();
    TrialBook book(*database, console.clock());
    const bool changes = wanted.star || wanted.note || wanted.remove;
    const std::optional<Units> units = target ? std::optional(unitsAt(*database, target->selector)) : std::nullopt;
    auto changed = changes ? database->transact([&] { return change(book, wanted, a, units); }) : Result<void>();
    if (!changed)
        co_return fail(changed.error());
    auto kept = co_await book.list();
    if (units)
        std::erase_if(kept, [&units](const KeptTrial &each) { return !units->contains(each.trial.unit); });
    if (!a.file.empty()) {
        co_await exportTrials(a.file, kept);
        console.note(std::to_string(kept.size()) + " trials in " + a.file);
    }
    printTrials(console, kept);
    co_return exitDone;
}

} // namespace

Job declareTrials(CLI::App &arguments)
{
    const auto a = std::make_shared<TrialsArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS; all otherwise");
    arguments.add_option("--export", a->file, "Write them to a file, too: .csv a table, JSON otherwise");
    arguments.add_option("--star", a->star, "Mark trial N, or take its mark away");
    arguments.add_option("--note", a->note, "Number and text: a note on a trial")->expected(2);
    arguments.add_option("--delete", a->remove, "Forget trial N");
    return [a](Console &console) { return trials(console, *a); };
}

} // namespace mb::console
