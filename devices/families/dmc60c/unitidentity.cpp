// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/unitidentity.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace mb::dmc60c {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

constexpr std::array<std::pair<Descriptor, std::string_view>, 6> names{{
    {Descriptor::DevName, "name"},
    {Descriptor::ManName, "manufacturer"},
    {Descriptor::ProdName, "product"},
    {Descriptor::ManDate, "date"},
    {Descriptor::HardwareVer, "hardware"},
    {Descriptor::SN, "serial"},
}};

bool isOwn(const std::string &key)
{
    return key == "product_id" || key == "application_version" || key == "bootloader_version";
}

void setEntry(Entries &entries, std::string_view key, std::string text)
{
    const auto found = std::ranges::find_if(entries, [&](const auto &entry) { return entry.first == key; });
    if (found != entries.end())
        found->second = std::move(text);
    else
        entries.emplace_back(key, std::move(text));
}

/// "1.23 (0x0117)": whether the minor is binary or BCD is not documented.
std::string withHex(std::uint16_t version)
{
    std::array<char, 16> hex{};
    std::snprintf(hex.data(), hex.size(), "0x%04X", static_cast<unsigned>(version));
    return version == noApplication ? "none (" + std::string(hex.data()) + ')'
                                    : versionText(version) + " (" + hex.data() + ')';
}

Message detailOf(DeviceState state, bool hasApplication)
{
    switch (state) {
    case DeviceState::Unassigned:
        return hasApplication
            ? say("This unit has no number yet; assign one from 1 to 63.")
            : say("This unit has no number and no application; assign a number, then update its firmware.");
    case DeviceState::Bootloader:
        return hasApplication ? say("The bootloader runs; restart the unit or update its firmware.")
                              : say("No application runs; update its firmware.");
    case DeviceState::Duplicate:
    case DeviceState::Online: break;
    }
    return {};
}

} // namespace

std::optional<Identity> recognise(const CanFrame &frame)
{
    const auto first = decodeEnumResponse0(frame);
    const auto second = decodeEnumResponse1(frame);
    if (!first && !second && !decodeStatusGeneral(frame) && !decodeStatusEncoder(frame) && !decodeStatusAnalog(frame)
        && !decodeParamResponse(frame) && !decodeVendorStatus(frame))
        return std::nullopt;
    Identity identity;
    identity.family = "dmc60c";
    identity.address = deviceOf(frame);
    identity.state = identity.address == 0 ? DeviceState::Unassigned : DeviceState::Online;
    if (first)
        identity.session = first->session;
    if (second) {
        identity.session = second->session;
        setVersions(identity, {second->image, second->application, second->bootloader});
    }
    return identity;
}

Identity identityOf(const EnumResponse0 &first, const EnumResponse1 &second)
{
    Identity identity;
    identity.family = "dmc60c";
    identity.address = first.device;
    identity.session = first.session;
    setVersions(identity, {second.image, second.application, second.bootloader});
    std::array<char, 16> hex{};
    std::snprintf(hex.data(), hex.size(), "0x%08X", static_cast<unsigned>(first.productId));
    setEntry(identity.descriptors, "product_id", hex.data());
    if (first.productId >> 20U != productDmc60c) {
        const Message warning = say("Product %1 is not known to be a DMC60C.", hex.data());
        identity.detail = identity.detail.empty() ? warning : say("%1 %2", identity.detail, warning);
    }
    return identity;
}

void setVersions(Identity &identity, const FirmwareVersions &versions)
{
    const bool hasApplication = versions.application != noApplication;
    identity.firmware = versionText(versions.application);
    identity.bootloader = versionText(versions.bootloader);
    setEntry(identity.descriptors, "application_version", withHex(versions.application));
    setEntry(identity.descriptors, "bootloader_version", withHex(versions.bootloader));
    if (identity.state == DeviceState::Duplicate)
        return;
    const bool boot = versions.image != ImageType::Application || !hasApplication;
    identity.state = identity.address == 0 ? DeviceState::Unassigned
        : boot                             ? DeviceState::Bootloader
                                           : DeviceState::Online;
    identity.detail = detailOf(identity.state, hasApplication);
}

void setDescriptors(Identity &identity, const DescriptorList &list)
{
    Entries entries;
    for (const auto &[field, text] : list) {
        const auto name = std::ranges::find_if(
            names, [f = field](const auto &n) { return static_cast<std::uint8_t>(n.first) == f; });
        if (name != names.end())
            setEntry(entries, name->second, text);
        if (field == static_cast<std::uint8_t>(Descriptor::DevName))
            identity.name = text;
        else if (field == static_cast<std::uint8_t>(Descriptor::SN))
            identity.serial = text;
    }
    for (const auto &entry : identity.descriptors) {
        if (isOwn(entry.first))
            entries.push_back(entry);
    }
    identity.descriptors = std::move(entries);
}

void carryDescriptors(Identity &to, const Identity &from)
{
    Entries entries;
    for (const auto &entry : from.descriptors) {
        if (!isOwn(entry.first))
            entries.push_back(entry);
    }
    entries.insert(entries.end(), to.descriptors.begin(), to.descriptors.end());
    to.descriptors = std::move(entries);
    to.name = from.name;
    to.serial = from.serial;
}

void markDuplicate(Identity &identity, int units)
{
    identity.state = DeviceState::Duplicate;
    identity.detail
        = say("Number %1 is used by %2 units; give each its own before one is driven.", identity.address, units);
}

} // namespace mb::dmc60c
