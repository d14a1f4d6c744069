// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/firmware.h"

#include "families/dmc60c/updater.h"

namespace mb::dmc60c {

Result<ImageSummary> inspect(const FirmwareImage &image)
{
    MB_TRY(const auto application, applicationFrom(image));
    ImageSummary summary;
    summary.version = versionText(application.version);
    for (const Page &page : application.pages)
        summary.parts.push_back(page.number);
    summary.criticalPart = firstPage;
    summary.notes = application.notes;
    return summary;
}

Task<UpdateReport> update(Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress)
{
    if (!options.via.empty() || !options.target.empty())
        co_return fail(
            Fault::Unsupported, say("a DMC60C is updated over its own link"), say("leave the other way in out"));
    const auto application = applicationFrom(image);
    if (!application) {
        UpdateReport report;
        report.outcome = UpdateOutcome::Refused;
        report.evidence = application.error().detail;
        report.remedy = application.error().help();
        report.fault = application.error().fault;
        co_return report;
    }
    Updater updater(device, *application, progress);
    UpdateReport report = co_await updater.run(std::move(options));
    co_return report;
}

} // namespace mb::dmc60c
