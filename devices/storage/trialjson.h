// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"

#include <QJsonArray>
#include <QJsonObject>

namespace mb {

/// Every key of the last line of `step`; what is not known is null. `number` of the notebook, if it is kept there.
[[nodiscard]] QJsonObject toJson(const tuning::Trial &trial, std::optional<std::int64_t> number);

[[nodiscard]] QJsonObject toJson(const tuning::Stimulus &stimulus, int repeat);
/// The same with where its holds and ways back were: `holds` and `returns`, pairs of seconds since the first edge.
[[nodiscard]] QJsonObject stimulusToJson(const tuning::Trial &trial);
[[nodiscard]] QJsonObject gainsToJson(const tuning::Trial &trial);
/// Every metric, and KEY_error for what repeats told.
[[nodiscard]] QJsonObject metricsToJson(const tuning::Trial &trial);
[[nodiscard]] QJsonObject toJson(const Envelope &envelope);
[[nodiscard]] QJsonArray flagsToJson(const tuning::Trial &trial);

/// The same back; what is missing or foreign stays as it is.
void readStimulus(const QJsonObject &object, tuning::Trial &trial);
void readGains(const QJsonObject &object, tuning::Trial &trial);
void readMetrics(const QJsonObject &object, tuning::Trial &trial);
void readEnvelope(const QJsonObject &object, tuning::Trial &trial);
void readFlags(const QJsonArray &array, tuning::Trial &trial);

} // namespace mb
