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

/// Files that follow each other, in one writer: a topic of several in one unit is one channel, of their facts the last counts.
class Joint {
public:
    explicit Joint(McapWriter &writer)
        : m_writer(writer)
    {
    }

    /// False for a file that was cut before its first channel: it has nothing.
    bool add(const std::string &path)
    {
        std::map<std::uint16_t, std::uint16_t> ids;
        McapReader reader;
        reader.channel = [&](std::uint16_t id, const std::string &topic, const mcap::Map &about) {
            const auto unit = about.find("unit");
            const std::pair key(topic, unit == about.end() ? std::string() : unit->second);
            const auto known = m_channels.find(key);
            ids[id] = known != m_channels.end() ? known->second : m_writer.addChannel({topic, about});
            m_channels[key] = ids[id];
        };
        reader.metadata = [&](const std::string &name, const mcap::Map &map) {
            if (name == "note")
                m_writer.metadata(name, map);
            else
                m_facts[name] = map;
        };
        reader.sample = [&](std::uint16_t id, std::int64_t time, double value, std::uint64_t lost, bool gap) {
            m_writer.write(ids[id], time, value, lost, gap);
            ++m_report.samples;
            m_report.lost += lost;
        };
        return static_cast<bool>(reader.read(path));
    }
    void addFacts()
    {
        for (const auto &[name, map] : m_facts)
            m_writer.metadata(name, map);
    }
    [[nodiscard]] const ExportReport &report() const { return m_report; }

private:
    McapWriter &m_writer;
    ExportReport m_report;
    std::map<std::pair<std::string, std::string>, std::uint16_t> m_channels; ///< by topic and unit
    std::map<std::string, mcap::Map> m_facts;
};

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
    Joint joint(**writer);
    bool anything = false;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(paths.size())))
            return fail(Fault::Cancelled);
        anything = joint.add(paths[i]) || anything;
    }
    if (!anything)
        return fail(Fault::Unsupported, say("nothing has been recorded yet"));
    joint.addFacts();
    if (auto finished = (*writer)->finish(); !finished)
        return fail(finished.error());
    writer->reset();
    if (auto moved = place.commit(); !moved)
        return fail(moved.error());
    return joint.report();
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
