// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trialrecorder.h"

#include <map>
#include <string>

namespace mb::tuning {

/// What was found of axes during this run of the program: which count the right way, and how slowly a braked motor stops. What a
/// profile kept is shown, and never skips the check.
class DirectionBook {
public:
    /// The duty that moved it then (0 where it was sent); nothing: not checked yet.
    [[nodiscard]] std::optional<double> find(const std::string &device, int axis) const
    {
        const auto found = m_checked.find({device, axis});
        return found == m_checked.end() ? std::nullopt : std::optional(found->second);
    }
    void add(const std::string &device, int axis, double duty) { m_checked[{device, axis}] = duty; }
    /// s, the time constant of its motor and load; 0: not known.
    [[nodiscard]] double lag(const std::string &device, int axis) const
    {
        const auto found = m_lags.find({device, axis});
        return found == m_lags.end() ? 0.0 : found->second;
    }
    void setLag(const std::string &device, int axis, double lag) { m_lags[{device, axis}] = lag; }
    /// Motor or sensor may have been plugged differently.
    void forget(const std::string &device)
    {
        std::erase_if(m_checked, [&device](const auto &entry) { return entry.first.first == device; });
        std::erase_if(m_lags, [&device](const auto &entry) { return entry.first.first == device; });
    }

private:
    std::map<std::pair<std::string, int>, double> m_checked;
    std::map<std::pair<std::string, int>, double> m_lags;
};

/// Duty of its strongest push.
[[nodiscard]] double largestOfDirection(const Envelope &envelope);

/// Pushes the motor at 8 % duty for at most 0.3 s, harder until it moves, each time only as far as is clear; without a duty
/// command, sends it the short way of TrialTraits::nudge, and longer ones up to `farthest`. Yields the duty that moved it (0 where it
/// was sent). The verdict goes into the device's profile; a wrong one, and no motion up to the duty limit, are trips of the recorder's kind:
/// the error is Unsafe, and `trip` says which, where the recorder has none. The stream is idle before and after.
[[nodiscard]] Task<double> checkDirection(Device &device, SetPointStream &stream, TrialRecorder &recorder, int axis,
    GuardPlan guards, std::optional<Trip> &trip, double farthest = 0.0);

/// Moves an axis by this set-point for `limit` at most, which begins with its first frame: a guardian that is still on its way costs it
/// nothing. Ends where the motor has gone `enough` counts, or does not begin to go. Yields the counts once it rests. Unsafe where something
/// else has ended it, a trip of the recorder's too, and Cancelled where somebody has. The stream is idle before and after.
[[nodiscard]] Task<double> push(Device &device, SetPointStream &stream, const TrialRecorder &recorder,
    SetPoint setPoint, double enough, Duration limit);
/// Waits until what the stream was given is sent, or never will be.
[[nodiscard]] Task<void> untilSent(Clock &clock, const SetPointStream &stream);
/// Waits until the device is seen stopped, at most so long, telling it again meanwhile; whether it was.
[[nodiscard]] Task<bool> confirmStop(Device &device, Duration longest = std::chrono::seconds(2));
/// Waits until this axis, or every one, is told to stand, at most 5 s; whether it does. What is silent is not seen to stand.
[[nodiscard]] Task<bool> untilAtRest(Device &device, std::optional<int> axis = std::nullopt);

} // namespace mb::tuning
