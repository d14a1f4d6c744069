// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/stimulus.h"
#include "model/device.h"
#include "model/trialtraits.h"

#include <QJsonObject>

namespace mb::tuning {

/// Channel of an axis; nothing where the family has none of this key.
[[nodiscard]] std::optional<ChannelIndex> axisChannel(const Device &device, std::string_view key, int axis);
/// The device tells its current in ampere.
[[nodiscard]] bool hasCurrentScale(const Device &device, int axis);
/// What a mode's measured value is called: velocity, position, current; velocity for an open loop.
[[nodiscard]] std::string_view measuredOf(Mode mode);
[[nodiscard]] bool isClosedLoop(Mode mode);

/// The limits that the device itself has and that are on, seen from `position`, by what is known of its parameters (in table
/// order) once `changes` are in force. What is not known bounds nothing.
[[nodiscard]] Envelope ownLimits(const Family &family, std::span<const ParameterStore::Entry> entries, int axis,
    int slot, double position, const std::vector<ParameterChange> &changes = {});
/// The same, read anew.
[[nodiscard]] Task<Envelope> readOwnLimits(
    Device &device, int axis, int slot, double position, std::vector<ParameterChange> changes = {});

/// What the bounds of a trial depend on, of a device.
struct EnvelopeFacts {
    std::string selector;
    bool simulated = false;
    bool currentScale = false; ///< it tells its current in ampere
};
[[nodiscard]] EnvelopeFacts factsOf(const Device &device, int axis);

/// OutOfRange where somebody gives what is no bound: 0 leaves nothing that could move.
[[nodiscard]] Result<void> checkBound(const EnvelopeBound &bound, double value);

/// What is given of them, as files have it.
[[nodiscard]] QJsonObject limitsToJson(const Envelope &limits);
/// What bounds nothing is no limit, and is not taken for one.
[[nodiscard]] Envelope limitsFrom(const QJsonObject &object);

/// Of what was asked for and the device's own the narrower; on simulated units the bench's figures for the rest. Without a scale of its
/// current nothing bounds that, and the duty limit stands in.
[[nodiscard]] Envelope knownBounds(
    const Family &family, const EnvelopeFacts &facts, const Envelope &asked, const Envelope &own);
/// What bounds a trial: these. OutOfRange, naming what must be given, where travel or duty (speed, in a velocity loop) are not known.
[[nodiscard]] Result<Envelope> resolve(
    const Family &family, const EnvelopeFacts &facts, Mode mode, const Envelope &asked, const Envelope &own);

/// OutOfRange with the numbers when a stimulus would leave the envelope, whose travel is counted from `origin`; the motor stands `gone`
/// counts from there.
[[nodiscard]] Result<void> checkInside(
    const Envelope &envelope, Mode mode, const Stimulus &stimulus, int repeat, double origin, double gone = 0.0);

} // namespace mb::tuning
