// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"

#include "model/axis.h"
#include "model/registry.h"

namespace mb {

std::string_view toString(UpdateOutcome outcome)
{
    switch (outcome) {
    case UpdateOutcome::Done: return "done";
    case UpdateOutcome::UpToDate: return "up-to-date";
    case UpdateOutcome::Refused: return "refused";
    case UpdateOutcome::Failed: return "failed";
    case UpdateOutcome::Cancelled: return "cancelled";
    }
    return "";
}

UpdateReport unfinished(const UpdateStanding &standing, const Error &error)
{
    UpdateReport report;
    report.outcome = error.fault == Fault::Cancelled ? UpdateOutcome::Cancelled : UpdateOutcome::Failed;
    report.from = standing.from;
    report.pages = standing.pages;
    report.retries = standing.retries;
    report.evidence = error.detail;
    report.remedy = error.help();
    report.fault = error.fault;
    return report;
}

const Family *findFamily(std::span<const Family *const> families, std::string_view key)
{
    for (const Family *family : families) {
        if (family->key == key)
            return family;
    }
    return nullptr;
}

bool isDemoUnit(const Family &family, int address, int DemoUnits::*which)
{
    return family.demo && family.demo->*which != 0 && family.demo->*which == address;
}

double usualRange(std::span<const ModeRange> ranges, Mode mode)
{
    for (const ModeRange &range : ranges) {
        if (range.mode == mode)
            return range.usual;
    }
    switch (mode) {
    case Mode::Duty: return 1.0;
    case Mode::Velocity:
    case Mode::RampVelocity: return 100e3;
    case Mode::Position:
    case Mode::RampPosition: return 40960.0;
    case Mode::Current: return 20.0;
    case Mode::Voltage: return 12.0;
    case Mode::Follow:
    case Mode::Off: break;
    }
    return 0.0;
}

const UpdateWords &updateWords(const Family &family)
{
    return family.routes.empty() ? family.updateWords : family.routes.front().words;
}

const FaultRow *findFault(const Family &family, std::string_view key)
{
    const std::string_view own = axisOf(key) > 0 ? key.substr(key.find('.') + 1) : key;
    for (const FaultRow &row : family.faults) {
        if (row.key == own)
            return &row;
    }
    return nullptr;
}

} // namespace mb
