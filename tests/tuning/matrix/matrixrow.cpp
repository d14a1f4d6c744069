// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/matrix/matrixrow.h"

#include "experiment/envelope.h"
#include "tests/tuning/matrix/groundtruth.h"
#include "tests/tuning/matrix/publishedrules.h"
#include "tuning/gainscale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mb::test {
namespace {

using tuning::TuneReport;
using tuning::TuneResult;

constexpr double holdSettles = 4.0;
constexpr double shortestHold = 0.6;
constexpr double longestHold = 6.0;
constexpr double shortestOfCurrent = 0.08; ///< s, as its proof
constexpr double longestOfCurrent = 0.2;   ///< s
constexpr int runsOfMean = 8;

const tuning::Proposal *normalOf(const TuneReport &report)
{
    const auto found = std::find_if(report.proposals.begin(), report.proposals.end(),
        [](const tuning::Proposal &proposal) { return proposal.aim == tuning::Aim::Normal; });
    return found == report.proposals.end() ? nullptr : &*found;
}

/// What a proposal writes beside its gains.
std::vector<ParameterChange> frictionHelp(const Device &device, const tuning::ScaledGains &gains)
{
    std::vector<ParameterChange> rest;
    for (const ParameterChange &change : gains.changes) {
        const std::string_view key = device.parameters().parameter(change.index).key;
        if (key.find("nominal") != std::string_view::npos || key.find("allowable") != std::string_view::npos
            || key.find("windup") != std::string_view::npos || key.find("i_zone") != std::string_view::npos)
            rest.push_back(change);
    }
    return rest;
}

std::optional<ShaftResponse> tryRule(
    StepProbe &probe, const Cell &cell, const tuning::ContinuousGains &gains, const std::vector<ParameterChange> &also)
{
    const auto scaled = tuning::scaleGains(probe.device(), cell.loop, 1, 0, gains, trueScale(cell));
    if (!scaled)
        return std::nullopt;
    std::vector<ParameterChange> changes = scaled->changes;
    changes.insert(changes.end(), also.begin(), also.end());
    return probe.runAll(changes, stepPhases(runsOfMean));
}

/// What raw gains make, as the firmware of the cell has it; those of the report where it knows that itself.
tuning::ContinuousGains trueGains(const Cell &cell, const tuning::ScaledGains &kept)
{
    const auto scale = trueScale(cell);
    if (!scale)
        return kept.made;
    tuning::ContinuousGains made;
    for (const tuning::ScaledGains::Row &row : kept.rows) {
        made.p = row.key.ends_with(".p") ? row.number * scale->p : made.p;
        made.i = row.key.ends_with(".i") ? row.number * scale->i : made.i;
        made.d = row.key.ends_with(".d") ? row.number * scale->d : made.d;
    }
    return made;
}

/// Gains that somebody else's rule would have. A rule for a loop with an integral tells nothing of one without.
void compareWithRules(MatrixRow &row, StepProbe &probe, const std::vector<ParameterChange> &help,
    const std::vector<tuning::Trial> &trials)
{
    const Cell &cell = row.cell;
    if (trueScale(cell))
        return;
    const Ultimate ultimate = ultimateOf(cell.loop, row.truth);
    row.zieglerNichols = tryRule(probe, cell, zieglerNichols(cell.loop, ultimate), help);
    row.tyreusLuyben = tryRule(probe, cell, tyreusLuyben(cell.loop, ultimate), help);
    if (cell.loop == Mode::Current) // whose pushes tell no motor
        return;
    if (const auto plant = regressed(trials, row.truth)) {
        const auto response = tuning::responseOf(cell.loop, tuning::Aim::Normal, *plant);
        row.regression = tryRule(probe, cell,
            cell.loop == Mode::Position ? tuning::positionRule(*plant, 1.0 / response)
                                        : tuning::velocityRule(*plant, response),
            help);
    }
}

/// A, that the limits of a tuning let a step of the cell draw; 0: nobody measures it.
double mostCurrentOf(const Cell &cell)
{
    MatrixUnit unit(cell, true);
    Device &device = unit.device();
    const auto own = test::run(unit.clock(), tuning::readOwnLimits(device, 1, 0, 0.0));
    const auto envelope
        = tuning::resolve(device.family(), tuning::factsOf(device, 1), cell.loop, {}, own.value_or(Envelope()));
    return envelope ? envelope->current.value_or(0.0) : 0.0;
}

void compareWithOthers(MatrixRow &row, const TuneReport &report, const std::vector<tuning::Trial> &trials, bool all)
{
    const Cell &cell = row.cell;
    const double settle = report.predicted->metrics.settle.value_or(1.0);
    const bool isCurrent = cell.loop == Mode::Current;
    const double seconds = std::clamp(
        holdSettles * settle, isCurrent ? shortestOfCurrent : shortestHold, isCurrent ? longestOfCurrent : longestHold);
    StepProbe probe(cell, {row.step, seconds, report.scale ? report.scale->rate : 0.0, mostCurrentOf(cell)});
    const auto phases = stepPhases(runsOfMean);
    row.before = probe.runAll({}, phases);
    row.kept = probe.runAll(report.proposed.changes, phases);
    row.isWithin = row.isWithin && row.kept && !probe.drawsTooMuch(*row.kept);
    if (!all)
        return;
    const auto help = frictionHelp(probe.device(), report.proposed);
    for (const BestGains &best : bruteForce(probe, cell, row.truth, help, stepPhases(runsOfMean, runsOfMean))) {
        const auto again = tryRule(probe, cell, best.gains, help);
        if (!again || !isWithinBounds(probe, *again)) // which it was by luck
            continue;
        row.best = again;
        row.bestGains = best.gains;
        break;
    }
    compareWithRules(row, probe, help, trials);
}

/// Seconds that each kind of experiment took.
std::map<std::string, double> stagesOf(const std::vector<std::pair<double, std::string>> &notes, double end)
{
    std::map<std::string, double> stages;
    stages["before"] = notes.empty() ? end : notes.front().first;
    for (std::size_t i = 0; i < notes.size(); ++i) {
        const std::string kind = notes[i].second.substr(0, notes[i].second.find_first_of(" :"));
        stages[kind] += (i + 1 < notes.size() ? notes[i + 1].first : end) - notes[i].first;
    }
    return stages;
}

std::string number(double value)
{
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.5g", value);
    return text.data();
}

std::string cells(const std::optional<ShaftResponse> &response)
{
    if (!response)
        return "\t\t\t";
    return '\t' + number(response->isStable ? response->itae : INFINITY) + '\t' + number(response->overshoot) + '\t'
        + number(response->settle);
}

} // namespace

