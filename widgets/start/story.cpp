// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/story.h"

#include "model/parameter.h"
#include "model/registry.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <vector>

namespace mb {
namespace {

struct StoryWords {
    Q_DECLARE_TR_FUNCTIONS(Stories)
};

constexpr StoryStep taming[] = {
    {Proof::Selected, StoryPlace::Tune, QT_TRANSLATE_NOOP("Stories", "Select"),
        QT_TRANSLATE_NOOP("Stories", "Click %1 in the list at the left. Everything that follows is about it.")},
    {Proof::Armed, StoryPlace::Tune, QT_TRANSLATE_NOOP("Stories", "Arm"),
        QT_TRANSLATE_NOOP("Stories",
            "Hold the Arm button at the top, SAFE, for one second (or Ctrl+Shift+F12). Nothing moves before. Esc "
            "stops, "
            "always.")},
    {Proof::Stepped, StoryPlace::Tune, QT_TRANSLATE_NOOP("Stories", "Step"),
        QT_TRANSLATE_NOOP("Stories", "Press %2: the motor steps to a speed and back, and the overshoot is measured."),
        "F5"},
    {Proof::Tamed, StoryPlace::Design, QT_TRANSLATE_NOOP("Stories", "Tune"),
        QT_TRANSLATE_NOOP("Stories",
            "Press %2 on the page Design: the program finds gains and proves them. Tamed: a step overshoots by 5 % at "
            "most."),
        "F6"},
    {Proof::Stored, StoryPlace::Parameters, QT_TRANSLATE_NOOP("Stories", "Store"),
        QT_TRANSLATE_NOOP("Stories",
            "%6Press Store and prove on the page Parameters: done when the unit proves that its flash has the gains.")},
};

constexpr StoryStep limiting[] = {
    {Proof::Selected, StoryPlace::Parameters, QT_TRANSLATE_NOOP("Stories", "Select"),
        QT_TRANSLATE_NOOP("Stories", "Click %1 in the list at the left.")},
    {Proof::LimitOn, StoryPlace::Parameters, QT_TRANSLATE_NOOP("Stories", "Limit"),
        QT_TRANSLATE_NOOP("Stories",
            "On the page Parameters switch the current limit on (search: %7), set it to what the motor "
            "may have, and write.")},
    {Proof::Armed, StoryPlace::Tune, QT_TRANSLATE_NOOP("Stories", "Arm"),
        QT_TRANSLATE_NOOP("Stories", "Hold the Arm button at the top for one second (or Ctrl+Shift+F12).")},
    {Proof::CurrentShown, StoryPlace::Tune, QT_TRANSLATE_NOOP("Stories", "Step"),
        QT_TRANSLATE_NOOP("Stories", "Press %2 on the page Tune: the peak current of the step stands in its table."),
        "F5"},
    {Proof::Stored, StoryPlace::Parameters, QT_TRANSLATE_NOOP("Stories", "Store"),
        QT_TRANSLATE_NOOP("Stories", "%6Press Store and prove on the page Parameters.")},
};

constexpr StoryStep arriving[] = {
    {Proof::Selected, StoryPlace::Tune, QT_TRANSLATE_NOOP("Stories", "Select"),
        QT_TRANSLATE_NOOP("Stories", "Click %1 in the list at the left. Everything that follows is about it.")},
    {Proof::Armed, StoryPlace::Tune, QT_TRANSLATE_NOOP("Stories", "Arm"),
        QT_TRANSLATE_NOOP("Stories",
            "On the page Tune choose Position: what is armed is armed for one mode. Then hold the Arm button at the "
            "top "
            "for one second (or Ctrl+Shift+F12).")},
    {Proof::StoppedShort, StoryPlace::Tune, QT_TRANSLATE_NOOP("Stories", "Step"),
        QT_TRANSLATE_NOOP("Stories",
            "Enter %3 as the target (behind ▸) and press %2: the motor goes there and back, and stops about %4 counts "
            "short."),
        "F5"},
    {Proof::Arrived, StoryPlace::Tune, QT_TRANSLATE_NOOP("Stories", "Arrive"),
        QT_TRANSLATE_NOOP("Stories",
            "What P makes of the last counts is less than friction. Enter among the gains %5 (a stiffer P overcomes "
            "it, "
            "and more D keeps it from swinging), and press %2 again: it rests within 5 counts of its target."),
        "F5"},
};

constexpr Story table[] = {
    {"tame", QT_TRANSLATE_NOOP("Stories", "%1 overshoots: tame it in a minute"),
        QT_TRANSLATE_NOOP("Stories", "With these gains it goes too far. Find some with which it does not."),
        QT_TRANSLATE_NOOP("Stories", "velocity, set-point dashed"), 1, StoryPicture::Overshoot,
        &DemoUnits::overshooting, taming},
    {"limit", QT_TRANSLATE_NOOP("Stories", "%1 has no current limit: set one that saves it"),
        QT_TRANSLATE_NOOP(
            "Stories", "Stalled, it draws all that its supply gives, and nothing holds it back. Limit it."),
        QT_TRANSLATE_NOOP("Stories", "current, limit dashed"), 3, StoryPicture::Limit, &DemoUnits::tuned, limiting},
    {"arrive", QT_TRANSLATE_NOOP("Stories", "%1 stops short: make it arrive"),
        QT_TRANSLATE_NOOP("Stories", "This one stops about %4 counts short and stays there. Make it arrive."),
        QT_TRANSLATE_NOOP("Stories", "position, set-point dashed"), 3, StoryPicture::Short, &DemoUnits::stoppingShort,
        arriving},
};

/// "DMC60C #7"
QString unitOf(const Story &story)
{
    const Family *family = storyFamily(story);
    return family ? QStringLiteral("%1 #%2").arg(qt(family->title)).arg(family->demo->*story.unit) : QString();
}

DemoMotor motorOf(const Story &story)
{
    const Family *family = storyFamily(story);
    const auto motors = family ? family->demo->motors : std::span<const DemoMotor>();
    const auto found = std::ranges::find_if(
        motors, [&](const DemoMotor &motor) { return motor.address == family->demo->*story.unit; });
    return found == motors.end() ? DemoMotor() : *found;
}

} // namespace

std::string_view currentSwitch(const Family &family)
{
    const auto limits = family.trials ? family.trials->limits : std::span<const DeviceLimit>();
    const auto found = std::ranges::find_if(limits, [](const DeviceLimit &limit) {
        return limit.bounds == DeviceLimit::Bounds::Current && !limit.enabled.empty();
    });
    return found == limits.end() ? std::string_view() : found->enabled;
}

const Family *storyFamily(const Story &story)
{
    const bool limits = story.picture == StoryPicture::Limit;
    const auto all = families();
    const auto found = std::ranges::find_if(all, [&](const Family *family) {
        return family->demo && family->demo->*story.unit != 0 && !(limits && currentSwitch(*family).empty());
    });
    return found == all.end() ? nullptr : *found;
}

std::span<const Story> stories()
{
    static const std::vector<Story> playable = [] {
        std::vector<Story> found;
        std::copy_if(std::begin(table), std::end(table), std::back_inserter(found), storyFamily);
        return found;
    }();
    return playable;
}

QString storyMotor(const Story &story)
{
    return tableText(motorOf(story).title);
}

QString storyParts(const Story &story)
{
    return tableText(motorOf(story).parts) + QStringLiteral(" · ") + unitOf(story);
}

QString storyText(const Story &story, const char *english, const QString &key)
{
    QString text = QCoreApplication::translate("Stories", english);
    const Family *family = storyFamily(story);
    if (!family)
        return text;
    const DemoUnits &demo = *family->demo;
    QStringList gains;
    for (const auto &[gain, value] : demo.arrivingGains) {
        if (const auto row = findParameter(family->parameters, gain))
            gains
                += QStringLiteral("%1 %2").arg(tableText(family->parameters[row->value].label), formatNumber(value, 0));
    }
    const auto storesAfter = family->capabilities.storesAfter.count();
    text.replace(QLatin1String("%6"),
        storesAfter > 0
            ? StoryWords::tr("It stores by itself %1 s after its last change: wait for that.").arg(storesAfter)
                + QLatin1Char(' ')
            : QString());
    const std::string_view limit = currentSwitch(*family);
    text.replace(QLatin1String("%7"), qt(limit.substr(0, limit.rfind('.')))); // with what it is set to
    text.replace(QLatin1String("%1"), unitOf(story));
    text.replace(QLatin1String("%3"), formatNumber(demo.shortStep, 0));
    text.replace(QLatin1String("%4"), formatNumber(demo.shortBy, 0));
    text.replace(QLatin1String("%5"), gains.join(QStringLiteral(", ")));
    return text.replace(QLatin1String("%2"), key.isEmpty() ? StoryWords::tr("the button") : key);
}

} // namespace mb
