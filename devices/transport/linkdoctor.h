// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/canlink.h"

#include <optional>
#include <string>

namespace mb {

struct CanInterface;

/// What is wrong with a link and what helps: one cause and one remedy, each one clause. The same for window and console.
struct Diagnosis {
    Ailment ailment = Ailment::None;
    Message cause;
    Message remedy;
    std::string command; ///< for a terminal, as it stands; empty when none helps

    [[nodiscard]] bool isHealthy() const { return ailment == Ailment::None; }
    /// "cause; remedy: command", what there is of it.
    [[nodiscard]] std::string text() const { return message().english(); }
    /// The same to be translated.
    [[nodiscard]] Message message() const;
    friend bool operator==(const Diagnosis &, const Diagnosis &) = default;
};

/// What can be seen of a link that a program uses. Values only, so that the judgement is the same everywhere.
struct LinkSymptoms {
    std::string name; ///< "can0"
    std::string scheme;
    LinkKind kind = LinkKind::Can;
    LinkState state = LinkState::Closed;
    Error loss; ///< of a lost link; without a cause where nothing is known
    LinkCounters counters;
    // Of CAN links:
    BusHealth health;
    int bitrate = 0;
    double load = 0.0;
    bool listenOnly = false;
    int receiveCapacity = 0; ///< frames; 0 unknown
    std::size_t backlog = 0;
};

[[nodiscard]] LinkSymptoms symptomsOf(const Link &link, Instant now);

/// Why an interface that nobody has opened cannot be used; healthy when it can.
[[nodiscard]] Diagnosis diagnose(const CanInterface &interface);
/// What is wrong with a link in use. `interface` is what the list of interfaces says of it now; nothing when it is not in
/// the list or has none. `listenable`: the controller can listen without disturbing the bus.
[[nodiscard]] Diagnosis diagnose(
    const LinkSymptoms &link, Instant now, const std::optional<Diagnosis> &interface, bool listenable);

/// What opening a link fails with where this is wrong.
[[nodiscard]] Error errorOf(const Diagnosis &diagnosis);
/// Why opening a link failed, from what it failed with.
[[nodiscard]] Diagnosis diagnose(const Error &opening);

/// Commands that bring a CAN interface up, with a bit rate where it needs one.
[[nodiscard]] std::string bringUpCommand(const std::string &name, bool needsBitrate, int bitrate);
/// Tries the common bit rates, listening only, until frames arrive. For a shell.
[[nodiscard]] std::string findBitrateCommand(const std::string &name);
/// "1 Mbit/s", "83.333 kbit/s".
[[nodiscard]] std::string bitrateText(int bitrate);

} // namespace mb
