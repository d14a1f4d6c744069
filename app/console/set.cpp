// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/assignments.h"
#include "app/console/notebook.h"
#include "app/console/parameterrows.h"
#include "app/console/progressline.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "async/noncopyable.h"
#include "settings/storing.h"
#include "settings/writing.h"

#include <algorithm>
#include <memory>

namespace mb::console {
namespace {

struct SetArguments {
    std::string device;
    std::vector<std::string> assignments;
    bool store = false;
};

using Verdict = std::optional<bool>; ///< read back and equal; nothing: cannot be read back

Verdict verdictOf(const TransferOutcome &outcome)
{
    if (!outcome.raw && outcome.raw.error().fault == Fault::BadCheck)
        return false;
    return outcome.verified;
}

/// False where one differs, nothing where one cannot be read back.
Verdict verdictOf(const std::vector<TransferOutcome> &outcomes)
{
    Verdict all = true;
    for (const TransferOutcome &outcome : outcomes) {
        const Verdict one = verdictOf(outcome);
        if (one == false)
            return false;
        if (!one)
            all.reset();
    }
    return all;
}

QJsonValue toJson(Verdict verdict)
{
    return verdict ? QJsonValue(*verdict) : QJsonValue();
}

/// `verified`: of all, and of what came of the flash.
QJsonObject toJson(const Device &device, const std::vector<ParameterIndex> &indices,
    const std::vector<TransferOutcome> &outcomes, Verdict verified)
{
    const QString key = QStringLiteral("verified");
    QJsonObject object = parametersToJson(device, indices);
    QJsonObject rows = object.value(QStringLiteral("parameters")).toObject();
    for (QJsonObject::iterator row = rows.begin(); row != rows.end(); ++row) {
        QJsonObject values = row.value().toObject();
        values.insert(key, QJsonValue());
        for (const TransferOutcome &outcome : outcomes) {
            if (device.parameters().parameter(outcome.index).key == row.key().toStdString())
                values.insert(key, toJson(verdictOf(outcome)));
        }
        row.value() = values;
    }
    object.insert(QStringLiteral("parameters"), rows);
    object.insert(key, toJson(verified));
    return object;
}

/// Says so where the proof is interrupted: what was written is in force all the same.
class Unproved : NonCopyable {
public:
    explicit Unproved(Console &console)
        : m_console(console)
    {
    }
    ~Unproved()
    {
        if (!m_isTold)
            m_console.note("the values are in force but not proved to be stored");
    }
    void told() { m_isTold = true; }

private:
    Console &m_console;
    bool m_isTold = false;
};

/// Yields the error that is to be told besides the values, if any. Fails when nothing is known to print.
Task<std::optional<Error>> store(
    Console &console, Device &device, const std::vector<ParameterChange> &changes, settings::SettingsLog *log)
{
    ProgressLine progress(console);
    Unproved unproved(console);
    auto storing = settings::storeKept(device, settings::Origin::Console, log, progress);
    const Result<bool> stored = co_await std::move(storing).attempt();
    unproved.told();
    if (!stored)
        co_return std::optional<Error>(
            stored.error().about(say("the values are in force but not proved to be stored")));
    const auto canBeRead = [&device](const ParameterChange &change) {
        return device.parameters().parameter(change.index).access != Access::WriteOnly;
    };
    const bool isReadable = std::ranges::any_of(changes, canBeRead);
    if (!*stored)
        console.note(isReadable
                ? "this device cannot prove that it stored the values; read them again after a power cycle"
                : "this device cannot prove that it stored the values, and none of them can be read; see after a power "
                  "cycle that it does as before");
    co_return std::optional<Error>();
}

void show(Console &console, const Device &device, const std::vector<ParameterChange> &changes,
    const std::vector<TransferOutcome> &outcomes, bool failed)
{
    std::vector<ParameterIndex> indices;
    for (const ParameterChange &change : changes)
        indices.push_back(change.index);
    if (console.json())
        console.out().json(toJson(device, indices, outcomes, failed ? Verdict(false) : verdictOf(outcomes)));
    else
        printParameters(console, device, indices);
}

Task<int> set(Console &console, SetArguments arguments)
{
    const auto target = co_await parseTarget(console, arguments.device);
    const auto changes = co_await parseAssignments(*target.family, arguments.assignments);
    if (arguments.store && !target.family->capabilities.keepsSettings)
        co_return fail(Fault::Unsupported, say("%1 keeps nothing without power", target.family->title),
            say("leave --store out, and write it again after each start"));
    Notebook notebook(console); // before the device is found: what is refused at once must not come after an answer
    Device *const device = co_await connect(console, target);
    co_await needsApplication(*device);
    console.onlyAsk();
    if (const auto refused = co_await findRefused(*device, changes))
        co_return fail(*firstError(*device, {*refused}));
    console.begin();
    notebook.noteTrouble();
    const std::vector<std::string> owed = co_await notebook.owedLines(*device, changes);
    for (const std::string &line : owed)
        console.note(line);
    std::vector<TransferOutcome> outcomes;
    {
        WriteProgress progress(console);
        auto writing
            = settings::writeKept(*device, changes, {settings::Origin::Console}, notebook.settings(), progress);
        outcomes = co_await std::move(writing);
    }
    std::optional<Error> error = firstError(*device, outcomes);
    if (error && outcomes.size() > 1)
        error->detail = say("%1 (written before it: %2)", error->detail, outcomes.size() - 1);
    if (error && error->fault != Fault::BadCheck)
        co_return console.fails(*error); // judged now: what is polled meanwhile was not sent by this verb
    if (arguments.store && !error) {
        error = co_await store(console, *device, changes, notebook.settings());
    }
    show(console, *device, changes, outcomes, error.has_value());
    if (!error)
        co_return exitDone;
    if (error->fault == Fault::Timeout)
        error->fault = Fault::BadCheck;
    co_return console.fails(*error);
}

} // namespace

Job declareSet(CLI::App &arguments)
{
    const auto a = std::make_shared<SetArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("assignment", a->assignments, "KEY=VALUE, in the unit that 'parameters' shows")->required();
    arguments.add_flag("--store", a->store, "Make it survive a power cycle, and prove it");
    return [a](Console &console) { return set(console, *a); };
}

} // namespace mb::console
