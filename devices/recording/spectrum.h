// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "telemetry/history.h"

#include <optional>
#include <vector>

namespace mb {

/// The amplitudes of the sine waves that a stretch of samples is made of.
struct Spectrum {
    static constexpr std::size_t firstWave = 3; ///< what is below is of the window and of what drifts

    double rate = 0.0;             ///< samples per second of the even grid
    double resolution = 0.0;       ///< Hz between two amplitudes
    std::vector<double> amplitude; ///< peak value of the wave at i × resolution, in the unit of the samples; 0 is 0
    Instant from{};                ///< the stretch that was taken
    Instant to{};
    bool shortened = false; ///< a gap, or the longest length, left only a part of the selection

    /// The largest wave that stands out of what is on both sides of it; nothing where none does: a step has no frequency.
    [[nodiscard]] std::optional<std::size_t> peak() const;
    [[nodiscard]] double frequency(std::size_t index) const { return static_cast<double>(index) * resolution; }
};

/// The longest stretch without a gap, at most 2^20 samples, without its line of least squares, on an even grid (line between neighbours)
/// at the median distance of the samples, under a Hann window. OutOfRange when fewer than 16 samples connect.
[[nodiscard]] Result<Spectrum> spectrumOf(const std::vector<Point> &points);

} // namespace mb
