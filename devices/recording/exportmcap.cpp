// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/exportmcap.h"

#include "async/outputfile.h"
#include "model/parameter.h"
#include "recording/mcapwriter.h"
#include "recording/merge.h"

namespace mb {
namespace {

constexpr std::uint64_t lookEverySamples = 16384;

} // namespace

mcap::Map aboutChannel(const ExportChannel &channel)
{
    mcap::Map about{{"device", channel.device}, {"family", channel.family}, {"key", channel.key},
        {"unit", channel.unit}, {"title", channel.title()}};
    if (!channel.formula.empty())
        about["formula"] = channel.formula;
    if (channel.simulated)
        about["simulated"] = "true";
    if (!channel.serial.empty())
        about["serial"] = channel.serial;
    return about;
}

Result<ExportReport> exportMcap(const ExportPlan &plan, const std::string &path, const ExportProgress &progress)
{
    OutputFile place(path);
    MB_TRY_VOID(place.open());
    MB_TRY(auto writer, McapWriter::create(place));
    for (const auto &[name, facts] : plan.about)
        writer->metadata(name, facts);
    for (const auto &[name, facts] : lossOf(plan))
        writer->metadata(name, facts);
    for (const TimedNote &note : plan.notes)
        writer->metadata(
            "note", {{"time", std::to_string(plan.clock.unixTime(note.time).count())}, {"text", note.text}});
    std::vector<std::uint16_t> ids;
    for (const ExportChannel &channel : plan.channels)
        ids.push_back(writer->addChannel({channel.topic(), aboutChannel(channel)}));
    ExportReport report;
    MergedSamples samples(plan);
    const auto span = static_cast<double>(std::max<std::int64_t>((plan.to - plan.from).count(), 1));
    while (const auto next = samples.next()) {
        writer->write(ids[next->channel], plan.clock.unixTime(next->point.time).count(), next->point.value, next->lost,
            next->gap);
        report.lost += next->lost;
        if (++report.samples % lookEverySamples == 0 && progress
            && !progress(static_cast<double>((next->point.time - plan.from).count()) / span))
            return fail(Fault::Cancelled);
    }
    MB_TRY_VOID(writer->finish());
    writer.reset();
    MB_TRY_VOID(place.commit());
    return report;
}

} // namespace mb
