// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/storytext.h"

#include <array>
#include <cstdio>

namespace mb::test {
namespace {

std::string joinedOf(const std::vector<std::string> &words)
{
    std::string text;
    for (const std::string &word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

} // namespace

std::string numberOf(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value == 0.0 ? 0.0 : value);
    return text.data();
}

std::string secondsOf(Duration time)
{
    const auto all = std::chrono::duration_cast<std::chrono::microseconds>(time).count();
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%lld.%06lld", static_cast<long long>(all / 1000000),
        static_cast<long long>(all % 1000000));
    return text.data();
}

std::string textOf(const Identity &identity)
{
    std::string text = identity.family + ':' + std::to_string(identity.address);
    if (identity.session)
        text += '@' + std::to_string(*identity.session);
    text += ' ' + std::string(toString(identity.state));
    for (const auto &[label, value] : {std::pair{"name", &identity.name}, {"serial", &identity.serial},
             {"firmware", &identity.firmware}, {"bootloader", &identity.bootloader}, {"dialect", &identity.dialect}})
        text += value->empty() ? "" : ' ' + std::string(label) + '=' + *value;
    for (const auto &[key, value] : identity.descriptors)
        text += " [" + key + ": " + value + ']';
    return identity.detail.empty() ? text : text + " (" + identity.detail.english() + ')';
}

std::string textOf(const Liveness &liveness)
{
    std::vector<std::string> words{liveness.heard ? "heard" : "silent"};
    if (liveness.moving)
        words.emplace_back("moving");
    if (liveness.mode)
        words.emplace_back(toString(*liveness.mode));
    if (liveness.foreignMaster)
        words.emplace_back("foreign-master");
    if (liveness.restarted)
        words.emplace_back("restarted");
    for (const std::string &fault : liveness.faults)
        words.push_back("fault:" + fault);
    for (const AxisLiveness &axis : liveness.axes)
        words.push_back('/' + std::string(axis.mode ? toString(*axis.mode) : "?") + (axis.moving ? ":moving" : ""));
    return joinedOf(words);
}

std::string textOf(std::span<const StateRow> table, const LiveStates &states)
{
    std::vector<std::string> words;
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (const auto on = states[{static_cast<std::uint16_t>(i)}])
            words.push_back((*on ? "" : "-") + std::string(table[i].key));
    }
    return joinedOf(words);
}

std::string textOf(const DecodedFrame &frame)
{
    std::string text = std::string(frame.message) + " to or from " + std::to_string(frame.address);
    if (frame.control)
        text += " (control)";
    for (const DecodedField &field : frame.fields)
        text += field.value == 0.0
            ? std::string()
            : ' ' + std::string(field.name) + '=' + numberOf(field.value) + std::string(field.unit);
    return text;
}

std::string textOf(const SetPoint &setPoint)
{
    std::vector<std::string> words{std::string(toString(setPoint.mode)), numberOf(setPoint.target)};
    const auto flag = [&words](bool on, const char *word) {
        if (on)
            words.emplace_back(word);
    };
    const auto number = [&words](double value, const std::string &word) {
        if (value != 0.0)
            words.push_back(word + '=' + numberOf(value));
    };
    number(setPoint.axis - 1 == 0 ? 0.0 : setPoint.axis, "axis");
    number(setPoint.slot, "slot");
    flag(setPoint.brake.value_or(false), "brake");
    flag(!setPoint.brake.value_or(true), "coast");
    number(setPoint.ramp, "ramp");
    flag(setPoint.reverseMotor, "reverse-motor");
    flag(setPoint.reverseSensor, "reverse-sensor");
    flag(setPoint.overrideLimits, "override-limits");
    flag(setPoint.disableForwardLimit, "no-forward-limit");
    flag(setPoint.disableReverseLimit, "no-reverse-limit");
    number(setPoint.velocity, "velocity");
    number(setPoint.acceleration, "acceleration");
    flag(setPoint.relative, "relative");
    flag(setPoint.buffered, "buffered");
    number(setPoint.order, "order");
    return joinedOf(words);
}

std::string textOf(const SetPointStream &stream)
{
    std::string text = stream.isRunning() ? "running" : "ended, " + std::string(toString(stream.end()));
    text += stream.isGliding() ? ", gliding:" : ":";
    for (const SetPoint &setPoint : stream.setPoints())
        text += " [" + textOf(setPoint) + ']';
    return stream.reason().empty() ? text : text + " (" + stream.reason().english() + ')';
}

std::string_view textOf(StopState state)
{
    constexpr std::array<std::string_view, 7> names{
        "none", "stopping", "owed", "seen", "by watchdog", "silent", "unconfirmed"};
    return names.at(static_cast<std::size_t>(state));
}

std::string textOf(const DeviceProfile &profile)
{
    std::vector<std::string> words;
    if (!profile.dialect.empty())
        words.push_back("dialect=" + profile.dialect);
    for (const auto &[key, value] : profile.calibration)
        words.push_back(key + '=' + numberOf(value));
    for (const auto &[key, value] : profile.written)
        words.push_back(key + ':' + std::to_string(value) + (profile.lost.contains(key) ? " lost" : ""));
    for (const auto &[key, value] : profile.counters)
        words.push_back(key + '#' + std::to_string(value));
    for (const auto &[key, value] : profile.verdicts)
        words.push_back(key + '"' + std::string(toString(value)) + '"');
    return joinedOf(words);
}

std::string_view textOf(PartState state)
{
    constexpr std::array<std::string_view, 5> names{"waiting", "active", "done", "repeated", "absent"};
    return names.at(static_cast<std::size_t>(state));
}

std::string valueText(bool value)
{
    return value ? "yes" : "no";
}

std::string valueText(std::int64_t value)
{
    return std::to_string(value);
}

std::string valueText(int value)
{
    return std::to_string(value);
}

std::string valueText(const std::vector<FaultRecord> &faults)
{
    std::vector<std::string> words;
    for (const FaultRecord &fault : faults)
        words.push_back(fault.key + (fault.active ? " active" : "") + (fault.sticky ? " sticky" : "")
            + (fault.count ? " ×" + std::to_string(*fault.count) : "") + ';');
    return words.empty() ? "no faults" : joinedOf(words);
}

std::string valueText(const std::vector<TransferOutcome> &outcomes)
{
    std::vector<std::string> words;
    for (const TransferOutcome &outcome : outcomes)
        words.push_back('#' + std::to_string(outcome.index.value) + '='
            + (outcome.raw ? std::to_string(*outcome.raw) : errorText(outcome.raw.error()))
            + (outcome.verified ? (*outcome.verified ? " verified" : " NOT verified") : ""));
    return joinedOf(words);
}

std::string valueText(const UpdateReport &report)
{
    return std::string(toString(report.outcome)) + " from '" + report.from + "' to '" + report.to + "', "
        + std::to_string(report.pages) + " pages, " + std::to_string(report.retries) + " retries, "
        + (report.verified ? "verified" : "not verified")
        + (report.fault ? ", " + std::string(toString(*report.fault)) : "") + ": " + report.summary().english();
}

std::string valueText(const ExperimentReport &report)
{
    std::string text = report.sentence.english();
    for (const auto &[key, value] : report.found)
        text += ' ' + key + '=' + numberOf(value);
    return text;
}

std::string errorText(const Error &error)
{
    return std::string(toString(error.fault)) + ": " + error.text();
}

std::string severityText(Severity severity)
{
    constexpr std::array<const char *, 4> names{"info", "good", "caution", "danger"};
    return names.at(static_cast<std::size_t>(severity));
}

} // namespace mb::test
