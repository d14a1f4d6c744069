// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/calibrations.h"

#include <QtGlobal>

#include <array>

namespace mb::quadquad2drv::calibration {
namespace {

constexpr std::array<Choice, 2> shifts{{
    {plainTarget, QT_TRANSLATE_NOOP("table", "counts/s (safe)")},
    {shiftedTarget, QT_TRANSLATE_NOOP("table", "counts/s × 4096")},
}};
constexpr std::array<Choice, 2> inputs{{
    {asLibrary, QT_TRANSLATE_NOOP("table", "as the library")},
    {asDataSheet, QT_TRANSLATE_NOOP("table", "as the data sheet")},
}};

constexpr std::string_view shiftHelp = QT_TRANSLATE_NOOP("table",
    "The data sheet contradicts itself on velocity targets. With plain counts/s a board that wants × 4096 hardly "
    "moves; the "
    "opposite mistake asks for full speed. Change it only when a board hardly moves, and with a small power limit.");
constexpr std::string_view inputHelp = QT_TRANSLATE_NOOP("table",
    "Data sheet and the maker's library give polarity and edges of the inputs opposite bits. The library is more "
    "likely right; "
    "an experiment with the status bit tells.");
constexpr std::string_view scaleHelp = QT_TRANSLATE_NOOP("table",
    "Power units (8191 is full power) that a raw gain of 1 gives. The maker does not tell; an experiment finds it.");

constexpr double smallest = 1e-9;
constexpr double greatest = 1e6;

constexpr std::array<Calibration, 7> rows{{
    {targetShift, "", QT_TRANSLATE_NOOP("table", "velocity target"), shiftHelp, plainTarget, shiftedTarget, shifts},
    {inputReading, "", QT_TRANSLATE_NOOP("table", "input polarity"), inputHelp, asLibrary, asDataSheet, inputs},
    {velocityP, "", QT_TRANSLATE_NOOP("table", "velocity P scale"), scaleHelp, smallest, greatest, {}, Mode::Velocity,
        Role::Proportional},
    {velocityI, "", QT_TRANSLATE_NOOP("table", "velocity I scale"), scaleHelp, smallest, greatest, {}, Mode::Velocity,
        Role::Integral},
    {positionP, "", QT_TRANSLATE_NOOP("table", "position P scale"), scaleHelp, smallest, greatest, {}, Mode::Position,
        Role::Proportional},
    {positionI, "", QT_TRANSLATE_NOOP("table", "position I scale"), scaleHelp, smallest, greatest, {}, Mode::Position,
        Role::Integral},
    {positionD, "", QT_TRANSLATE_NOOP("table", "position D scale"), scaleHelp, smallest, greatest, {}, Mode::Position,
        Role::Derivative},
}};

} // namespace

std::span<const Calibration> table()
{
    return rows;
}

} // namespace mb::quadquad2drv::calibration
