// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/tuningjson.h"

#include "files/qttext.h"
#include "storage/messagejson.h"

#include <QJsonArray>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace mb {
namespace {

using namespace tuning;

constexpr std::array<std::string_view, 5> boundNames{
    "delay", "derivative noise", "largest error", "margin", "peak current"};

/// A number of a structure under its name, so that writing and reading share one list.
template <class T> using Numbers = std::vector<std::pair<const char *, double T::*>>;

const Numbers<PlantModel> plantNumbers{{"gain", &PlantModel::gain}, {"tau", &PlantModel::tau},
    {"delay", &PlantModel::delay}, {"friction", &PlantModel::friction}, {"braking", &PlantModel::braking},
    {"stall_current", &PlantModel::stallCurrent}, {"back_duty", &PlantModel::backDuty}, {"noise", &PlantModel::noise},
    {"reading", &PlantModel::reading}, {"lag_doubt", &PlantModel::lagDoubt}, {"pick_up", &PlantModel::pickUp},
    {"idle", &PlantModel::idle}, {"sag", &PlantModel::sag}, {"warming", &PlantModel::warming}};
const Numbers<ContinuousGains> gainNumbers{
    {"p", &ContinuousGains::p}, {"i", &ContinuousGains::i}, {"d", &ContinuousGains::d}, {"f", &ContinuousGains::f}};
const Numbers<PushFit> pushNumbers{{"tau", &PushFit::tau}, {"tau_error", &PushFit::tauError},
    {"delay", &PushFit::delay}, {"delay_error", &PushFit::delayError}, {"cost", &PushFit::cost}, {"sag", &PushFit::sag},
    {"warming", &PushFit::warming}};
const Numbers<GainFit> lineNumbers{{"gain", &GainFit::gain}, {"gain_error", &GainFit::gainError},
    {"friction", &GainFit::friction}, {"friction_error", &GainFit::frictionError}, {"offset", &GainFit::offset},
    {"offset_error", &GainFit::offsetError}, {"forward", &GainFit::forward}, {"reverse", &GainFit::reverse}};
const Numbers<RampWay> rampNumbers{{"breakaway", &RampWay::breakaway}, {"breakaway_error", &RampWay::breakawayError},
    {"friction", &RampWay::friction}, {"friction_error", &RampWay::frictionError}, {"gain", &RampWay::gain},
    {"determination", &RampWay::determination}};
const Numbers<VelocityFilter> filterNumbers{
    {"window", &VelocityFilter::window}, {"delay", &VelocityFilter::delay}, {"hold", &VelocityFilter::hold}};
const Numbers<Margins> marginNumbers{
    {"ms", &Margins::ms}, {"gain", &Margins::gain}, {"phase", &Margins::phase}, {"crossover", &Margins::crossover}};
const Numbers<ProfileLimits> profileNumbers{
    {"speed", &ProfileLimits::speed}, {"acceleration", &ProfileLimits::acceleration}};

const Numbers<TriedScale> scaleNumbers{{"p", &TriedScale::p}, {"d", &TriedScale::d}, {"cycle", &TriedScale::cycle},
    {"strongest", &TriedScale::strongest}, {"quickest", &TriedScale::quickest}, {"i", &TriedScale::i},
    {"rate", &TriedScale::rate}};

template <class T> QJsonObject numbersToJson(const T &value, const Numbers<T> &numbers)
{
    QJsonObject object;
    for (const auto &[key, member] : numbers)
        object.insert(QLatin1String(key), std::isfinite(value.*member) ? QJsonValue(value.*member) : QJsonValue());
    return object;
}

/// What was infinite is so again; what an older program did not write is as it is without.
template <class T> T numbersFrom(const QJsonObject &object, const Numbers<T> &numbers)
{
    T value;
    for (const auto &[key, member] : numbers) {
        if (const QJsonValue number = object.value(QLatin1String(key)); !number.isUndefined())
            value.*member = number.toDouble(std::numeric_limits<double>::infinity());
    }
    return value;
}

QJsonValue orNull(const std::optional<double> &number)
{
    return number && std::isfinite(*number) ? QJsonValue(*number) : QJsonValue();
}

std::optional<double> numberOrNothing(const QJsonValue &value)
{
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

QJsonObject toJson(const Metrics &metrics)
{
    QJsonObject object;
    for (const MetricKey &key : metricKeys())
        object.insert(qt(key.key), orNull(metrics.*key.value));
    return object;
}

Metrics metricsFrom(const QJsonObject &object)
{
    Metrics metrics;
    for (const MetricKey &key : metricKeys()) {
        if (const QJsonValue value = object.value(qt(key.key)); value.isDouble())
            metrics.*key.value = value.toDouble();
    }
    return metrics;
}

QJsonObject toJson(const Trace &trace)
{
    const std::size_t stride = 1 + trace.size() / tuningPoints;
    QJsonArray t;
    QJsonArray y;
    for (std::size_t i = 0; i < trace.size(); i += stride) {
        t.append(trace.t[i]);
        y.append(trace.y[i]);
    }
    return {{QStringLiteral("t"), t}, {QStringLiteral("y"), y}};
}

Trace traceFrom(const QJsonObject &object)
{
    const QJsonArray t = object.value(QStringLiteral("t")).toArray();
    const QJsonArray y = object.value(QStringLiteral("y")).toArray();
    Trace trace;
    for (int i = 0; i < std::min(t.size(), y.size()); ++i)
        trace.add(t.at(i).toDouble(), y.at(i).toDouble());
    return trace;
}

QJsonObject toJson(const Prediction &prediction)
{
    return {{QStringLiteral("metrics"), toJson(prediction.metrics)},
        {QStringLiteral("measured"), toJson(prediction.measured)}, {QStringLiteral("duty"), toJson(prediction.duty)}};
}

Prediction predictionFrom(const QJsonObject &object)
{
    return {traceFrom(object.value(QStringLiteral("measured")).toObject()),
        traceFrom(object.value(QStringLiteral("duty")).toObject()),
        metricsFrom(object.value(QStringLiteral("metrics")).toObject())};
}

QJsonObject toJson(const ScaledGains &gains)
{
    QJsonArray rows;
    for (const ScaledGains::Row &row : gains.rows)
        rows.append(QJsonObject{{QStringLiteral("key"), qt(row.key)},
            {QStringLiteral("raw"), static_cast<double>(row.raw)}, {QStringLiteral("value"), row.number}});
    return {{QStringLiteral("rows"), rows}, {QStringLiteral("made"), numbersToJson(gains.made, gainNumbers)}};
}

ScaledGains gainsFrom(const QJsonObject &object)
{
    ScaledGains gains;
    for (const QJsonValue value : object.value(QStringLiteral("rows")).toArray()) {
        const QJsonObject row = value.toObject();
        gains.rows.push_back({row.value(QStringLiteral("key")).toString().toStdString(),
            static_cast<std::int64_t>(row.value(QStringLiteral("raw")).toDouble()),
            row.value(QStringLiteral("value")).toDouble()});
    }
    gains.made = numbersFrom(object.value(QStringLiteral("made")).toObject(), gainNumbers);
    return gains;
}

QJsonObject toJson(const Design &design)
{
    QJsonArray bounds;
    for (const std::string_view bound : design.bounds)
        bounds.append(qt(bound));
    return {{QStringLiteral("gains"), numbersToJson(design.gains, gainNumbers)},
        {QStringLiteral("response"), design.response}, {QStringLiteral("bounds"), bounds}};
}

Design designFrom(const QJsonObject &object)
{
    Design design;
    design.gains = numbersFrom(object.value(QStringLiteral("gains")).toObject(), gainNumbers);
    design.response = object.value(QStringLiteral("response")).toDouble();
    for (const QJsonValue value : object.value(QStringLiteral("bounds")).toArray()) {
        for (const std::string_view known : boundNames) {
            if (value.toString() == qt(known))
                design.bounds.push_back(known);
        }
    }
    return design;
}

QJsonObject toJson(const Proposal &proposal)
{
    QJsonObject object{{QStringLiteral("aim"), qt(toString(proposal.aim))},
        {QStringLiteral("design"), toJson(proposal.design)}, {QStringLiteral("gains"), toJson(proposal.gains)},
        {QStringLiteral("margins"), numbersToJson(proposal.margins, marginNumbers)},
        {QStringLiteral("predicted"), toJson(proposal.predicted)}, {QStringLiteral("step"), proposal.step}};
    if (proposal.profile)
        object.insert(QStringLiteral("profile"), numbersToJson(*proposal.profile, profileNumbers));
    return object;
}

std::optional<ProfileLimits> profileFrom(const QJsonValue &value)
{
    return value.isObject() ? std::optional(numbersFrom(value.toObject(), profileNumbers)) : std::nullopt;
}

Proposal proposalFrom(const QJsonObject &object)
{
    Proposal proposal;
    proposal.aim = aimFromString(object.value(QStringLiteral("aim")).toString().toStdString()).value_or(proposal.aim);
    proposal.design = designFrom(object.value(QStringLiteral("design")).toObject());
    proposal.gains = gainsFrom(object.value(QStringLiteral("gains")).toObject());
    proposal.margins = numbersFrom(object.value(QStringLiteral("margins")).toObject(), marginNumbers);
    proposal.predicted = predictionFrom(object.value(QStringLiteral("predicted")).toObject());
    proposal.step = object.value(QStringLiteral("step")).toDouble();
    proposal.profile = profileFrom(object.value(QStringLiteral("profile")));
    return proposal;
}

QJsonValue toJson(const std::optional<MotorFound> &motor)
{
    if (!motor)
        return {};
    QJsonValue filter;
    if (motor->filter) {
        QJsonObject told = numbersToJson(*motor->filter, filterNumbers);
        told.insert(QStringLiteral("kind"), qt(toString(motor->filter->kind)));
        filter = told;
    }
    QJsonValue ramp;
    if (motor->ramp)
        ramp = QJsonObject{{QStringLiteral("forward"), numbersToJson(motor->ramp->forward, rampNumbers)},
            {QStringLiteral("reverse"), numbersToJson(motor->ramp->reverse, rampNumbers)}};
    return QJsonObject{{QStringLiteral("ramp"), ramp},
        {QStringLiteral("pushes"), numbersToJson(motor->pushes, pushNumbers)},
        {QStringLiteral("line"), numbersToJson(motor->line, lineNumbers)}, {QStringLiteral("filter"), filter},
        {QStringLiteral("supply"), motor->supply}, {QStringLiteral("unit"), qt(motor->unit)},
        {QStringLiteral("rest_noise"), orNull(motor->restNoise)}, {QStringLiteral("latency"), orNull(motor->latency)}};
}

std::optional<MotorFound> motorFrom(const QJsonValue &value)
{
    if (!value.isObject())
        return std::nullopt;
    const QJsonObject object = value.toObject();
    MotorFound motor;
    motor.pushes = numbersFrom(object.value(QStringLiteral("pushes")).toObject(), pushNumbers);
    motor.line = numbersFrom(object.value(QStringLiteral("line")).toObject(), lineNumbers);
    motor.unit = object.value(QStringLiteral("unit")).toString(qt(motor.unit)).toStdString();
    motor.supply = object.value(QStringLiteral("supply")).toDouble();
    motor.restNoise = numberOrNothing(object.value(QStringLiteral("rest_noise")));
    motor.latency = numberOrNothing(object.value(QStringLiteral("latency")));
    if (const QJsonObject ramp = object.value(QStringLiteral("ramp")).toObject(); !ramp.isEmpty())
        motor.ramp = RampFound{numbersFrom(ramp.value(QStringLiteral("forward")).toObject(), rampNumbers),
            numbersFrom(ramp.value(QStringLiteral("reverse")).toObject(), rampNumbers)};
    if (const QJsonValue filter = object.value(QStringLiteral("filter")); filter.isObject()) {
        motor.filter = numbersFrom(filter.toObject(), filterNumbers);
        using Kind = VelocityFilter::Kind;
        for (const Kind kind : {Kind::None, Kind::Rolling, Kind::Block}) {
            if (filter.toObject().value(QStringLiteral("kind")).toString() == qt(toString(kind)))
                motor.filter->kind = kind;
        }
    }
    return motor;
}

QJsonArray gatesToJson(const std::vector<Gate> &gates)
{
    QJsonArray array;
    for (const Gate &gate : gates)
        array.append(QJsonObject{{QStringLiteral("gate"), qt(gate.name)}, {QStringLiteral("passed"), gate.passed},
            {QStringLiteral("detail"), toJson(gate.detail)}, {QStringLiteral("remedy"), toJson(gate.remedy)},
            {QStringLiteral("warns"), gate.warns}});
    return array;
}

std::vector<Gate> gatesFrom(const QJsonArray &array)
{
    std::vector<Gate> gates;
    const auto text = [](const QJsonObject &object, const char *key) {
        return object.value(QLatin1String(key)).toString().toStdString();
    };
    for (const QJsonValue value : array) {
        const QJsonObject gate = value.toObject();
        gates.push_back({text(gate, "gate"), messageFrom(gate.value(QLatin1String("detail"))),
            gate.value(QStringLiteral("passed")).toBool(), messageFrom(gate.value(QLatin1String("remedy"))),
            gate.value(QStringLiteral("warns")).toBool()});
    }
    return gates;
}

QJsonArray beforeToJson(const TuneReport &report)
{
    QJsonArray array;
    for (const auto &[key, value] : report.before)
        array.append(QJsonArray{qt(key), orNull(value)});
    return array;
}

QJsonArray numbersOf(const std::vector<std::int64_t> &numbers)
{
    QJsonArray array;
    for (const std::int64_t number : numbers)
        array.append(static_cast<double>(number));
    return array;
}

QJsonArray proofToJson(const TuneReport &report)
{
    std::vector<std::int64_t> numbers;
    for (const Trial &trial : report.proof) {
        if (trial.number)
            numbers.push_back(*trial.number);
    }
    return numbersOf(numbers);
}

} // namespace

QJsonObject toJson(const TuneReport &report)
{
    QJsonArray proposals;
    for (const Proposal &proposal : report.proposals)
        proposals.append(toJson(proposal));
    QJsonObject object{{QStringLiteral("seconds"), report.seconds}, {QStringLiteral("stopped"), report.stopped},
        {QStringLiteral("stop_reason"), qt(report.stopReason)}, {QStringLiteral("motor"), toJson(report.motor)},
        {QStringLiteral("plant"), numbersToJson(report.plant, plantNumbers)},
        {QStringLiteral("gates"), gatesToJson(report.gates)}, {QStringLiteral("proposals"), proposals},
        {QStringLiteral("proposed"), toJson(report.proposed)}, {QStringLiteral("before"), beforeToJson(report)},
        {QStringLiteral("measured"), toJson(report.measured)}, {QStringLiteral("trials"), numbersOf(report.trials)},
        {QStringLiteral("proof"), proofToJson(report)}};
    if (report.scale)
        object.insert(QStringLiteral("scale"), numbersToJson(*report.scale, scaleNumbers));
    if (report.design)
        object.insert(QStringLiteral("design"), toJson(*report.design));
    if (report.margins)
        object.insert(QStringLiteral("margins"), numbersToJson(*report.margins, marginNumbers));
    if (report.predicted)
        object.insert(QStringLiteral("predicted"), toJson(*report.predicted));
    if (report.profile)
        object.insert(QStringLiteral("profile"), numbersToJson(*report.profile, profileNumbers));
    return object;
}

void readTuning(const QJsonObject &object, TuneReport &report)
{
    report.seconds = object.value(QStringLiteral("seconds")).toDouble();
    report.stopped = object.value(QStringLiteral("stopped")).toBool();
    report.stopReason = object.value(QStringLiteral("stop_reason")).toString().toStdString();
    report.motor = motorFrom(object.value(QStringLiteral("motor")));
    report.plant = numbersFrom(object.value(QStringLiteral("plant")).toObject(), plantNumbers);
    report.gates = gatesFrom(object.value(QStringLiteral("gates")).toArray());
    for (const QJsonValue value : object.value(QStringLiteral("proposals")).toArray())
        report.proposals.push_back(proposalFrom(value.toObject()));
    report.proposed = gainsFrom(object.value(QStringLiteral("proposed")).toObject());
    for (const QJsonValue value : object.value(QStringLiteral("before")).toArray()) {
        const QJsonValue number = value.toArray().at(1);
        report.before.emplace_back(value.toArray().at(0).toString().toStdString(),
            number.isDouble() ? std::optional(number.toDouble()) : std::nullopt);
    }
    report.measured = metricsFrom(object.value(QStringLiteral("measured")).toObject());
    for (const QJsonValue value : object.value(QStringLiteral("trials")).toArray())
        report.trials.push_back(static_cast<std::int64_t>(value.toDouble()));
    for (const QJsonValue value : object.value(QStringLiteral("proof")).toArray())
        report.proof.emplace_back().number = static_cast<std::int64_t>(value.toDouble());
    if (const QJsonValue value = object.value(QStringLiteral("scale")); value.isObject())
        report.scale = numbersFrom(value.toObject(), scaleNumbers);
    if (const QJsonValue value = object.value(QStringLiteral("design")); value.isObject())
        report.design = designFrom(value.toObject());
    if (const QJsonValue value = object.value(QStringLiteral("margins")); value.isObject())
        report.margins = numbersFrom(value.toObject(), marginNumbers);
    if (const QJsonValue value = object.value(QStringLiteral("predicted")); value.isObject())
        report.predicted = predictionFrom(value.toObject());
    report.profile = profileFrom(object.value(QStringLiteral("profile")));
}

} // namespace mb
