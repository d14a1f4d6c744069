// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/identification.h"
#include "tuning/motoridentification.h"

#include <vector>

/// What a current loop has to move: resistance, noise and what a current does, out of pushes of a motor that hardly turns.
namespace mb::tuning {

/// Ohm's law out of short pushes: duty × supply = R·I + Ke·speed, each term as its integral, so that nothing is differentiated.
struct Ohm {
    double gain = 0.0; ///< A per duty at standstill: supply/R
    double gainError = 0.0;
    double back = 0.0; ///< duty that a count/s takes off it
    double backError = 0.0;
    double scatter = 0.0; ///< largest difference of one push's gain, of the gain
    double supply = 0.0;  ///< V at rest; 0: not told
};
/// OutOfRange where current or positions are missing or too few.
[[nodiscard]] Result<Ohm> fitOhm(const std::vector<Trial> &pushes);

/// How a current speeds its motor up.
struct PickUp {
    double rate = 0.0; ///< counts/s² per A beyond `idle`
    double idle = 0.0; ///< A, that friction takes
};
/// Of short pushes of several sizes; 0 where nothing moves.
[[nodiscard]] PickUp pickUpOf(const std::vector<Trial> &pushes);

/// A, standard deviation of what the unit tells while nothing flows, before each push.
[[nodiscard]] double currentNoise(const std::vector<Trial> &pushes);

/// For a current loop: the gain from pushes so short and weak that the motor hardly turns; its lag L/R is taken for 0.5 ms.
class CurrentIdentification final : public MotorIdentification {
public:
    [[nodiscard]] Task<void> identify(AutotuneRun &run) override;

private:
    [[nodiscard]] Task<void> probe(AutotuneRun &run);
    [[nodiscard]] Task<void> push(AutotuneRun &run);
    [[nodiscard]] Result<void> conclude(AutotuneRun &run) const;

    std::vector<Trial> m_pushes;
    double m_duty = 0.0; ///< of the stronger pushes
};

} // namespace mb::tuning
