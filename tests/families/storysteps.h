// SPDX-License-Identifier: GPL-3.0-or-later
// What stories of all families do with a device.
#pragma once

#include "families/storystage.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mb::test {

[[nodiscard]] inline SetPoint wish(Mode mode, double target, int axis = 1)
{
    SetPoint made;
    made.mode = mode;
    made.target = target;
    made.axis = axis;
    return made;
}

/// Of the rows that a scan found.
[[nodiscard]] inline Identity rowOf(const std::vector<Identity> &rows, std::string_view family, int address)
{
    const auto found = std::find_if(
        rows.begin(), rows.end(), [&](const Identity &row) { return row.family == family && row.address == address; });
    return found == rows.end() ? Identity{} : *found;
}

[[nodiscard]] inline ParameterIndex indexOf(const Device &device, std::string_view key)
{
    return findParameter(device.family().parameters, key).value();
}

/// "request 7": the 7th piece that the program sends is lost; "answer 7": what comes soon after it. Nothing otherwise.
[[nodiscard]] inline StoryStage::Hole holeOf(const std::string &variant, Duration piece, Duration answer)
{
    if (variant.starts_with("request "))
        return {std::stoi(variant.substr(8)), Duration::zero(), piece};
    if (variant.starts_with("answer "))
        return {std::stoi(variant.substr(7)), piece, answer};
    return {};
}

inline void addHoles(std::vector<std::string> &variants, int first, int last)
{
    for (int piece = first; piece <= last; ++piece) {
        variants.push_back("request " + std::to_string(piece));
        variants.push_back("answer " + std::to_string(piece));
    }
}

/// As a window that is alive: the lease is renewed every 100 ms. What happens in the first `shown` is told, the rest summed up.
inline void keepDriving(StoryStage &stage, SetPointStream &stream, Duration shown, Duration summed)
{
    using namespace std::chrono_literals;
    for (Duration left = shown; left > Duration::zero(); left -= 100ms) {
        stream.renew();
        stage.advance(std::min<Duration>(left, 100ms));
    }
    stage.sum([&] {
        for (Duration left = summed; left > Duration::zero(); left -= 100ms) {
            stream.renew();
            stage.advance(std::min<Duration>(left, 100ms));
        }
    });
}

/// Starts a motion, or goes on with another set-point.
inline void drive(StoryStage &stage, Device &device, const SetPoint &setPoint, Duration shown, Duration summed,
    const Glide &glide = {})
{
    using namespace std::chrono_literals;
    stage.heading("drive " + textOf(setPoint) + (glide.rate != 0.0 ? " gliding " + numberOf(glide.rate) : ""));
    if (const Message caution = device.caution(setPoint); !caution.empty())
        stage.outcome("caution: " + caution.english());
    SetPointStream &stream = stage.stream(device);
    stage.outcome(
        resultText(stream.isRunning() ? stream.update(setPoint, glide) : stream.start(setPoint, 500ms, glide)));
    keepDriving(stage, stream, shown, summed);
}

/// Stops by the stream, and looks on.
inline void halt(StoryStage &stage, Device &device, Duration shown, Duration summed)
{
    stage.heading("stop");
    stage.stream(device).stop();
    stage.advance(shown);
    stage.wait(summed);
    stage.outcome(device.isSeenStopped() ? "seen to stand" : "not seen to stand");
}

/// Everything that can be read, then every parameter at both ends of its range and beyond them. The motor stands.
inline void tellParameters(StoryStage &stage, Device &device, bool inSum)
{
    const auto told = [&](const std::function<void()> &work) {
        if (inSum)
            stage.sum(work);
        else
            work();
    };
    told([&] {
        auto task = readParameters(device, readable(device), stage.progress());
        (void)stage.perform("read all", std::move(task));
    });
    const auto table = device.parameters().table();
    for (std::uint16_t i = 0; i < table.size(); ++i) {
        const Parameter &row = table[i];
        if (!device.offers({i})) {
            stage.outcome(std::string(row.key) + " is not offered");
            continue;
        }
        told([&] {
            stage.heading(std::string(row.key));
            for (const double number : {row.minimum, row.maximum, row.fallback}) {
                const auto raw = toRaw(row, number);
                (void)stage.perform(
                    toText(row, *raw), writeParameters(device, {ParameterChange{{i}, *raw}}, stage.progress()));
            }
            const RawRange wire = rangeOf(row.type);
            for (const std::int64_t raw : {wire.low - 1, wire.high + 1})
                (void)stage.perform("raw " + std::to_string(raw), device.write({i}, raw));
        });
    }
}

} // namespace mb::test
