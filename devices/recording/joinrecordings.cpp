// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/joinrecordings.h"

#include "async/descriptor.h"
#include "async/outputfile.h"
#include "recording/mcapreader.h"
#include "recording/mcapwriter.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <tuple>

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

/// False for a file that was cut before its first channel: it has nothing. Refused for one that cannot be read, now at least.
Result<bool> readWith(const McapReader &reader, const std::string &path)
{
    const auto read = reader.read(path);
    if (!read && read.error().fault == Fault::Refused)
        return fail(read.error());
    return read.has_value();
}

/// Files that follow each other, in one writer. Each is read twice: a channel has its serial number before its first sample.
class Joint {
public:
    explicit Joint(McapWriter &writer)
        : m_writer(writer)
    {
    }

    Result<bool> learn(const std::string &path)
    {
        McapReader reader;
        reader.channel = [&](std::uint16_t, const std::string &, const mcap::Map &about) {
            if (about.contains(trackFact) && about.contains("serial"))
                m_serials[about.at(trackFact)] = about.at("serial");
        };
        return readWith(reader, path);
    }
    Result<bool> add(const std::string &path)
    {
        std::map<std::uint16_t, std::uint16_t> ids;
        McapReader reader;
        reader.channel = [&](std::uint16_t id, const std::string &topic, mcap::Map about) {
            if (const auto told = m_serials.find(factOf(about, trackFact)); told != m_serials.end())
                about["serial"] = told->second;
            about.erase(trackFact);
            const auto [known, isNew]
                = m_ids.try_emplace({topic, factOf(about, "unit"), factOf(about, "serial")}, std::uint16_t{0});
            if (isNew)
                known->second = m_writer.addChannel({topic, std::move(about)});
            ids[id] = known->second;
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
        return readWith(reader, path);
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
    std::map<std::string, std::string> m_serials;                                     ///< by trackFact
    std::map<std::tuple<std::string, std::string, std::string>, std::uint16_t> m_ids; ///< by topic, unit, serial number
    std::map<std::string, mcap::Map> m_facts;
};

} // namespace

Result<ExportReport> joinRecordings(
    const std::vector<std::string> &paths, const std::string &path, const ExportProgress &progress)
{
    OutputFile place(path);
    MB_TRY_VOID(place.open());
    MB_TRY(auto writer, McapWriter::create(place));
    Joint joint(*writer);
    bool anything = false;
    const std::size_t steps = 2 * paths.size();
    for (std::size_t i = 0; i < steps; ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(steps)))
            return fail(Fault::Cancelled);
        MB_TRY(const auto read, i < paths.size() ? joint.learn(paths[i]) : joint.add(paths[i - paths.size()]));
        anything = anything || read;
    }
    if (!anything)
        return fail(Fault::Unsupported, say("nothing has been recorded yet"));
    joint.addFacts();
    MB_TRY_VOID(writer->finish());
    writer.reset();
    MB_TRY_VOID(place.commit());
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
