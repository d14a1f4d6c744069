// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/loadrecording.h"

#include "recording/loadtable.h"
#include "recording/mcapreader.h"

#include <algorithm>
#include <filesystem>

namespace mb {
namespace {

constexpr std::size_t mostAbout = 64U << 20U;                    // bytes of what a file tells of itself
constexpr std::int64_t farthestTime = 4'500'000'000'000'000'000; // ns: between any two of these there are 63 bits

bool endsWith(std::string_view text, std::string_view end)
{
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

std::size_t bytesOf(const mcap::Map &facts)
{
    std::size_t sum = 0;
    for (const auto &[key, text] : facts)
        sum += key.size() + text.size();
    return sum;
}

/// Another unit may have had the number before.
std::string freeTitle(const LoadedRecording &loaded, std::string title, const std::string &serial)
{
    const auto isTaken
        = [&] { return std::ranges::find(loaded.table, std::string_view(title), &Channel::key) != loaded.table.end(); };
    if (!serial.empty() && isTaken())
        title += ' ' + serial;
    if (isTaken())
        title += " (" + std::to_string(loaded.table.size() + 1) + ')';
    return title;
}

/// The second pass over a file, whose channels are known.
Result<void> readSamples(const std::string &path, LoadedRecording &loaded,
    std::map<std::uint16_t, std::uint16_t> &places, std::uint64_t mostSamples, std::size_t mostBytes)
{
    McapReader reader;
    bool isTooFar = false;
    std::uint64_t taken = 0;
    reader.enough = [&] { return loaded.shortened || isTooFar; };
    reader.sample = [&](std::uint16_t id, std::int64_t time, double value, std::uint64_t lost, bool gap) {
        isTooFar = isTooFar || time > farthestTime || time < -farthestTime;
        loaded.shortened = loaded.shortened || taken >= mostSamples
            || (taken % 4096 == 0 && loaded.telemetry->memoryUse() > mostBytes);
        if (isTooFar || loaded.shortened)
            return;
        ++taken;
        const ChannelIndex channel{places[id]};
        if (gap || lost > 0)
            loaded.telemetry->lost(channel, lost);
        loaded.telemetry->append({channel, Instant(std::chrono::nanoseconds(time)), value});
    };
    MB_TRY_VOID(reader.read(path));
    if (isTooFar)
        return fail(Fault::OutOfRange, say("%1 has a time that is more than 140 years from 1970", path),
            say("record with the clock set"));
    return {};
}

Result<std::shared_ptr<LoadedRecording>> loadMcap(
    const std::string &path, std::uint64_t mostSamples, std::size_t mostBytes)
{
    auto loaded = std::make_shared<LoadedRecording>();
    loaded->hasClock = true;
    // Twice: a table of channels has its size before the first sample.
    std::map<std::uint16_t, std::uint16_t> places;
    McapReader reader;
    reader.channel = [&](std::uint16_t id, const std::string &topic, const mcap::Map &about) {
        const auto fact = [&about](const char *key) {
            const auto found = about.find(key);
            return found == about.end() ? std::string() : found->second;
        };
        const std::string title = freeTitle(*loaded, fact("title").empty() ? topic : fact("title"), fact("serial"));
        loaded->simulated = loaded->simulated || fact("simulated") == "true";
        places[id] = static_cast<std::uint16_t>(loaded->table.size());
        addLoadedChannel(*loaded, title, fact("unit"));
    };
    std::size_t about = 0;
    reader.metadata = [&](const std::string &name, const mcap::Map &facts) {
        about += name.size() + bytesOf(facts);
        if (about <= mostAbout)
            loaded->about[name] = facts;
    };
    reader.enough = [&about] { return about > mostAbout; };
    const auto complete = reader.read(path);
    if (about > mostAbout)
        return fail(Fault::OutOfRange, say("%1 has more than %2 MB that are no samples", path, mostAbout >> 20U));
    if (!complete)
        return fail(complete.error());
    loaded->complete = *complete;
    loaded->telemetry = std::make_shared<Telemetry>(loaded->table);
    MB_TRY_VOID(readSamples(path, *loaded, places, mostSamples, mostBytes));
    return loaded;
}

} // namespace

RecordingTotals totalsOf(const LoadedRecording &recording)
{
    RecordingTotals totals;
    for (std::uint16_t i = 0; i < recording.table.size(); ++i) {
        totals.samples += recording.telemetry->size({i});
        totals.lost += recording.telemetry->lost({i});
    }
    totals.seconds = std::chrono::duration<double>(recording.last - recording.first).count();
    return totals;
}

Result<std::shared_ptr<const LoadedRecording>> loadRecording(
    const std::string &path, std::uint64_t mostSamples, std::size_t mostBytes)
{
    std::error_code error;
    if (const auto kind = std::filesystem::status(path, error);
        std::filesystem::is_character_file(kind) || std::filesystem::is_block_file(kind))
        return fail(Fault::OutOfRange, say("%1 is a device and has no end", path), say("name a recording"));
    MB_TRY(auto loaded,
        endsWith(path, ".mcap") ? loadMcap(path, mostSamples, mostBytes) : loadTable(path, mostSamples, mostBytes));
    LoadedRecording &recording = *loaded;
    recording.telemetry->commit();
    bool any = false;
    for (std::uint16_t i = 0; i < recording.table.size(); ++i) {
        const auto first = recording.telemetry->first({i});
        const auto last = recording.telemetry->last({i});
        if (!first)
            continue;
        recording.first = any ? std::min(recording.first, first->time) : first->time;
        recording.last = any ? std::max(recording.last, last->time) : last->time;
        any = true;
    }
    if (!any)
        return fail(Fault::OutOfRange, say("%1 has no samples", path));
    return std::shared_ptr<const LoadedRecording>(std::move(loaded));
}

} // namespace mb
