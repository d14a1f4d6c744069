// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/target.h"
#include "app/console/trialtext.h"
#include "app/console/verb.h"
#include "app/folders/userfolders.h"
#include "storage/trialfile.h"

#include <memory>

namespace mb::console {
namespace {

struct TrialsArguments {
    std::string device;
    std::string file;
    std::string star;
    std::vector<std::string> note; ///< number and text
    std::string remove;
};

constexpr int mostTrials = 2'000'000'000;

Result<void> change(TrialBook &book, const TrialsArguments &a)
{
    if (!a.star.empty()) {
        const auto number = parseInteger("--star", a.star, 1, mostTrials);
        if (!number)
            return fail(number.error());
        const auto kept = book.find(*number);
        if (!kept)
            return fail(kept.error());
        if (auto starred = book.setStar(*number, !kept->star); !starred)
            return starred;
    }
    if (!a.note.empty()) {
        const auto number = parseInteger("--note", a.note.front(), 1, mostTrials);
        if (!number)
            return fail(number.error());
        if (auto noted = book.setNote(*number, a.note.back()); !noted)
            return noted;
    }
    if (!a.remove.empty()) {
        const auto number = parseInteger("--delete", a.remove, 1, mostTrials);
        if (!number)
            return fail(number.error());
        return book.remove(*number);
    }
    return {};
}

Task<int> trials(Console &console, TrialsArguments a)
{
    std::string device;
    if (!a.device.empty()) {
        const auto target = parseTarget(console, a.device);
        if (!target)
            co_return fail(target.error());
        device = target->selector.text();
    }
    auto database = Database::open(databaseFile());
    if (!database)
        co_return fail(database.error());
    if (!(*database)->remark().empty())
        complain((*database)->remark());
    TrialBook book(**database, console.clock());
    if (auto changed = change(book, a); !changed)
        co_return fail(changed.error());
    const auto kept = book.list(device);
    if (!kept)
        co_return fail(kept.error());
    if (!a.file.empty()) {
        if (auto saved = exportTrials(a.file, *kept); !saved)
            co_return fail(saved.error());
        console.note(std::to_string(kept->size()) + " trials in " + a.file);
    }
    printTrials(console, *kept);
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
