// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/tuningjson.h"

#include "files/jsonfields.h"
#include "storage/messagejson.h"
#include "storage/trialjson.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <utility>

namespace mb {

template <>
const JsonFields<tuning::Trace> jsonFields<tuning::Trace>{{"t", &tuning::Trace::t}, {"y", &tuning::Trace::y}};

namespace {

using namespace tuning;
using Kind = VelocityFilter::Kind;

/// What is null was infinite.
template <class T>
JsonFields<T> numbers(std::initializer_list<std::pair<const char *, double T::*>> members, JsonFields<T> fields = {})
{
    for (const auto &[key, number] : members)
        fields.emplace_back(
            key, [number = number](const T &value) { return toJson(value.*number); },
            [number = number](const QJsonValue &json, T &value) {
                if (!json.isUndefined())
                    value.*number = json.toDouble(std::numeric_limits<double>::infinity());
                return json.isDouble() || json.isNull();
            });
    return fields;
}

bool readBounds(const QJsonValue &json, Design &design)
{
    for (const QJsonValue value : json.toArray()) {
        const auto known = std::ranges::find(designBounds, value.toString().toStdString());
        if (known != designBounds.end())
            design.bounds.push_back(*known);
    }
    return json.isArray();
}

/// Thinned out.
JsonField<Prediction> curve(std::string_view key, Trace Prediction::*member)
{
    return {key, [member](const Prediction &prediction) { return toJson(thinned(prediction.*member, tuningPoints)); },
        [member](const QJsonValue &json, Prediction &prediction) {
            Trace &trace = prediction.*member;
            const bool isRight = fromJson(json, trace);
            trace.t.resize(std::min(trace.t.size(), trace.y.size()));
            trace.y.resize(trace.t.size());
            return isRight;
        }};
}

/// A pair each.
QJsonValue beforeToJson(const TuneReport &report)
{
    QJsonArray array;
    for (const auto &[key, value] : report.before)
        array.append(QJsonArray{toJson(key), toJson(value)});
    return array;
}

bool readBefore(const QJsonValue &json, TuneReport &report)
{
    for (const QJsonValue pair : json.toArray()) {
        auto &[key, value] = report.before.emplace_back();
        fromJson(pair.toArray().at(0), key);
        fromJson(pair.toArray().at(1), value);
    }
    return json.isArray();
}

/// Their numbers.
QJsonValue proofToJson(const TuneReport &report)
{
    QJsonArray array;
    for (const Trial &trial : report.proof) {
        if (trial.number)
            array.append(toJson(*trial.number));
    }
    return array;
}

bool readProof(const QJsonValue &json, TuneReport &report)
{
    for (const QJsonValue number : json.toArray())
        fromJson(number, report.proof.emplace_back().number);
    return json.isArray();
}

} // namespace

template <>
const JsonFields<PlantModel> jsonFields<PlantModel> = numbers<PlantModel>({{"gain", &PlantModel::gain},
    {"tau", &PlantModel::tau}, {"delay", &PlantModel::delay}, {"friction", &PlantModel::friction},
    {"braking", &PlantModel::braking}, {"stall_current", &PlantModel::stallCurrent},
    {"back_duty", &PlantModel::backDuty}, {"noise", &PlantModel::noise}, {"reading", &PlantModel::reading},
    {"lag_doubt", &PlantModel::lagDoubt}, {"pick_up", &PlantModel::pickUp}, {"idle", &PlantModel::idle},
    {"sag", &PlantModel::sag}, {"warming", &PlantModel::warming}, {"breakaway", &PlantModel::breakaway}});
template <>
const JsonFields<ContinuousGains> jsonFields<ContinuousGains> = numbers<ContinuousGains>(
    {{"p", &ContinuousGains::p}, {"i", &ContinuousGains::i}, {"d", &ContinuousGains::d}, {"f", &ContinuousGains::f}});
template <>
const JsonFields<PushFit> jsonFields<PushFit> = numbers<PushFit>({{"tau", &PushFit::tau},
    {"tau_error", &PushFit::tauError}, {"delay", &PushFit::delay}, {"delay_error", &PushFit::delayError},
    {"cost", &PushFit::cost}, {"sag", &PushFit::sag}, {"warming", &PushFit::warming}});
template <>
const JsonFields<GainFit> jsonFields<GainFit> = numbers<GainFit>(
    {{"gain", &GainFit::gain}, {"gain_error", &GainFit::gainError}, {"friction", &GainFit::friction},
        {"friction_error", &GainFit::frictionError}, {"offset", &GainFit::offset},
        {"offset_error", &GainFit::offsetError}, {"forward", &GainFit::forward}, {"reverse", &GainFit::reverse}});
template <>
const JsonFields<RampWay> jsonFields<RampWay> = numbers<RampWay>({{"breakaway", &RampWay::breakaway},
    {"breakaway_error", &RampWay::breakawayError}, {"friction", &RampWay::friction},
    {"friction_error", &RampWay::frictionError}, {"gain", &RampWay::gain}, {"determination", &RampWay::determination}});
template <>
const JsonFields<VelocityFilter> jsonFields<VelocityFilter> = numbers<VelocityFilter>(
    {{"window", &VelocityFilter::window}, {"delay", &VelocityFilter::delay}, {"hold", &VelocityFilter::hold}},
    {{"kind", &VelocityFilter::kind, {Kind::None, Kind::Rolling, Kind::Block}}});
template <>
const JsonFields<Margins> jsonFields<Margins> = numbers<Margins>(
    {{"ms", &Margins::ms}, {"gain", &Margins::gain}, {"phase", &Margins::phase}, {"crossover", &Margins::crossover}});
template <>
const JsonFields<ProfileLimits> jsonFields<ProfileLimits> = numbers<ProfileLimits>(
    {{"speed", &ProfileLimits::speed}, {"acceleration", &ProfileLimits::acceleration}});
template <>
const JsonFields<TriedScale> jsonFields<TriedScale> = numbers<TriedScale>(
    {{"p", &TriedScale::p}, {"d", &TriedScale::d}, {"cycle", &TriedScale::cycle}, {"strongest", &TriedScale::strongest},
        {"quickest", &TriedScale::quickest}, {"i", &TriedScale::i}, {"rate", &TriedScale::rate}});
template <>
const JsonFields<RampFound> jsonFields<RampFound>{{"forward", &RampFound::forward}, {"reverse", &RampFound::reverse}};
template <>
const JsonFields<MotorFound> jsonFields<MotorFound>{{"ramp", &MotorFound::ramp}, {"pushes", &MotorFound::pushes},
    {"line", &MotorFound::line}, {"filter", &MotorFound::filter}, {"supply", &MotorFound::supply},
    {"unit", &MotorFound::unit}, {"rest_noise", &MotorFound::restNoise}, {"latency", &MotorFound::latency},
    {"model", &MotorFound::plant}};
template <>
const JsonFields<ScaledGains::Row> jsonFields<ScaledGains::Row>{
    {"key", &ScaledGains::Row::key}, {"raw", &ScaledGains::Row::raw}, {"value", &ScaledGains::Row::number}};
template <>
const JsonFields<ScaledGains> jsonFields<ScaledGains>{{"rows", &ScaledGains::rows}, {"made", &ScaledGains::made}};
template <>
const JsonFields<Design> jsonFields<Design>{{"gains", &Design::gains}, {"response", &Design::response},
    {"bounds", [](const Design &design) { return toJson(design.bounds); }, readBounds}};
template <>
const JsonFields<LoopShape> jsonFields<LoopShape> = numbers<LoopShape>(
    {{"period", &LoopShape::period}, {"most_duty", &LoopShape::mostDuty}, {"window", &LoopShape::window},
        {"window_counts", &LoopShape::windowCounts}, {"integral_step", &LoopShape::integralStep},
        {"integral_most", &LoopShape::integralMost}, {"output_step", &LoopShape::outputStep},
        {"least_output", &LoopShape::leastOutput}, {"good_enough", &LoopShape::goodEnough},
        {"clock", &LoopShape::clock}, {"set_point_rate", &LoopShape::setPointRate}, {"winding", &LoopShape::winding}},
    {{"counted", &LoopShape::isCounted}});
template <>
const JsonFields<Prediction> jsonFields<Prediction>{{"metrics", &Prediction::metrics}, {"shape", &Prediction::shape},
    curve("measured", &Prediction::measured), curve("duty", &Prediction::duty)};
template <>
const JsonFields<Proposal> jsonFields<Proposal>{{"aim", &Proposal::aim, {Aim::Calm, Aim::Normal, Aim::Brisk}},
    {"design", &Proposal::design}, {"gains", &Proposal::gains}, {"margins", &Proposal::margins},
    {"predicted", &Proposal::predicted}, {"step", &Proposal::step}, {"profile", &Proposal::profile, ifSet}};
template <>
const JsonFields<Gate> jsonFields<Gate>{{"gate", &Gate::name}, {"passed", &Gate::passed}, {"detail", &Gate::detail},
    {"remedy", &Gate::remedy}, {"warns", &Gate::warns}};
QJsonValue stopReasonToJson(const TuneReport &report)
{
    return qt(toString(report.stopReason));
}

bool readStopReason(const QJsonValue &json, TuneReport &report)
{
    if (json.isString())
        report.stopReason = endReasonFrom(json.toString().toStdString());
    return json.isString();
}

template <>
const JsonFields<TuneReport> jsonFields<TuneReport>{{"seconds", &TuneReport::seconds},
    {"stopped", &TuneReport::stopped}, {"stop_reason", stopReasonToJson, readStopReason}, {"motor", &TuneReport::motor},
    {"plant", &TuneReport::plant}, {"gates", &TuneReport::gates}, {"proposals", &TuneReport::proposals},
    {"proposed", &TuneReport::proposed}, {"measured", &TuneReport::measured}, {"trials", &TuneReport::trials},
    {"not_put_back", &TuneReport::notPutBack, ifSet}, {"scale", &TuneReport::scale, ifSet},
    {"design", &TuneReport::design, ifSet}, {"margins", &TuneReport::margins, ifSet},
    {"predicted", &TuneReport::predicted, ifSet}, {"step", &TuneReport::step}, {"profile", &TuneReport::profile, ifSet},
    {"before", beforeToJson, readBefore}, {"proof", proofToJson, readProof}};

QJsonObject toJson(const TuneReport &report)
{
    return toJson<TuneReport>(report);
}

void readTuning(const QJsonObject &object, TuneReport &report)
{
    fromJson(object, report);
}

} // namespace mb
