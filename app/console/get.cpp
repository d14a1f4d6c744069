// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"
#include "app/console/parameterrows.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "async/outputfile.h"

#include <QJsonDocument>

#include <algorithm>
#include <memory>

namespace mb::console {
namespace {

struct GetArguments {
    std::string device;
    std::vector<std::string> keys;
    std::string file;
};

Result<std::vector<ParameterIndex>> parseKeys(const Family &family, const std::vector<std::string> &keys)
{
    std::vector<ParameterIndex> indices;
    for (const std::string &key : keys) {
        MB_TRY(const auto index, parseKey(family, key));
        if (family.parameters[index.value].access == Access::WriteOnly)
            return fail(Fault::OutOfRange, say("%1 can only be written", key), say("leave it out"));
        if (std::ranges::find(indices, index) == indices.end())
            indices.push_back(index);
    }
    return indices;
}

/// What cannot be read is shown as far as it is known: last written, or not at all.
void addWriteOnly(const Device &device, std::vector<ParameterIndex> &indices)
{
    const auto table = device.parameters().table();
    for (std::uint16_t i = 0; i < table.size(); ++i) {
        if (table[i].access == Access::WriteOnly && device.offers({i}))
            indices.push_back({i});
    }
    std::ranges::sort(indices);
}

/// What was read is printed with its failures in it; a file is written only when it is complete.
Task<int> show(Console &console, Device &device, std::vector<ParameterIndex> indices, OutputFile *file,
    std::string name, std::optional<Error> error)
{
    const QJsonObject object = parametersToJson(device, indices);
    const QByteArray text = QJsonDocument(object).toJson(QJsonDocument::Indented);
    if (file && !error) {
        file->write({text.constData(), static_cast<std::size_t>(text.size())});
        co_await file->commit();
        console.note(std::to_string(indices.size()) + " parameters of " + device.selector() + " saved to " + name);
    }
    if (console.json())
        console.out().json(object);
    else if (name == "-")
        console.out().line({text.constData(), static_cast<std::size_t>(text.size() - 1)}); // which ends with one
    else if (!file)
        printParameters(console, device, indices);
    if (!error)
        co_return exitDone;
    co_return console.fails(*error);
}

Task<int> get(Console &console, GetArguments arguments)
{
    const auto target = co_await parseTarget(console, arguments.device);
    auto indices = co_await parseKeys(*target.family, arguments.keys);
    std::unique_ptr<OutputFile> file;
    if (!arguments.file.empty() && arguments.file != "-")
        file = std::make_unique<OutputFile>(arguments.file);
    if (auto opened = file ? file->open() : Result<void>(); !opened) // before anything is asked for
        co_return fail(opened.error());
    Device *const device = co_await connect(console, target);
    co_await needsApplication(*device);
    if (arguments.keys.empty())
        indices = readable(*device);
    co_await noteOwed(console, *device);
    const std::vector<TransferOutcome> outcomes = co_await readKept(console, *device, indices);
    const auto error = firstError(*device, outcomes);
    const bool any
        = std::ranges::any_of(outcomes, [](const TransferOutcome &outcome) { return outcome.raw.has_value(); });
    if (error && (!any || outcomes.size() < indices.size()))
        co_return fail(*error);
    if (arguments.keys.empty())
        addWriteOnly(*device, indices);
    co_return co_await show(console, *device, indices, file.get(), arguments.file, error);
}

} // namespace

Job declareGet(CLI::App &arguments)
{
    const auto a = std::make_shared<GetArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("key", a->keys, "What to read; all that can be read by default");
    arguments.add_option("--file", a->file, "Save to this file instead of printing; - is standard output");
    return [a](Console &console) { return get(console, *a); };
}

} // namespace mb::console