Cell cellOf(const std::string &family, const std::string &motor, Mode loop, std::uint64_t seed, double rate,
    const std::string &dialect)
{
    std::mt19937_64 random(seed * 7919U);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    Cell cell{family, motor, loop, seed, 0.6 + share(random), {}, dialect};
    cell.around.rate = rate;
    const auto kind = (seed - 1) % 4;
    if (kind >= 1) {
        cell.around.busResistance = 0.05;
        cell.around.ripple = 0.01;
    }
    if (kind >= 2) {
        // The wire of a board loses nothing; a serial sample is a question and its answer, and is lost with either.
        cell.around.loss = family == "quadquad2drv" ? 0.0 : family == "supermodified" ? 0.01 : 0.02;
        cell.around.friction = 1.3;
    }
    if (kind == 3)
        cell.around.backlash = 4.0;
    return cell;
}

MatrixRow tuneCell(const Cell &cell, Compare compare)
{
    MatrixRow row;
    row.cell = cell;
    MatrixUnit unit(cell);
    const auto before = unit.gains();
    const auto inUnit = unit.gainsInUnit();
    tuning::TunePlan plan;
    plan.loop = cell.loop;
    plan.keep = true;
    const auto report = unit.tune(plan);
    if (!report) {
        row.result = "failed";
        row.reason = report.error().text();
        return row;
    }
    row.result = toString(report->result);
    row.seconds = report->seconds;
    for (const tuning::Trial &trial : report->proof)
        row.steps += static_cast<int>(trial.holds.size());
    row.stages = stagesOf(unit.notes(), report->seconds);
    row.notes = unit.notes();
    for (const tuning::Gate &gate : report->gates)
        row.notes.emplace_back(report->seconds, gate.name + ": " + gate.detail.english());
    row.stopped = report->stopped;
    row.found = report->plant;
    row.measuredOvershoot = report->measured.overshoot.value_or(0.0);
    row.measuredNoise = report->measured.noise.value_or(0.0);
    if (const tuning::Proposal *const normal = normalOf(*report))
        row.step = normal->step;
    row.truth = groundTruth(cell, row.step);
    if (report->predicted)
        row.predictedOvershoot = report->predicted->metrics.overshoot.value_or(0.0);
    if (report->result != TuneResult::Kept) {
        row.reason = report->evidence.english();
        const bool isKnown = std::ranges::all_of(before, [](const auto &gain) { return gain.second.has_value(); });
        row.gainsAsBefore = !isKnown || unit.gainsInUnit() == inUnit;
        return row;
    }
    row.reason = report->evidence.english();
    row.keptGains = trueGains(cell, report->proposed);
    row.isWithin = isWithinBounds(cell, row.truth, row.keptGains, row.step);
    if (const auto former = tuning::gainsMadeBy(
            unit.device().family(), unit.device().knowledge().profile(), cell.loop, 1, 0, before, trueScale(cell))) {
        row.formerGains = former->made;
        row.isFormerWithin = isWithinBounds(cell, row.truth, row.formerGains, row.step);
    }
    if (compare != Compare::Nothing)
        compareWithOthers(row, *report, unit.journal().completed, compare == Compare::All);
    return row;
}

