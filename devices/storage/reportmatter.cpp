// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/reportmatter.h"

#include "storage/unittags.h"
#include "storage/visittable.h"

#include "model/family.h"
#include "model/unit.h"

#include <algorithm>
#include <tuple>

namespace mb {
namespace {

Result<void> addSignals(TrialBook &book, tuning::Trial &trial)
{
    if (!trial.number)
        return {};
    MB_TRY(auto signals, book.signals(*trial.number));
    trial.signals = std::move(signals);
    return {};
}

bool isIn(const std::vector<std::int64_t> &numbers, std::int64_t number)
{
    return std::ranges::find(numbers, number) != numbers.end();
}

/// Of each loop the last one.
template <class Item, class Place> std::vector<Item> newestOf(const std::vector<Item> &items, const Place &placeOf)
{
    std::vector<Item> last;
    for (auto item = items.rbegin(); item != items.rend(); ++item) {
        const auto same = [&](const Item &other) { return placeOf(other) == placeOf(*item); };
        if (std::ranges::none_of(last, same))
            last.push_back(*item);
    }
    return last;
}

/// The sines that were made last, one after the other, each quicker than the one before; of those that were asked for, where any were.
std::vector<KeptTrial> newestSweep(const std::vector<KeptTrial> &history, const std::vector<std::int64_t> &asked)
{
    std::vector<KeptTrial> sines;
    for (const KeptTrial &kept : history) {
        const tuning::Stimulus &stimulus = kept.trial.stimulus;
        const bool isSine = kept.trial.mode == Mode::Duty && stimulus.profile == tuning::Profile::Sine
            && kept.trial.reason == tuning::EndReason::Done && (asked.empty() || isIn(asked, kept.number));
        if (!isSine)
            continue;
        const bool goesOn = !sines.empty() && stimulus.period < sines.back().trial.stimulus.period
            && kept.trial.axis == sines.back().trial.axis;
        if (!goesOn)
            sines.clear();
        sines.push_back(kept);
    }
    return sines;
}

/// The journal knows a unit without a serial number by the place where it came, and by the number that it has given it there.
std::string unitOf(Database &database, const service::Visit &visit)
{
    const std::string &came = visit.unit;
    const bool moved = visit.number && unitByOf(came) == UnitBy::Place;
    return resolvedUnit(database, moved ? renumberedPlaceKey(came, *visit.number) : came);
}

/// Until one, if that is named: what came after it is no matter of its report. On a place another unit may have come each time.
void addVisits(Database &database, ReportUnit &unit, const std::string &last)
{
    service::VisitFilter served;
    const bool isPlaced = unitByOf(unit.unit) != UnitBy::Serial;
    if (!isPlaced)
        served.unit = unit.unit;
    if (auto visits = getVisits(database, served)) { // a file that is read only may be older than they are
        for (KeptVisit &kept : *visits) {
            const bool isLast = kept.visit.id == last;
            if (isPlaced && !last.empty() ? isLast : unitOf(database, kept.visit) == unit.unit)
                unit.visits.push_back(std::move(kept.visit));
            if (isLast)
                break;
        }
    }
}

Result<void> addTunings(TrialBook &book, ReportUnit &unit, const std::vector<std::int64_t> &asked)
{
    MB_TRY(auto tunings, book.tuningsOf(unit.unit));
    if (asked.empty()) {
        unit.tunings
            = newestOf(tunings, [](const KeptTuning &kept) { return std::tuple(kept.report.loop, kept.report.axis); });
    } else {
        for (KeptTuning &kept : tunings) {
            if (std::ranges::any_of(asked, [&](std::int64_t n) { return isPartOf(n, kept.report); }))
                unit.tunings.push_back(std::move(kept));
        }
    }
    for (KeptTuning &kept : unit.tunings) {
        for (tuning::Trial &trial : kept.report.proof)
            MB_TRY_VOID(addSignals(book, trial));
    }
    return {};
}

/// The trials that no tuning of the report has shown.
std::vector<KeptTrial> shownTrials(const ReportUnit &unit, const ReportWish &wish)
{
    const std::vector<std::int64_t> &asked = wish.trials;
    std::vector<KeptTrial> full;
    for (const KeptTrial &kept : unit.history) {
        const bool told = std::ranges::any_of(
            unit.tunings, [&](const KeptTuning &tuned) { return isPartOf(kept.number, tuned.report); });
        if (asked.empty() ? !told && kept.trial.reason == tuning::EndReason::Done && kept.trial.mode != Mode::Duty
                          : isIn(asked, kept.number) && !(wish.tuningsOnly && told))
            full.push_back(kept);
    }
    return asked.empty()
        ? newestOf(full, [](const KeptTrial &kept) { return std::tuple(kept.trial.mode, kept.trial.axis); })
        : full;
}

/// History, and what of it stands in full: what was asked for, or the newest of each loop.
Result<void> fill(TrialBook &book, ReportUnit &unit, const ReportWish &wish)
{
    MB_TRY(auto history, book.listOf(unit.unit));
    unit.history = std::move(history);
    addVisits(book.database(), unit, wish.visit);
    MB_TRY_VOID(addTunings(book, unit, wish.trials));
    unit.trials = shownTrials(unit, wish);
    unit.sines = newestSweep(unit.history, wish.trials);
    for (std::vector<KeptTrial> *const shown : {&unit.sines, &unit.trials}) {
        for (KeptTrial &kept : *shown)
            MB_TRY_VOID(addSignals(book, kept.trial));
    }
    return {};
}

} // namespace

ReportUnit unitFrom(const std::string &unit, const std::string &selector, std::span<const Family *const> families)
{
    ReportUnit made;
    made.unit = unit;
    made.selector = selector;
    made.simulated = isSimulatedUnit(unit);
    const auto parsed = DeviceSelector::parse(selector);
    if (!parsed)
        return made;
    made.identity.family = parsed->family;
    made.identity.address = parsed->address;
    made.identity.session = parsed->session;
    const auto family = std::ranges::find_if(families, [&](const Family *each) { return each->key == parsed->family; });
    made.family = family == families.end() ? nullptr : *family;
    made.identity.serial = unitSerialIn(unit);
    return made;
}

Result<std::vector<ReportUnit>> reportUnits(
    TrialBook &book, std::span<const Family *const> families, const ReportWish &wish)
{
    std::vector<ReportUnit> units;
    const std::string asked = resolvedUnit(book.database(), wish.unit);
    if (!asked.empty())
        units.push_back(unitFrom(asked, {}, families));
    for (const std::int64_t number : wish.trials) {
        auto found = book.find(number);
        if (!found && wish.tuningsOnly)
            continue; // was forgotten: a tuning says so
        MB_TRY(const auto kept, std::move(found));
        if (!asked.empty() && kept.trial.unit != asked)
            continue;
        const auto same = [&](const ReportUnit &unit) { return unit.unit == kept.trial.unit; };
        if (std::ranges::none_of(units, same))
            units.push_back(unitFrom(kept.trial.unit, kept.trial.device, families));
        ReportUnit &unit = *std::ranges::find_if(units, same);
        unit.identity.firmware = kept.trial.firmware;
        unit.simulated = kept.trial.simulated;
    }
    for (ReportUnit &unit : units)
        MB_TRY_VOID(fill(book, unit, wish));
    return units;
}

} // namespace mb
