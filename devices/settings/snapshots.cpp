// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/snapshots.h"

#include "model/family.h"
#include "model/parameterfile.h"
#include "model/unit.h"
#include "settings/storing.h"

#include <QJsonDocument>

#include <algorithm>

namespace mb::settings {

std::vector<ParameterIndex> offered(const Device &device)
{
    std::vector<ParameterIndex> indices;
    for (std::uint16_t i = 0; i < device.parameters().table().size(); ++i) {
        if (device.offers({i}))
            indices.push_back({i});
    }
    return indices;
}

ParameterSnapshot describe(const Device &device, Occasion occasion, std::string name)
{
    const std::vector<ParameterIndex> indices = offered(device);
    ParameterSnapshot snapshot;
    snapshot.unit = unitKeyOf(device);
    snapshot.device = device.selector();
    snapshot.family = device.family().key;
    snapshot.serial = device.identity().serial;
    snapshot.firmware = device.identity().firmware;
    snapshot.name = name.empty() ? std::string(usualName(occasion)) : std::move(name);
    snapshot.occasion = occasion;
    snapshot.count = static_cast<int>(std::ranges::count_if(indices, [&device](ParameterIndex index) {
        const ParameterStore::Entry &entry = device.parameters().entry(index);
        return entry.raw && entry.state != ParameterState::Failed;
    }));
    snapshot.file = QJsonDocument(parametersToJson(device, indices)).toJson(QJsonDocument::Compact).toStdString();
    return snapshot;
}

Task<ParameterSnapshot> takeSnapshot(
    Device &device, Occasion occasion, std::string name, SettingsLog &log, Progress &progress)
{
    const std::vector<ParameterIndex> indices = readable(device);
    const std::vector<TransferOutcome> outcomes = co_await readKept(device, indices, &log, progress);
    const bool any
        = std::ranges::any_of(outcomes, [](const TransferOutcome &outcome) { return outcome.raw.has_value(); });
    if (!outcomes.empty() && !outcomes.back().raw && (outcomes.size() < indices.size() || !any))
        co_return fail(outcomes.back().raw.error());
    co_return co_await log.keep(describe(device, occasion, std::move(name)));
}

Error keepsNothing(const Error &trouble)
{
    return {Fault::NotKept, say("nothing was written, because what is there cannot be kept: %1", trouble.detail),
        trouble.help()};
}

} // namespace mb::settings
