// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "files/jsonfields.h"

#include <QJsonObject>

namespace mb {

/// What is not known is null.
template <>
inline const JsonFields<tuning::Metrics> jsonFields<tuning::Metrics> = jsonFieldsOf<tuning::Metrics>(
    tuning::metricKeys());
template <> inline const JsonFields<Envelope> jsonFields<Envelope> = jsonFieldsOf<Envelope>(envelopeBounds);

/// Every key of the last line of `step`; what is not known is null. `number` of the notebook, if it is kept there.
[[nodiscard]] QJsonObject toJson(const tuning::Trial &trial, std::optional<std::int64_t> number);

[[nodiscard]] QJsonObject toJson(const tuning::Stimulus &stimulus, int repeat);
/// The same with where its holds and ways back were: `holds` and `returns`, pairs of seconds since the first edge.
[[nodiscard]] QJsonObject stimulusToJson(const tuning::Trial &trial);
/// Every metric, and KEY_error for what repeats told.
[[nodiscard]] QJsonObject metricsToJson(const tuning::Trial &trial);

/// The same back; what is missing or foreign stays as it is.
void readStimulus(const QJsonObject &object, tuning::Trial &trial);
void readMetrics(const QJsonObject &object, tuning::Trial &trial);

} // namespace mb
