// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/trialfile.h"

#include "files/csvtext.h"
#include "files/filebytes.h"
#include "files/qttext.h"
#include "storage/trialjson.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>

#include <array>
#include <cmath>
#include <cstdio>

namespace mb {
namespace {

using tuning::Trial;

QJsonObject signalsToJson(const Trial &trial)
{
    QJsonObject all;
    for (const tuning::Signal &signal : trial.signals) {
        all.insert(qt(signal.channel),
            QJsonObject{{QStringLiteral("unit"), qt(signal.unit)}, {QStringLiteral("t"), toJson(signal.trace.t)},
                {QStringLiteral("value"), toJson(signal.trace.y)}});
    }
    return all;
}

QByteArray samplesAsCsv(const Trial &trial)
{
    std::string text = "t,channel,value,unit\n";
    for (const tuning::Signal &signal : trial.signals) {
        for (std::size_t i = 0; i < signal.trace.size(); ++i) {
            std::array<char, 40> time{};
            std::snprintf(time.data(), time.size(), "%.6f,", signal.trace.t[i]);
            text += time.data() + signal.channel + ',' + numberText(signal.trace.y[i]) + ',' + signal.unit + '\n';
        }
    }
    return QByteArray::fromStdString(text);
}

std::string gainsOf(const Trial &trial)
{
    std::string gains;
    for (const auto &[key, value] : trial.gains)
        gains += (gains.empty() ? "" : " ") + key + '=' + (value ? numberText(*value) : "?");
    return gains;
}

std::string rowOf(const KeptTrial &kept)
{
    const Trial &t = kept.trial;
    const auto truth = [](bool yes) { return yes ? "1" : "0"; };
    std::vector<std::string> cells{std::to_string(kept.number), csvTime(kept.time), t.device, t.unit, t.firmware,
        truth(t.simulated), std::string(toString(t.mode)), std::to_string(t.axis), std::to_string(t.slot),
        std::string(toString(t.stimulus.profile)), numberText(t.stimulus.from), numberText(t.stimulus.to),
        std::to_string(t.repeat)};
    for (const tuning::MetricKey &key : tuning::metricKeys())
        cells.push_back(t.metrics.*key.value ? numberText(*(t.metrics.*key.value)) : "");
    cells.insert(cells.end(),
        {flagsOf(t), std::string(toString(t.reason)), truth(t.stopped), std::to_string(t.samples),
            std::to_string(t.lost), truth(kept.star), kept.note, gainsOf(t)});
    return csvRow(cells);
}

QByteArray trialsAsCsv(const std::vector<KeptTrial> &trials)
{
    std::string text = "trial,time,device,unit,firmware,simulated,mode,axis,slot,profile,from,to,repeat";
    for (const tuning::MetricKey &key : tuning::metricKeys())
        text += ',' + std::string(key.key);
    text += ",flags,reason,stopped,samples,lost,star,note,gains\n";
    for (const KeptTrial &kept : trials)
        text += rowOf(kept);
    return QByteArray::fromStdString(text);
}

} // namespace

std::string timeOf(const KeptTrial &kept)
{
    return QDateTime::fromMSecsSinceEpoch(std::llround(kept.time * 1e3)).toString(Qt::ISODate).toStdString();
}

std::string flagsOf(const Trial &trial)
{
    std::string text;
    for (const std::string &flag : trial.flags)
        text += (text.empty() ? "" : ", ") + flag;
    return text;
}

QJsonObject trialRow(const KeptTrial &kept)
{
    QJsonObject row = toJson(kept.trial, kept.number);
    row.insert(QStringLiteral("time"), kept.time);
    row.insert(QStringLiteral("firmware"), textOrNull(kept.trial.firmware));
    row.insert(QStringLiteral("unit"), qt(kept.trial.unit));
    row.insert(QStringLiteral("simulated"), kept.trial.simulated);
    row.insert(QStringLiteral("star"), kept.star);
    row.insert(QStringLiteral("note"), qt(kept.note));
    return row;
}

QJsonArray trialRows(const std::vector<KeptTrial> &trials)
{
    QJsonArray rows;
    for (const KeptTrial &kept : trials)
        rows.append(trialRow(kept));
    return rows;
}

Result<void> saveTrial(const std::string &path, const Trial &trial, std::optional<std::int64_t> number)
{
    if (path.ends_with(".csv"))
        return saveFile(path, samplesAsCsv(trial));
    QJsonObject object = toJson(trial, number);
    object.insert(QStringLiteral("simulated"), trial.simulated);
    object.insert(QStringLiteral("signals"), signalsToJson(trial));
    return saveFile(path, QJsonDocument(object).toJson());
}

Result<void> exportTrials(const std::string &path, const std::vector<KeptTrial> &trials)
{
    if (path.ends_with(".csv"))
        return saveFile(path, trialsAsCsv(trials));
    return saveFile(path, QJsonDocument(QJsonObject{{QStringLiteral("trials"), trialRows(trials)}}).toJson());
}

} // namespace mb
