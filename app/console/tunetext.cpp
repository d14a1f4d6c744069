// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/tunetext.h"

#include "app/console/table.h"
#include "app/console/target.h"
#include "files/filebytes.h"
#include "storage/trialjson.h"
#include "tuning/designnotes.h"
#include "tuning/modelnumbers.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace mb::console {
namespace {

using namespace tuning;

QJsonObject modelToJson(const TuneReport &report)
{
    const MotorFound &motor = *report.motor;
    const ModelNumbers numbers = modelNumbers(report);
    QJsonObject object{{QStringLiteral("unit"), qt(motor.unit)}};
    for (const auto &[key, number] :
        {std::pair("gain", numbers.gain), std::pair("tau", numbers.tau), std::pair("delay", numbers.delay),
            std::pair("friction", numbers.friction), std::pair("load", numbers.load)}) {
        object.insert(QLatin1String(key), mb::toJson(number.value));
        object.insert(QLatin1String(key) + QStringLiteral("_error"), mb::toJson(number.error));
    }
    for (const auto &[key, number] : {std::pair("forward", numbers.forward), std::pair("reverse", numbers.reverse),
             std::pair("noise", numbers.noise), std::pair("latency", numbers.latency)})
        object.insert(QLatin1String(key), mb::toJson(number.value));
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
            QJsonObject{{QStringLiteral("from"), mb::toJson(from)}, {QStringLiteral("to"), row.number},
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
    QJsonArray notes;
    for (const Message &note : designNotes(report))
        notes.append(qt(note.english()));
    return notes;
}

std::string briefly(const std::optional<double> &value, double scale, const char *unit)
{
    return value ? brief(*value * scale) + unit : std::string("-");
}

/// Nothing of what nobody knows.
void addNumber(Table &table, const char *name, const ModelNumber &number, double scale, const std::string &unit)
{
    if (number.value)
        table.add({name, brief(scale * *number.value), number.error ? brief(scale * *number.error) : "", unit});
}

void addBreakaway(Table &table, const MotorFound &motor)
{
    const bool inVolts = motor.supply > 0.0;
    const double scale = inVolts ? motor.supply : 100.0;
    const std::string unit = inVolts ? "V" : "% duty";
    for (const auto &[name, way] :
        {std::pair("forward", motor.ramp->forward), std::pair("reverse", motor.ramp->reverse)}) {
        table.add(
            {std::string("breakaway ") + name, brief(scale * way.breakaway), brief(scale * way.breakawayError), unit});
        table.add(
            {std::string("friction ") + name, brief(scale * way.friction), brief(scale * way.frictionError), unit});
    }
}

void printModel(Output &out, const TuneReport &report)
{
    const MotorFound &motor = *report.motor;
    const ModelNumbers numbers = modelNumbers(report);
    Table table({"model", "value", "±", "unit"});
    addNumber(table, "gain", numbers.gain, 1.0, motor.unit);
    addNumber(table, "tau", numbers.tau, 1e3, "ms");
    addNumber(table, "delay of the loop", numbers.delay, 1e3, "ms");
    addNumber(table, "friction", numbers.friction, 100.0, "% duty");
    if (motor.ramp)
        addBreakaway(table, motor);
    addNumber(table, "load one way", numbers.load, 100.0, "% duty");
    if (numbers.load.value) {
        addNumber(table, "gain forward", numbers.forward, 1.0, motor.unit);
        addNumber(table, "gain reverse", numbers.reverse, 1.0, motor.unit);
    }
    addNumber(table, "noise at rest", numbers.noise, 1.0, "counts");
    addNumber(table, "order to motion", numbers.latency, 1e3, "ms");
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
    for (const Message &note : designNotes(report))
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
    QJsonObject object{{QStringLiteral("result"), qt(toString(report.result))},
        {QStringLiteral("device"), qt(report.device)}, {QStringLiteral("loop"), qt(toString(report.loop))},
        {QStringLiteral("axis"), report.axis}, {QStringLiteral("slot"), report.slot},
        {QStringLiteral("simulated"), report.simulated}, {QStringLiteral("stopped"), report.stopped},
        {QStringLiteral("seconds"), report.seconds}, {QStringLiteral("trials"), mb::toJson(report.trials)},
        {QStringLiteral("evidence"), qt(report.evidence.english())}, {QStringLiteral("quality"), qualityToJson(report)},
        {QStringLiteral("gains"), gainsToJson(report)}, {QStringLiteral("notes"), notesToJson(report)}};
    object.insert(QStringLiteral("model"), report.motor ? QJsonValue(modelToJson(report)) : QJsonValue());
    object.insert(QStringLiteral("predicted"),
        report.predicted ? QJsonValue(mb::toJson(report.predicted->metrics)) : QJsonValue());
    object.insert(
        QStringLiteral("measured"), report.proof.empty() ? QJsonValue() : QJsonValue(mb::toJson(report.measured)));
    object.insert(QStringLiteral("profile"),
        report.profile ? QJsonValue(QJsonObject{{QStringLiteral("speed"), report.profile->speed},
            {QStringLiteral("acceleration"), report.profile->acceleration}})
                       : QJsonValue());
    object.insert(QStringLiteral("margins"),
        report.margins ? QJsonValue(QJsonObject{{QStringLiteral("ms"), mb::toJson(report.margins->ms)},
            {QStringLiteral("gm"), mb::toJson(report.margins->gain)},
            {QStringLiteral("pm"), mb::toJson(report.margins->phase)}})
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
