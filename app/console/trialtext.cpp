// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/trialtext.h"

#include "app/console/table.h"
#include "app/console/target.h"
#include "storage/trialfile.h"
#include "storage/trialjson.h"

#include <QDateTime>

#include <array>
#include <cmath>

namespace mb::console {
namespace {

using tuning::Trial;

struct Shown {
    const char *label;
    std::string_view key;
    double scale;
    const char *unit;
};

constexpr std::array<Shown, 11> shownMetrics{{
    {"rise", "rise", 1e3, "ms"},
    {"settle 2 %", "settle", 1e3, "ms"},
    {"overshoot", "overshoot", 100.0, "%"},
    {"undershoot of the return", "undershoot", 100.0, "%"},
    {"steady-state error", "sse", 100.0, "%"},
    {"IAE", "iae", 1.0, "s"},
    {"ITAE", "itae", 1.0, "s²"},
    {"peak current", "peak_current", 1.0, "A"},
    {"duty chatter, RMS", "rms_duty", 100.0, "%"},
    {"saturated", "saturated", 100.0, "%"},
    {"noise", "noise", 100.0, "%"},
}};

std::string list(const std::vector<std::string> &words)
{
    std::string text;
    for (const std::string &word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

void printMetrics(Output &out, const Trial &trial)
{
    Table table({"metric", "value", "±", "unit"});
    for (const Shown &row : shownMetrics) {
        for (const tuning::MetricKey &key : tuning::metricKeys()) {
            if (key.key != row.key)
                continue;
            const auto value = trial.metrics.*key.value;
            const auto error = trial.errors.*key.value;
            table.add(
                {row.label, value ? brief(*value * row.scale) : "", error ? brief(*error * row.scale) : "", row.unit});
        }
    }
    table.print(out);
}

std::string timeOf(const KeptTrial &kept)
{
    return QDateTime::fromMSecsSinceEpoch(std::llround(kept.time * 1e3)).toString(Qt::ISODate).toStdString();
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
    console.out().line((number ? "trial " + std::to_string(*number) + ": " : std::string()) + trial.reason
        + (trial.stopped ? ", stopped" : ", stop not confirmed") + ", " + std::to_string(trial.samples) + " samples, "
        + std::to_string(trial.lost) + " lost" + (trial.flags.empty() ? "" : ", " + list(trial.flags))
        + (trial.simulated ? ", simulated" : ""));
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
            kept.trial.reason.empty() ? "aborted" : kept.trial.reason, kept.note});
    }
    table.print(console.out());
}

} // namespace mb::console
