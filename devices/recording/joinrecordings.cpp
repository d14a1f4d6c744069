// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/joinrecordings.h"

#include "async/outputfile.h"
#include "recording/mcapreader.h"
#include "recording/mcapwriter.h"

#include <algorithm>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <unistd.h>

namespace mb {
namespace {

namespace fs = std::filesystem;

/// Whether the program that owns this folder still runs: it holds the lock.
bool isAlive(const fs::path &folder)
{
    const int file = ::open((folder / "lock").c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0)
        return true; // not ours to judge
    const bool free = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    ::close(file);
    return !free;
}

} // namespace

Result<ExportReport> joinRecordings(
    const std::vector<std::string> &paths, const std::string &path, const ExportProgress &progress)
{
    OutputFile place(path);
    if (auto opened = place.open(); !opened)
        return fail(opened.error());
    auto writer = McapWriter::create(place);
    if (!writer)
        return fail(writer.error());
    ExportReport report;
    std::map<std::string, std::uint16_t> topics;
    std::map<std::string, mcap::Map> facts;
    std::size_t readable = 0;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(paths.size())))
            return fail(Fault::Cancelled);
        std::map<std::uint16_t, std::uint16_t> ids;
        McapReader reader;
        reader.channel = [&](std::uint16_t id, const std::string &topic, const mcap::Map &about) {
            const auto known = topics.find(topic);
            ids[id] = known != topics.end() ? known->second : (*writer)->addChannel({topic, about});
            topics[topic] = ids[id];
        };
        reader.metadata = [&](const std::string &name, const mcap::Map &map) {
            if (name == "note")
                (*writer)->metadata(name, map);
            else
                facts[name] = map;
        };
        reader.sample = [&](std::uint16_t id, std::int64_t time, double value, std::uint64_t lost, bool gap) {
            (*writer)->write(ids[id], time, value, lost, gap);
            ++report.samples;
            report.lost += lost;
        };
        readable += reader.read(paths[i]) ? 1U : 0U; // one that was cut before its first channel has nothing
    }
    if (readable == 0)
        return fail(Fault::Unsupported, say("nothing has been recorded yet"));
    for (const auto &[name, map] : facts)
        (*writer)->metadata(name, map);
    if (auto finished = (*writer)->finish(); !finished)
        return fail(finished.error());
    writer->reset();
    if (auto moved = place.commit(); !moved)
        return fail(moved.error());
    return report;
}

Result<std::vector<std::string>> recoverRecordings(const std::string &folder)
{
    std::vector<std::string> recovered;
    std::error_code error;
    for (const fs::directory_entry &run : fs::directory_iterator(folder, error)) {
        if (!run.is_directory() || !fs::exists(run.path() / "lock") || isAlive(run.path()))
            continue;
        std::vector<std::string> paths;
        for (const fs::directory_entry &segment : fs::directory_iterator(run.path(), error)) {
            if (segment.path().extension() == ".mcap")
                paths.push_back(segment.path().string());
        }
        std::sort(paths.begin(), paths.end());
        const std::string path = folder + "/recovered-" + run.path().filename().string() + ".mcap";
        const auto joined = joinRecordings(paths, path, {});
        if (joined && joined->samples > 0)
            recovered.push_back(path);
        else if (!joined && joined.error().fault != Fault::Unsupported)
            return fail(joined.error()); // no room, perhaps: it stays for the next time
        else
            fs::remove(path, error);
        fs::remove_all(run.path(), error);
    }
    return recovered;
}

} // namespace mb
