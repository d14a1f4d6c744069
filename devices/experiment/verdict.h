// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trialrecorder.h"

#include <string_view>

namespace mb::tuning {

/// What is known when an experiment is over.
struct Ending {
    bool completed = false; ///< all that was planned was done, and nobody had ended it by then
    std::optional<Trip> trip;
    SetPointStream::End stream = SetPointStream::End::None; ///< None: it never ran
    Message streamReason;
    bool interrupted = false;
    bool linkOpen = true;
    std::optional<Error> error;
};

/// Who the device of a trial is.
void describe(Trial &trial, const Device &device);
/// Smallest difference that the samples of a trace have.
[[nodiscard]] double resolutionOf(const Trace &trace);
/// Reason, detail and the flag `aborted`.
void nameEnding(Trial &trial, const Ending &ending);
/// What a flag is called there; itself where it is not known here.
[[nodiscard]] std::string_view flagLabel(std::string_view flag);
/// Metrics with their errors, signals and flags, from the steps to Y (edge and end) and the ways back; of what was recorded within a
/// stretch around the first edge.
void measure(Trial &trial, const Family &family, const TrialRecorder &recorder,
    const std::vector<std::pair<Instant, Instant>> &holds, const std::vector<std::pair<Instant, Instant>> &returns,
    const Span &within = TrialRecorder::everything);

} // namespace mb::tuning
