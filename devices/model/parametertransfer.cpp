// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/parametertransfer.h"

#include "async/sleep.h"
#include "model/family.h"
#include "model/writeorder.h"

#include <algorithm>
#include <span>

namespace mb {
namespace {

/// It has this text in one of its places, or in those of a message in one of them.
bool says(const Message &message, std::string_view text)
{
    const auto arguments = message.arguments();
    return std::ranges::any_of(arguments, [text](const MessageArgument &argument) {
        const auto *const inner = std::get_if<Message>(&argument.value);
        const auto *const words = std::get_if<std::string>(&argument.value);
        return inner ? says(*inner, text) : words && *words == text;
    });
}

} // namespace

Error errorOf(const TransferOutcome &outcome, std::string_view key)
{
    Error error = outcome.raw.error();
    if (error.detail.empty())
        error.detail = Message::verbatim(std::string(toString(error.fault)));
    return says(error.detail, key) ? error : error.about(key);
}

std::vector<ParameterIndex> readable(const Device &device)
{
    std::vector<ParameterIndex> indices;
    const auto table = device.parameters().table();
    for (std::uint16_t i = 0; i < table.size(); ++i) {
        if (table[i].access != Access::WriteOnly && device.offers({i}))
            indices.push_back({i});
    }
    return indices;
}

Task<std::vector<TransferOutcome>> readParameters(
    Device &device, std::vector<ParameterIndex> indices, Progress &progress)
{
    std::vector<TransferOutcome> outcomes;
    const int total = static_cast<int>(indices.size());
    for (const ParameterIndex index : indices) {
        progress.step(
            say("Reading %1", device.parameters().parameter(index).key), static_cast<int>(outcomes.size()), total);
        Result<std::int64_t> raw = co_await device.read(index).attempt();
        const bool silent = !raw && raw.error().fault == Fault::Timeout && !device.liveness().heard;
        const bool lost = silent || (!raw && raw.error().fault == Fault::LinkLost);
        outcomes.push_back({index, std::move(raw), std::nullopt});
        if (lost)
            break;
    }
    progress.step(say("Read"), static_cast<int>(outcomes.size()), total);
    co_return outcomes;
}

namespace {

constexpr Duration latestAnswer = std::chrono::milliseconds(250);

/// Anything but 0 clears it, 0 leaves it as it is. What counts on meanwhile is told as it is: it is not clear.
Task<TransferOutcome> afterClear(Device &device, ParameterChange change)
{
    const Parameter &parameter = device.parameters().parameter(change.index);
    TransferOutcome outcome{change.index, 0, std::nullopt};
    outcome.raw = co_await device.read(change.index).attempt();
    if (!outcome.raw)
        co_return outcome;
    outcome.verified = change.raw == 0 || *outcome.raw == 0;
    if (!*outcome.verified)
        outcome.raw
            = fail(Fault::BadCheck, say("%1 was cleared but reads %2", parameter.key, toText(parameter, *outcome.raw)),
                say("its cause is there again, or still"));
    co_return outcome;
}

Task<TransferOutcome> writeOne(Device &device, ParameterChange change)
{
    const Parameter &parameter = device.parameters().parameter(change.index);
    TransferOutcome outcome{change.index, 0, std::nullopt};
    outcome.raw = co_await device.write(change.index, change.raw).attempt();
    if (!outcome.raw || parameter.access == Access::WriteOnly || parameter.afterRestart)
        co_return outcome;
    if (parameter.nature == Nature::Counter) {
        TransferOutcome cleared = co_await afterClear(device, change);
        co_return cleared;
    }
    Result<std::int64_t> back = co_await device.read(change.index).attempt();
    if (back && *back != change.raw && parameter.nature != Nature::Live) {
        co_await Sleep(device.clock(), latestAnswer); // that may have been the answer to an earlier question
        back = co_await device.read(change.index).attempt();
    }
    if (!back) {
        outcome.raw = fail(back.error());
        co_return outcome;
    }
    outcome.raw = *back;
    outcome.verified = parameter.nature == Nature::Live || *back == change.raw;
    if (!*outcome.verified)
        outcome.raw = fail(Fault::BadCheck,
            say("%1 was written as %2 but reads %3", parameter.key, toText(parameter, change.raw),
                toText(parameter, *back)));
    co_return outcome;
}

/// Of changes in the order of writing, which outlive the task.
Task<std::optional<TransferOutcome>> firstRefused(Device &device, std::span<const ParameterChange> arranged)
{
    for (std::size_t i = 0; i < arranged.size(); ++i) {
        const ParameterChange change = arranged[i];
        const Result<void> allowed = co_await device.mayWrite(change.index, change.raw, arranged.first(i)).attempt();
        if (!allowed)
            co_return TransferOutcome{change.index, fail(allowed.error()), std::nullopt};
    }
    co_return std::nullopt;
}

} // namespace

Task<std::optional<TransferOutcome>> findRefused(Device &device, std::vector<ParameterChange> changes)
{
    arrangeForWriting(device.family(), device.parameters(), changes);
    co_return co_await firstRefused(device, changes);
}

Task<std::vector<TransferOutcome>> writeParameters(
    Device &device, std::vector<ParameterChange> changes, Progress &progress)
{
    std::vector<TransferOutcome> outcomes;
    arrangeForWriting(device.family(), device.parameters(), changes);
    if (changes.size() > 1) { // the write of one asks by itself
        if (auto refused = co_await firstRefused(device, changes)) {
            outcomes.push_back(std::move(*refused));
            co_return outcomes;
        }
    }
    const int total = static_cast<int>(changes.size());
    for (const ParameterChange change : changes) {
        const std::string key(device.parameters().parameter(change.index).key);
        progress.step(say("Writing %1", key), static_cast<int>(outcomes.size()), total);
        TransferOutcome outcome = co_await writeOne(device, change);
        const bool failed = !outcome.raw; // who asked for it says so
        outcomes.push_back(std::move(outcome));
        if (failed)
            break;
    }
    progress.step(say("Written"), static_cast<int>(outcomes.size()), total);
    co_return outcomes;
}

std::vector<ParameterChange> lostSettings(const Family &family, const DeviceProfile &profile)
{
    std::vector<ParameterChange> lost;
    for (std::uint16_t i = 0; i < family.parameters.size(); ++i) {
        const std::string key(family.parameters[i].key);
        const auto raw = profile.written.find(key);
        if (profile.lost.contains(key) && raw != profile.written.end() && isLegal(family.parameters[i], raw->second))
            lost.push_back({{i}, raw->second});
    }
    return lost;
}

Task<int> rewriteSettings(Device &device, Progress &progress)
{
    if (device.liveness().moving)
        co_return fail(Fault::Unsafe, say("stop the motors before settings are written again"));
    if (device.liveness().restarted) { // noticed, and nobody has looked at it since
        co_await device.refresh();
    }
    const std::vector<ParameterChange> lost = lostSettings(device.family(), device.knowledge().profile());
    const int total = static_cast<int>(lost.size());
    for (int i = 0; i < total; ++i) {
        const ParameterChange &change = lost[static_cast<std::size_t>(i)];
        const std::string key(device.parameters().parameter(change.index).key);
        progress.step(say("Writing %1", key), i, total);
        const TransferOutcome outcome = co_await writeOne(device, change);
        if (!outcome.raw)
            co_return fail(outcome.raw.error().fault,
                say("%1 of %2 settings were written again; %3: %4", i, total, key, outcome.raw.error().message()),
                say("what is missing is still unknown, do it again"));
        if (device.liveness().restarted)
            co_return fail(Fault::Refused,
                say("%1 of %2 settings were written again; then the board was reset once more", i, total),
                say("do it again"));
    }
    progress.step(say("Written"), total, total);
    progress.log(Severity::Good, say("%1 settings written again", total));
    co_return total;
}

} // namespace mb
