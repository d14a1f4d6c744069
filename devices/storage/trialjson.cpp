// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/trialjson.h"

#include "files/qttext.h"

namespace mb {
namespace {

using tuning::Trial;

QJsonValue numberOrNull(std::optional<double> number)
{
    return number ? QJsonValue(*number) : QJsonValue();
}

QString errorKey(std::string_view key)
{
    return qt(key) + QStringLiteral("_error");
}

QJsonArray spansToJson(const std::vector<tuning::Span> &spans)
{
    QJsonArray array;
    for (const tuning::Span &span : spans)
        array.append(QJsonArray{span.from, span.to});
    return array;
}

std::vector<tuning::Span> readSpans(const QJsonArray &array)
{
    std::vector<tuning::Span> spans;
    for (const QJsonValue span : array)
        spans.push_back({span.toArray().at(0).toDouble(), span.toArray().at(1).toDouble()});
    return spans;
}

} // namespace

QJsonObject toJson(const tuning::Stimulus &stimulus, int repeat)
{
    QJsonObject object{
        {QStringLiteral("profile"), qt(tuning::toString(stimulus.profile))},
        {QStringLiteral("from"), stimulus.from},
        {QStringLiteral("to"), stimulus.to},
        {QStringLiteral("time"), stimulus.time},
        {QStringLiteral("repeat"), repeat},
    };
    if (stimulus.ends)
        object.insert(QStringLiteral("ends"), true);
    if (stimulus.period > 0.0)
        object.insert(QStringLiteral("period"), stimulus.period);
    if (stimulus.high > 0.0) {
        object.insert(QStringLiteral("low"), stimulus.low);
        object.insert(QStringLiteral("high"), stimulus.high);
    }
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

QJsonObject gainsToJson(const Trial &trial)
{
    QJsonObject object;
    for (const auto &[key, value] : trial.gains)
        object.insert(qt(key), numberOrNull(value));
    return object;
}

QJsonObject metricsToJson(const Trial &trial)
{
    QJsonObject object;
    for (const tuning::MetricKey &key : tuning::metricKeys()) {
        object.insert(qt(key.key), numberOrNull(trial.metrics.*key.value));
        if (trial.repeat > 1)
            object.insert(errorKey(key.key), numberOrNull(trial.errors.*key.value));
    }
    return object;
}

QJsonObject toJson(const Envelope &envelope)
{
    QJsonObject object;
    for (const EnvelopeBound &bound : envelopeBounds)
        object.insert(QLatin1String(bound.key), numberOrNull(envelope.*bound.value));
    return object;
}

QJsonArray flagsToJson(const Trial &trial)
{
    QJsonArray array;
    for (const std::string &flag : trial.flags)
        array.append(qt(flag));
    return array;
}

QJsonObject toJson(const Trial &trial, std::optional<std::int64_t> number)
{
    return {
        {QStringLiteral("trial"), number ? QJsonValue(static_cast<qint64>(*number)) : QJsonValue()},
        {QStringLiteral("device"), qt(trial.device)},
        {QStringLiteral("mode"), qt(toString(trial.mode))},
        {QStringLiteral("axis"), trial.axis},
        {QStringLiteral("slot"), trial.slot},
        {QStringLiteral("stimulus"), toJson(trial.stimulus, trial.repeat)},
        {QStringLiteral("gains"), gainsToJson(trial)},
        {QStringLiteral("metrics"), metricsToJson(trial)},
        {QStringLiteral("flags"), flagsToJson(trial)},
        {QStringLiteral("reason"), trial.reason.empty() ? QJsonValue() : QJsonValue(qt(trial.reason))},
        {QStringLiteral("stopped"), trial.stopped},
        {QStringLiteral("samples"), static_cast<qint64>(trial.samples)},
        {QStringLiteral("lost"), static_cast<qint64>(trial.lost)},
    };
}

void readStimulus(const QJsonObject &object, Trial &trial)
{
    tuning::Stimulus &stimulus = trial.stimulus;
    const auto text = object.value(QStringLiteral("profile")).toString().toStdString();
    stimulus.profile = tuning::profileFromString(text).value_or(tuning::Profile::Step);
    stimulus.from = object.value(QStringLiteral("from")).toDouble();
    stimulus.to = object.value(QStringLiteral("to")).toDouble();
    stimulus.time = object.value(QStringLiteral("time")).toDouble();
    stimulus.ends = object.value(QStringLiteral("ends")).toBool();
    stimulus.period = object.value(QStringLiteral("period")).toDouble();
    stimulus.low = object.value(QStringLiteral("low")).toDouble();
    stimulus.high = object.value(QStringLiteral("high")).toDouble();
    trial.repeat = object.value(QStringLiteral("repeat")).toInt(1);
    trial.holds = readSpans(object.value(QStringLiteral("holds")).toArray());
    trial.returns = readSpans(object.value(QStringLiteral("returns")).toArray());
}

void readGains(const QJsonObject &object, Trial &trial)
{
    for (auto entry = object.begin(); entry != object.end(); ++entry)
        trial.gains.emplace_back(
            entry.key().toStdString(), entry->isDouble() ? std::optional(entry->toDouble()) : std::nullopt);
}

void readMetrics(const QJsonObject &object, Trial &trial)
{
    const auto number = [&object](const QString &key) {
        const QJsonValue value = object.value(key);
        return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
    };
    for (const tuning::MetricKey &key : tuning::metricKeys()) {
        trial.metrics.*key.value = number(qt(key.key));
        trial.errors.*key.value = number(errorKey(key.key));
    }
}

void readEnvelope(const QJsonObject &object, Trial &trial)
{
    for (const EnvelopeBound &bound : envelopeBounds) {
        const QJsonValue value = object.value(QLatin1String(bound.key));
        if (value.isDouble())
            trial.envelope.*bound.value = value.toDouble();
    }
}

void readFlags(const QJsonArray &array, Trial &trial)
{
    for (const QJsonValue flag : array)
        trial.flags.push_back(flag.toString().toStdString());
}

} // namespace mb
