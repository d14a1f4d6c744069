// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/tunetext.h"

#include "app/console/table.h"
#include "app/console/target.h"
#include "files/filebytes.h"
#include "tuning/feedforwardnote.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <array>
#include <cmath>

namespace mb::console {
namespace {

using namespace tuning;

QJsonValue orNull(const std::optional<double> &value)
{
    return value && std::isfinite(*value) ? QJsonValue(*value) : QJsonValue();
}

QJsonObject metricsToJson(const Metrics &metrics)
{
    QJsonObject object;
    for (const MetricKey &key : metricKeys())
        object.insert(qt(key.key), orNull(metrics.*key.value));
    return object;
}

/// Gain of one direction alone, where it was measured.
QJsonValue oneWay(double gain)
{
    return gain > 0.0 ? QJsonValue(gain) : QJsonValue();
}

QJsonObject modelToJson(const TuneReport &report)
{
    const MotorFound &motor = *report.motor;
    QJsonObject object{{QStringLiteral("gain"), motor.line.gain}, {QStringLiteral("gain_error"), motor.line.gainError},
        {QStringLiteral("tau"), motor.pushes.tau}, {QStringLiteral("tau_error"), motor.pushes.tauError},
        {QStringLiteral("delay"), report.plant.delay}, {QStringLiteral("delay_error"), motor.pushes.delayError},
        {QStringLiteral("friction"), motor.line.friction}, {QStringLiteral("friction_error"), motor.line.frictionError},
        {QStringLiteral("load"), motor.line.offset}, {QStringLiteral("load_error"), motor.line.offsetError},
        {QStringLiteral("forward"), oneWay(motor.line.forward)},
        {QStringLiteral("reverse"), oneWay(motor.line.reverse)}, {QStringLiteral("noise"), orNull(motor.restNoise)},
        {QStringLiteral("latency"), orNull(motor.latency)}, {QStringLiteral("unit"), qt(motor.unit)}};
    object.insert(
        QStringLiteral("filter"), qt(toString(motor.filter ? motor.filter->kind : VelocityFilter::Kind::None)));
    object.insert(QStringLiteral("window"), motor.filter ? QJsonValue(motor.filter->window) : QJsonValue());
    return object;
}

QJsonObject gainsToJson(const TuneReport &report)
{
    QJsonObject object;
    for (const ScaledGains::Row &row : report.proposed.rows) {
        std::optional<double> from;
        for (const auto &[key, value] : report.before) {
            if (key == row.key)
                from = value;
        }
        object.insert(qt(row.key),
            QJsonObject{{QStringLiteral("from"), orNull(from)}, {QStringLiteral("to"), row.number},
                {QStringLiteral("raw"), static_cast<double>(row.raw)}});
    }
    return object;
}

QJsonValue qualityToJson(const TuneReport &report)
{
    QJsonArray gates;
    for (const Gate &gate : report.gates)
        gates.append(QJsonObject{{QStringLiteral("gate"), qt(gate.name)}, {QStringLiteral("passed"), gate.passed},
            {QStringLiteral("warns"), gate.warns}, {QStringLiteral("detail"), qt(gate.detail.english())}});
    return gates;
}

QJsonArray notesToJson(const TuneReport &report)
{
    const Message note = feedForwardNote(report);
    return note.empty() ? QJsonArray() : QJsonArray{qt(note.english())};
}

std::string briefly(const std::optional<double> &value, double scale, const char *unit)
{
    return value ? brief(*value * scale) + unit : std::string("-");
}

void printModel(Output &out, const TuneReport &report)
{
    const MotorFound &motor = *report.motor;
    Table table({"model", "value", "±", "unit"});
    table.add({"gain", brief(motor.line.gain), brief(motor.line.gainError), motor.unit});
    table.add({"tau", brief(1e3 * motor.pushes.tau), brief(1e3 * motor.pushes.tauError), "ms"});
    table.add({"delay of the loop", brief(1e3 * report.plant.delay), brief(1e3 * motor.pushes.delayError), "ms"});
    table.add({"friction", brief(100.0 * motor.line.friction), brief(100.0 * motor.line.frictionError), "% duty"});
    if (motor.ramp) {
        const bool inVolts = motor.supply > 0.0;
        const double scale = inVolts ? motor.supply : 100.0;
        const std::string unit = inVolts ? "V" : "% duty";
        for (const auto &[name, way] :
            {std::pair("forward", motor.ramp->forward), std::pair("reverse", motor.ramp->reverse)}) {
            table.add({std::string("breakaway ") + name, brief(scale * way.breakaway),
                brief(scale * way.breakawayError), unit});
            table.add(
                {std::string("friction ") + name, brief(scale * way.friction), brief(scale * way.frictionError), unit});
        }
    }
    if (motor.line.forward > 0.0 && motor.line.reverse > 0.0) {
        table.add({"load one way", brief(100.0 * motor.line.offset), brief(100.0 * motor.line.offsetError), "% duty"});
        table.add({"gain forward", brief(motor.line.forward), "", motor.unit});
        table.add({"gain reverse", brief(motor.line.reverse), "", motor.unit});
    }
    if (motor.restNoise)
        table.add({"noise at rest", brief(*motor.restNoise), "", "counts"});
    if (motor.latency)
        table.add({"order to motion", brief(1e3 * *motor.latency), "", "ms"});
    if (motor.filter)
        table.add({"velocity filter, " + std::string(toString(motor.filter->kind)), brief(1e3 * motor.filter->window),
            "", "ms"});
    table.print(out);
    for (const Gate &gate : report.gates) {
        if (!gate.passed)
            out.line("not believed: " + joined(gate.detail, gate.remedy).english());
        else if (gate.warns)
            out.line("to be looked at: " + gate.detail.english());
    }
}

void printGains(Output &out, const TuneReport &report)
{
    Table table({"gain", "from", "to", "raw"});
    for (const ScaledGains::Row &row : report.proposed.rows) {
        std::string from;
        for (const auto &[key, value] : report.before) {
            if (key == row.key && value)
                from = brief(*value);
        }
        table.add({row.key, from, brief(row.number), std::to_string(row.raw)});
    }
    table.print(out);
    if (const Message note = feedForwardNote(report); !note.empty())
        out.line(note.english());
    if (report.margins)
        out.line("margins: Ms " + brief(report.margins->ms) + ", gain " + brief(report.margins->gain) + ", phase "
            + brief(report.margins->phase) + "°");
    const auto words = [](const Metrics &metrics) {
        return "rise " + briefly(metrics.rise, 1e3, " ms") + ", settle " + briefly(metrics.settle, 1e3, " ms")
            + ", overshoot " + briefly(metrics.overshoot, 100.0, " %");
    };
    if (report.profile)
        out.line("profile:   at most " + brief(report.profile->speed) + " counts/s and "
            + brief(report.profile->acceleration) + " counts/s²");
    if (report.predicted)
        out.line("predicted: " + words(report.predicted->metrics));
    if (!report.proof.empty())
        out.line("measured:  " + words(report.measured));
}

} // namespace

QJsonObject toJson(const TuneReport &report)
{
    QJsonArray trials;
    for (const std::int64_t number : report.trials)
        trials.append(static_cast<double>(number));
    QJsonObject object{{QStringLiteral("result"), qt(toString(report.result))},
        {QStringLiteral("device"), qt(report.device)}, {QStringLiteral("loop"), qt(toString(report.loop))},
        {QStringLiteral("axis"), report.axis}, {QStringLiteral("slot"), report.slot},
        {QStringLiteral("simulated"), report.simulated}, {QStringLiteral("stopped"), report.stopped},
        {QStringLiteral("seconds"), report.seconds}, {QStringLiteral("trials"), trials},
        {QStringLiteral("evidence"), qt(report.evidence.english())}, {QStringLiteral("quality"), qualityToJson(report)},
        {QStringLiteral("gains"), gainsToJson(report)}, {QStringLiteral("notes"), notesToJson(report)}};
    object.insert(QStringLiteral("model"), report.motor ? QJsonValue(modelToJson(report)) : QJsonValue());
    object.insert(QStringLiteral("predicted"),
        report.predicted ? QJsonValue(metricsToJson(report.predicted->metrics)) : QJsonValue());
    object.insert(
        QStringLiteral("measured"), report.proof.empty() ? QJsonValue() : QJsonValue(metricsToJson(report.measured)));
    object.insert(QStringLiteral("profile"),
        report.profile ? QJsonValue(QJsonObject{{QStringLiteral("speed"), report.profile->speed},
            {QStringLiteral("acceleration"), report.profile->acceleration}})
                       : QJsonValue());
    object.insert(QStringLiteral("margins"),
        report.margins ? QJsonValue(QJsonObject{{QStringLiteral("ms"), orNull(report.margins->ms)},
            {QStringLiteral("gm"), orNull(report.margins->gain)},
            {QStringLiteral("pm"), orNull(report.margins->phase)}})
                       : QJsonValue());
    return object;
}

void printTuning(Console &console, const TuneReport &report)
{
    if (console.json()) {
        console.out().json(toJson(report));
        return;
    }
    if (report.motor)
        printModel(console.out(), report);
    if (!report.proposed.rows.empty())
        printGains(console.out(), report);
    console.out().line(std::string(toString(report.result)) + ": " + report.evidence.english() + " ("
        + brief(report.seconds) + " s, " + std::to_string(report.trials.size()) + " trials"
        + (report.simulated ? ", simulated" : "") + ")");
}

Result<void> saveTuning(const std::string &path, const TuneReport &report)
{
    return saveFile(path, QJsonDocument(toJson(report)).toJson());
}

} // namespace mb::console
