// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <QString>

#include <span>
#include <string_view>

namespace mb {

/// Where in the window a step is done.
enum class StoryPlace { Overview, Parameters, Tune, Design };

/// What the drawing of a story shows.
enum class StoryPicture { Overshoot, Limit, Short };

/// What must really have happened before a step counts as done (guide.h looks for it).
enum class Proof {
    Selected,     ///< the unit of the story is the one that pages show
    Armed,        ///< and it may be moved
    Stepped,      ///< a trial of its velocity loop ended as planned
    Tamed,        ///< a later one overshot by 5 % at most
    LimitOn,      ///< its current limit is in force
    CurrentShown, ///< a trial ended as planned that tells its peak current
    StoppedShort, ///< a trial of its position loop ended as planned, and the motor rests well before its target
    Arrived,      ///< after a later one it rests at it
    Stored        ///< something was written, and the unit has proved that flash has it
};

/// One step of a story. Texts are English, translated by storyText(); %1 in them is the title of its unit, %2 the key of this step as it
/// is now; of a unit that stops short (DemoUnits) %3 is the step, %4 by how much, %5 the gains with which it arrives; %6 a sentence of when
/// it stores by itself, %7 the key that switches its current limit.
struct StoryStep {
    Proof proof = Proof::Selected;
    StoryPlace place = StoryPlace::Overview;
    const char *name = "";  ///< one word or two, for the list of steps
    const char *words = ""; ///< what to do, where, with which key
    const char *key = "";   ///< as it came, of the table of its place; empty: none
};

/// Something to try on a simulated unit, from finding it to a value that stays.
struct Story {
    std::string_view key;
    const char *title = "";   ///< "%1 overshoots: tame it in a minute"
    const char *words = "";   ///< what is wrong, and what to do about it
    const char *caption = ""; ///< of its drawing
    int minutes = 1;
    StoryPicture picture = StoryPicture::Overshoot;
    int DemoUnits::*unit = &DemoUnits::tuned; ///< on a simulated link
    std::span<const StoryStep> steps;
};

/// The simulated link that all of them play on.
constexpr const char *storyLink = "sim:";

[[nodiscard]] std::span<const Story> stories();
/// The family whose simulated unit it plays on; nullptr: no family of this build has one that can, and the story is not among stories().
[[nodiscard]] const Family *storyFamily(const Story &story);
/// What its unit drives, and what hangs on it.
[[nodiscard]] QString storyMotor(const Story &story);
[[nodiscard]] QString storyParts(const Story &story);
/// Key of the parameter that switches the limit of a motor's current; empty: the family has none.
[[nodiscard]] std::string_view currentSwitch(const Family &family);
/// `key`: what stands for %2; empty: whoever reads it has to look for the button.
[[nodiscard]] QString storyText(const Story &story, const char *english, const QString &key = {});

} // namespace mb
