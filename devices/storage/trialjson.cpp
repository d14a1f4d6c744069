// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/trialjson.h"

#include "files/qttext.h"

#include <QJsonArray>

namespace mb {
namespace {

using tuning::Profile;
using tuning::Span;
using tuning::Stimulus;
using tuning::Trial;

QString errorKey(std::string_view key)
{
    return qt(key) + QStringLiteral("_error");
}

QJsonArray spansToJson(const std::vector<Span> &spans)
{
    QJsonArray array;
    for (const Span &span : spans)
        array.append(QJsonArray{span.from, span.to});
    return array;
}

std::vector<Span> readSpans(const QJsonArray &array)
{
    std::vector<Span> spans;
    for (const QJsonValue span : array)
        spans.push_back({span.toArray().at(0).toDouble(), span.toArray().at(1).toDouble()});
    return spans;
}

} // namespace

template <>
const JsonFields<Stimulus> jsonFields<Stimulus>{
    {"profile", &Stimulus::profile,
        {Profile::Step, Profile::Square, Profile::Ramp, Profile::Sine, Profile::Chirp, Profile::Prbs}},
    {"from", &Stimulus::from}, {"to", &Stimulus::to}, {"time", &Stimulus::time}, {"ends", &Stimulus::ends, ifSet},
    {"period", &Stimulus::period, ifSet}, {"low", &Stimulus::low, ifSet}, {"high", &Stimulus::high, ifSet}};

QJsonObject toJson(const Stimulus &stimulus, int repeat)
{
    QJsonObject object = toJson(stimulus);
    object.insert(QStringLiteral("repeat"), repeat);
    return object;
}

QJsonObject stimulusToJson(const Trial &trial)
{
    QJsonObject object = toJson(trial.stimulus, trial.repeat);
    if (!trial.holds.empty())
        object.insert(QStringLiteral("holds"), spansToJson(trial.holds));
    if (!trial.returns.empty())
        object.insert(QStringLiteral("returns"), spansToJson(trial.returns));
    return object;
}

QJsonObject metricsToJson(const Trial &trial)
{
    QJsonObject object = toJson(trial.metrics);
    for (const tuning::MetricKey &key : tuning::metricKeys()) {
        if (trial.repeat > 1)
            object.insert(errorKey(key.key), toJson(trial.errors.*key.value));
    }
    return object;
}

QJsonObject toJson(const Trial &trial, std::optional<std::int64_t> number)
{
    return {
        {QStringLiteral("trial"), toJson(number)},
        {QStringLiteral("device"), qt(trial.device)},
        {QStringLiteral("mode"), qt(toString(trial.mode))},
        {QStringLiteral("axis"), trial.axis},
        {QStringLiteral("slot"), trial.slot},
        {QStringLiteral("stimulus"), toJson(trial.stimulus, trial.repeat)},
        {QStringLiteral("gains"), toJson(trial.gains)},
        {QStringLiteral("metrics"), metricsToJson(trial)},
        {QStringLiteral("flags"), toJson(trial.flags)},
        {QStringLiteral("reason"), textOrNull(toString(trial.reason))},
        {QStringLiteral("stopped"), trial.stopped},
        {QStringLiteral("samples"), static_cast<qint64>(trial.samples)},
        {QStringLiteral("lost"), static_cast<qint64>(trial.lost)},
    };
}

void readStimulus(const QJsonObject &object, Trial &trial)
{
    fromJson(object, trial.stimulus);
    trial.repeat = object.value(QStringLiteral("repeat")).toInt(1);
    trial.holds = readSpans(object.value(QStringLiteral("holds")).toArray());
    trial.returns = readSpans(object.value(QStringLiteral("returns")).toArray());
}

void readMetrics(const QJsonObject &object, Trial &trial)
{
    for (const tuning::MetricKey &key : tuning::metricKeys()) {
        fromJson(object.value(qt(key.key)), trial.metrics.*key.value);
        fromJson(object.value(errorKey(key.key)), trial.errors.*key.value);
    }
}

} // namespace mb
