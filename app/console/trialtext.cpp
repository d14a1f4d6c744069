// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/trialtext.h"

#include "app/console/table.h"
#include "app/console/target.h"
#include "report/metricwords.h"
#include "storage/trialfile.h"
#include "storage/trialjson.h"

#include <optional>

namespace mb::console {
namespace {

using tuning::Trial;

void printMetrics(Output &out, const Trial &trial)
{
    Table table({"metric", "value", "±", "unit"});
    for (const tuning::MetricKey &key : tuning::metricKeys()) {
        const auto text = [&key](std::optional<double> value) { return value ? brief(*value * key.scale) : ""; };
        table.add({metricWords(key.key).name.toStdString(), text(trial.metrics.*key.value),
            text(trial.errors.*key.value), std::string(key.unit)});
    }
    table.print(out);
}

std::string stimulusOf(const Trial &trial)
{
    return std::string(toString(trial.stimulus.profile)) + ' ' + numberText(trial.stimulus.from) + " ▸ "
        + numberText(trial.stimulus.to);
}

} // namespace

void printTrial(Console &console, const Trial &trial, std::optional<std::int64_t> number)
{
    if (console.json()) {
        console.out().json(mb::toJson(trial, number));
        return;
    }
    printMetrics(console.out(), trial);
    console.out().line((number ? "trial " + std::to_string(*number) + ": " : std::string())
        + std::string(toString(trial.reason)) + (trial.stopped ? ", stopped" : ", stop not confirmed") + ", "
        + std::to_string(trial.samples) + " samples, " + std::to_string(trial.lost) + " lost"
        + (trial.flags.empty() ? "" : ", " + flagsOf(trial)) + (trial.simulated ? ", simulated" : ""));
}

void printTrials(Console &console, const std::vector<KeptTrial> &trials)
{
    if (console.json()) {
        console.out().json({{QStringLiteral("trials"), trialRows(trials)}});
        return;
    }
    Table table(
        {"trial", "time", "device", "mode", "stimulus", "rise ms", "overshoot %", "settle ms", "reason", "note"});
    for (const KeptTrial &kept : trials) {
        const tuning::Metrics &m = kept.trial.metrics;
        table.add({std::to_string(kept.number) + (kept.star ? " *" : ""), timeOf(kept), kept.trial.device,
            std::string(toString(kept.trial.mode)), stimulusOf(kept.trial), m.rise ? brief(*m.rise * 1e3) : "",
            m.overshoot ? brief(*m.overshoot * 100.0) : "", m.settle ? brief(*m.settle * 1e3) : "",
            kept.trial.reason == tuning::EndReason::None ? "aborted" : std::string(toString(kept.trial.reason)),
            kept.note});
    }
    table.print(console.out());
}

} // namespace mb::console
