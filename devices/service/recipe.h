// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"
#include "model/setpoint.h"
#include "model/trialtraits.h"

#include <QByteArray>

#include <optional>
#include <string>
#include <vector>

namespace mb {
struct Family;
}
namespace mb::tuning {
struct ExperimentPlan;
}

namespace mb::service {

/// What a self-test may find: a metric (tuning::metricKeys()) or a figure of the motor.
struct Acceptance {
    std::string key;
    std::optional<double> low; ///< nothing: as small as it likes
    double high = 0.0;         ///< of `encoder` without meaning
};
/// Keys besides those of the metrics. They are measured by pushes of duty.
namespace figure {
constexpr std::string_view resistance = "resistance"; ///< Ω
constexpr std::string_view friction = "friction";     ///< V; duty where the unit tells no bus voltage
constexpr std::string_view gain = "gain";             ///< counts/s per V; per full duty without bus voltage
constexpr std::string_view encoder = "encoder";       ///< counts both ways: true
} // namespace figure
[[nodiscard]] bool isFigure(std::string_view key);

struct FirmwareRule {
    std::string file; ///< Intel HEX
    std::string via;  ///< UpdateOptions::via; `openocd:stlink?target=f1` has the target behind it
};
struct ParameterRule {
    std::string file;   ///< as `get --file` writes it
    bool store = false; ///< save it where the unit does not do that by itself
};
struct NumberRule {
    int first = 1; ///< the next free one from here on
};
/// One experiment on a loop, and what it must show.
struct SelfTest {
    Mode loop = Mode::Velocity;
    std::optional<double> from;
    double to = 0.0;
    std::optional<double> seconds;
    int repeat = 1;
    int axis = 1;
    int slot = 0;
    Envelope limits;
    std::vector<Acceptance> accept;
};

/// The experiment that it is, without its limits.
[[nodiscard]] tuning::ExperimentPlan planOf(const SelfTest &test);

/// What is done to every unit, as its file says (docs/recipes.md#a-recipe). A value.
struct Recipe {
    std::string name;
    const Family *family = nullptr;
    std::optional<FirmwareRule> firmware;
    std::optional<ParameterRule> parameters;
    std::optional<NumberRule> number;
    std::optional<SelfTest> test;
};

/// The text of a file that says so.
[[nodiscard]] QByteArray toText(const Recipe &recipe);

} // namespace mb::service
