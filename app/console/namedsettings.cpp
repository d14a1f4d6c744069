// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/namedsettings.h"

#include "files/filebytes.h"
#include "model/registry.h"

namespace mb::console {
namespace {

constexpr std::string_view snapshotScheme = "snapshot:";
constexpr std::int64_t mostBytes = 1 << 20;

/// A path may have a colon behind its last slash, too: only a known family makes it a device.
bool looksLikeDevice(const Console &console, const std::string &text)
{
    const auto selector = DeviceSelector::parse(text);
    return selector && findFamily(console.families(), selector->family);
}

} // namespace

Result<NamedSettings> parseSettings(const Console &console, const std::string &text)
{
    using Kind = NamedSettings::Kind;
    if (text == "defaults")
        return NamedSettings{Kind::Defaults, text, std::nullopt};
    if (text.starts_with(snapshotScheme)) {
        const std::string name = text.substr(snapshotScheme.size());
        if (name.empty())
            return fail(Fault::Usage, say("a snapshot is named after the colon"), say("such as \"snapshot:as found\""));
        return NamedSettings{Kind::Snapshot, name, std::nullopt};
    }
    if (!looksLikeDevice(console, text))
        return NamedSettings{Kind::File, text, std::nullopt};
    MB_TRY(auto target, parseTarget(console, text));
    return NamedSettings{Kind::Device, text, std::move(target)};
}

Result<QByteArray> loadSettings(const NamedSettings &named, Notebook *notebook, const std::string &unit)
{
    if (named.kind == NamedSettings::Kind::File)
        return loadFile(named.text, mostBytes);
    if (notebook->trouble())
        return fail(*notebook->trouble());
    const auto snapshot = notebook->settings()->find(named.text, unit);
    if (!snapshot)
        return fail(Fault::Usage, snapshot.error().detail, snapshot.error().remedy);
    return QByteArray::fromStdString(snapshot->file);
}

} // namespace mb::console
