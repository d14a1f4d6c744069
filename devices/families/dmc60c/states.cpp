// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/states.h"

#include <QtGlobal>

namespace mb::dmc60c {
namespace {

constexpr std::array<StateRow, 12> stateRows{{
    {"limit.current", QT_TRANSLATE_NOOP("table", "Current limit"), QT_TRANSLATE_NOOP("table", "current is limited")},
    {"limit.forward.switch", QT_TRANSLATE_NOOP("table", "Forward limit switch"),
        QT_TRANSLATE_NOOP("table", "forward limit switch holds"), StateKind::Switch},
    {"limit.reverse.switch", QT_TRANSLATE_NOOP("table", "Reverse limit switch"),
        QT_TRANSLATE_NOOP("table", "reverse limit switch holds"), StateKind::Switch},
    {"limit.forward.soft", QT_TRANSLATE_NOOP("table", "Forward soft limit"),
        QT_TRANSLATE_NOOP("table", "forward soft limit holds")},
    {"limit.reverse.soft", QT_TRANSLATE_NOOP("table", "Reverse soft limit"),
        QT_TRANSLATE_NOOP("table", "reverse soft limit holds")},
    {"limit.override", QT_TRANSLATE_NOOP("table", "Limit override"),
        QT_TRANSLATE_NOOP("table", "the set-point decides which limit switches count")},
    {"halted", QT_TRANSLATE_NOOP("table", "Halt"), QT_TRANSLATE_NOOP("table", "halted"), StateKind::Rest},
    {"input.limit.forward", QT_TRANSLATE_NOOP("table", "Pin of the forward limit switch"), {}, StateKind::Input},
    {"input.limit.reverse", QT_TRANSLATE_NOOP("table", "Pin of the reverse limit switch"), {}, StateKind::Input},
    {"input.encoder.a", QT_TRANSLATE_NOOP("table", "Encoder pin A"), {}, StateKind::Input},
    {"input.encoder.b", QT_TRANSLATE_NOOP("table", "Encoder pin B"), {}, StateKind::Input},
    {"input.encoder.index", QT_TRANSLATE_NOOP("table", "Encoder index pin"), {}, StateKind::Input},
}};
static_assert(checkStates(stateRows));

consteval StateIndex at(std::string_view key)
{
    return findState(stateRows, key).value();
}

/// Of a switch: hit, and neither switched off nor overridden.
bool holds(const LimitSwitch &limit, bool overridden, bool disabledByFrame)
{
    return limit.hit && !(overridden ? disabledByFrame : limit.disabled);
}

} // namespace

std::span<const StateRow> stateTable()
{
    return stateRows;
}

void takeStates(LiveStates &states, const StatusGeneral &status)
{
    states.set(at("limit.current"), status.currentLimitActive);
    states.set(at("limit.forward.switch"), holds(status.forward, status.limitOverride, status.forwardDisabledByFrame));
    states.set(at("limit.reverse.switch"), holds(status.reverse, status.limitOverride, status.reverseDisabledByFrame));
    states.set(at("limit.forward.soft"), status.softForwardHit && status.softForwardEnabled);
    states.set(at("limit.reverse.soft"), status.softReverseHit && status.softReverseEnabled);
    states.set(at("limit.override"), status.limitOverride);
    states.set(at("halted"), status.mode == ControlMode::NoDrive);
    states.set(at("input.limit.forward"), status.forward.pin);
    states.set(at("input.limit.reverse"), status.reverse.pin);
}

void takeStates(LiveStates &states, const StatusEncoder &status)
{
    states.set(at("input.encoder.a"), status.pinA);
    states.set(at("input.encoder.b"), status.pinB);
    states.set(at("input.encoder.index"), status.pinIndex);
}

} // namespace mb::dmc60c