std::string matrixHead()
{
    std::string head = "family\tloop\tmotor\tseed\trate\tload\tresult\tseconds\tdgain\tdtau\tddelay\tpredicted\tmeasure"
                       "d\tas_before\t"
                       "stopped\twithin\tstep";
    for (const char *const who : {"kept", "before", "best", "zn", "tl", "sysid"})
        head += std::string("\t") + who + "_itae\t" + who + "_os\t" + who + "_settle";
    return head
        + "\tkept_p\tkept_i\tkept_d\tbest_p\tbest_i\tbest_d\tbefore_p\tbefore_i\tbefore_d\tbefore_"
          "within\tkept_spread\tbest_spread\tdialect\tsteps\treason";
}

std::string textOf(const MatrixRow &row)
{
    const Cell &cell = row.cell;
    const auto off = [](double found, double truth) { return truth > 0.0 ? found / truth - 1.0 : 0.0; };
    std::string text = cell.family + '\t' + std::string(toString(cell.loop)) + '\t' + cell.motor + '\t'
        + std::to_string(cell.seed) + '\t' + number(cell.around.rate) + '\t' + number(cell.loadFactor) + '\t'
        + row.result + '\t' + number(row.seconds) + '\t' + number(off(row.found.gain, row.truth.gain)) + '\t'
        + number(off(row.found.tau, row.truth.tau)) + '\t' + number(row.found.delay - row.truth.delay) + '\t'
        + number(row.predictedOvershoot) + '\t' + number(row.measuredOvershoot) + '\t' + (row.gainsAsBefore ? "1" : "0")
        + '\t' + (row.stopped ? "1" : "0") + '\t' + (row.isWithin ? "1" : "0") + '\t' + number(row.step);
    for (const auto *const response :
        {&row.kept, &row.before, &row.best, &row.zieglerNichols, &row.tyreusLuyben, &row.regression})
        text += cells(*response);
    for (const auto *const gains : {&row.keptGains, &row.bestGains, &row.formerGains})
        text += '\t' + number(gains->p) + '\t' + number(gains->i) + '\t' + number(gains->d);
    text += row.isFormerWithin ? "\t1" : "\t0";
    for (const auto *const response : {&row.kept, &row.best})
        text += '\t' + (*response ? number((*response)->spread) : "");
    return text + '\t' + cell.dialect + '\t' + std::to_string(row.steps) + '\t' + row.reason;
}

} // namespace mb::test
