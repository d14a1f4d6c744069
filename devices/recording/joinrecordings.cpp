// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/joinrecordings.h"

#include "async/descriptor.h"
#include "async/outputfile.h"
#include "recording/mcapreader.h"
#include "recording/mcapwriter.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace mb {
namespace {

namespace fs = std::filesystem;

/// The lock of a folder whose program does not run any more, so that nobody else recovers it meanwhile; none of one that is not
/// ours to judge.
std::unique_ptr<Descriptor> claim(const fs::path &folder)
{
    const fs::path path = folder / "lock";
    auto file = std::make_unique<Descriptor>(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    if (file->get() < 0 || ::flock(file->get(), LOCK_EX | LOCK_NB) != 0 || ::access(path.c_str(), F_OK) != 0)
        return nullptr;
    return file;
}

std::string factOf(const mcap::Map &about, const char *key)
{
    const auto found = about.find(key);
    return found == about.end() ? std::string() : found->second;
}

/// Files that follow each other, in one writer: a topic of several in one unit and of one serial number is one channel, of their facts
/// the last counts.
class Joint {
public:
    explicit Joint(McapWriter &writer)
        : m_writer(writer)
    {
    }

    /// False for a file that was cut before its first channel: it has nothing. Refused for one that cannot be read, now at least.
    Result<bool> add(const std::string &path)
    {
        std::map<std::uint16_t, std::uint16_t> ids;
        McapReader reader;
        reader.channel = [&](std::uint16_t id, const std::string &topic, const mcap::Map &about) {
            const auto known
                = std::ranges::find_if(m_channels, [&](const Channel &channel) { return channel.isOf(topic, about); });
            if (known == m_channels.end()) {
                ids[id] = m_writer.addChannel({topic, about});
                m_channels.push_back({topic, about, ids[id]});
                return;
            }
            ids[id] = known->id;
            if (factOf(known->about, "serial").empty())
                known->about = about;
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
        const auto read = reader.read(path);
        if (!read && read.error().fault == Fault::Refused)
            return fail(read.error());
        return read.has_value();
    }
    void addFacts()
    {
        for (const auto &[name, map] : m_facts)
            m_writer.metadata(name, map);
    }
    [[nodiscard]] const ExportReport &report() const { return m_report; }

private:
    struct Channel {
        std::string topic;
        mcap::Map about;
        std::uint16_t id = 0;
        /// It may not have told its serial number in the one or the other.
        [[nodiscard]] bool isOf(const std::string &other, const mcap::Map &facts) const
        {
            const std::string serial = factOf(facts, "serial");
            const std::string known = factOf(about, "serial");
            return topic == other && factOf(about, "unit") == factOf(facts, "unit")
                && (known == serial || known.empty() || serial.empty());
        }
    };
    McapWriter &m_writer;
    ExportReport m_report;
    std::vector<Channel> m_channels;
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
        const auto added = joint.add(paths[i]);
        if (!added)
            return fail(added.error());
        anything = anything || *added;
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

Recovered recoverRecordings(const std::string &folder)
{
    Recovered recovered;
    std::error_code error;
    std::vector<fs::path> runs;
    for (fs::directory_iterator run(folder, error); !error && run != fs::directory_iterator(); run.increment(error))
        runs.push_back(run->path());
    for (const fs::path &run : runs) {
        const auto lock = claim(run);
        if (!lock)
            continue;
        std::vector<std::string> paths;
        for (fs::directory_iterator file(run, error); !error && file != fs::directory_iterator();
             file.increment(error)) {
            if (file->path().extension() == ".mcap")
                paths.push_back(file->path().string());
        }
        std::ranges::sort(paths);
        const std::string path = folder + "/recovered-" + run.filename().string() + ".mcap";
        const auto joined = joinRecordings(paths, path, {});
        if (!joined && joined.error().fault != Fault::Unsupported) { // no room, perhaps: it stays for the next time
            recovered.failures.push_back(joined.error());
            continue;
        }
        if (joined && joined->samples > 0)
            recovered.paths.push_back(path);
        else if (joined)
            fs::remove(path, error);
        fs::remove_all(run, error);
    }
    return recovered;
}

} // namespace mb
