// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/export.h"

#include "model/family.h"
#include "model/identity.h"

#include <algorithm>

namespace mb {
namespace {

/// What a topic may be made of.
std::string plain(std::string_view text)
{
    std::string word;
    for (const char c : text) {
        const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        word += good ? c : c == '.' || c == '/' ? '/' : '_';
    }
    return word;
}

} // namespace

std::string ExportChannel::title() const
{
    return device.empty() ? key : std::string(partsOf(device).device) + ' ' + key;
}

std::string ExportChannel::topic() const
{
    if (device.empty())
        return "/derived/" + plain(key);
    const SelectorParts parts = partsOf(device);
    std::string link(parts.link);
    while (!link.empty() && link.back() == '/')
        link.pop_back();
    std::replace(link.begin(), link.end(), '/', '_');
    std::replace(link.begin(), link.end(), '.', '_');
    return '/' + plain(link) + '/' + plain(parts.device) + '/' + plain(key);
}

std::vector<ExportChannel> channelsOf(const DeviceView &device, bool simulated)
{
    std::vector<ExportChannel> channels;
    for (std::uint16_t i = 0; i < device.channels().size(); ++i) {
        const Channel &row = device.channels()[i];
        channels.push_back({device.telemetry, {i}, device.selector, std::string(device.family->key),
            std::string(row.key), std::string(row.unit), {}, simulated, device.identity->serial});
    }
    return channels;
}

std::vector<std::pair<std::string, mcap::Map>> describe(const DeviceView &device)
{
    const Identity &identity = device.identity;
    mcap::Map facts{{"device", device.selector}, {"family", identity.family},
        {"title", std::string(device.family->title)}, {"address", std::to_string(identity.address)},
        {"state", std::string(toString(identity.state))}};
    const auto add = [&facts](const char *key, const std::string &text) {
        if (!text.empty())
            facts[key] = text;
    };
    add("session", identity.session ? std::to_string(*identity.session) : std::string());
    add("name", identity.name);
    add("serial", identity.serial);
    add("firmware", identity.firmware);
    add("bootloader", identity.bootloader);
    add("dialect", identity.dialect);
    for (const auto &[key, text] : identity.descriptors)
        facts["descriptor." + key] = text;
    mcap::Map parameters;
    for (std::size_t i = 0; i < device.parameters->size() && i < device.family->parameters.size(); ++i) {
        const Parameter &row = device.family->parameters[i];
        if (!(*device.parameters)[i].raw)
            continue;
        std::string text = toText(row, *(*device.parameters)[i].raw);
        if (!row.unit.empty())
            text += ' ' + std::string(row.unit);
        parameters[std::string(row.key)] = text;
    }
    const std::string whose = device.selector + (identity.serial.empty() ? "" : ' ' + identity.serial);
    return {{"device " + whose, facts}, {"parameters " + whose, parameters}};
}

std::map<std::string, mcap::Map> lossOf(const ExportPlan &plan)
{
    std::map<std::string, mcap::Map> loss;
    for (const ExportChannel &channel : plan.channels) {
        const auto found = channel.telemetry->statistics(channel.channel, plan.from, plan.to);
        const std::string owner = channel.device.empty() ? "derived" : channel.device;
        loss["loss " + owner][channel.key]
            = std::to_string(found ? found->lost : 0) + " of " + std::to_string(found ? found->count + found->lost : 0);
    }
    return loss;
}

} // namespace mb
