// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/story.h"

#include "model/registry.h"

#include <QCoreApplication>

#include <algorithm>

namespace mb {
namespace {

struct StoryWords {
    Q_DECLARE_TR_FUNCTIONS(Stories)
};

constexpr StoryStep taming[] = {
    {Proof::Selected, Place::Tune, QT_TRANSLATE_NOOP("Stories", "Select"),
        QT_TRANSLATE_NOOP("Stories", "Click %1 in the list at the left. Everything that follows is about it.")},
    {Proof::Armed, Place::Tune, QT_TRANSLATE_NOOP("Stories", "Arm"),
        QT_TRANSLATE_NOOP("Stories",
            "Hold the Arm button at the top, SAFE, for one second (or Ctrl+Shift+F12). Nothing moves before. Esc "
            "stops, "
            "always.")},
    {Proof::Stepped, Place::Tune, QT_TRANSLATE_NOOP("Stories", "Step"),
        QT_TRANSLATE_NOOP("Stories", "Press %2: the motor steps to a speed and back, and the overshoot is measured."),
        "F5"},
    {Proof::Tamed, Place::Design, QT_TRANSLATE_NOOP("Stories", "Tune"),
        QT_TRANSLATE_NOOP("Stories",
            "Press %2 on the page Design: the program finds gains and proves them. Tamed: a step overshoots by 5 % at "
            "most."),
        "F6"},
    {Proof::Stored, Place::Parameters, QT_TRANSLATE_NOOP("Stories", "Store"),
        QT_TRANSLATE_NOOP("Stories",
            "15 s after its last change the unit stores by itself. Then press Store and prove on the page Parameters: "
            "done when the unit proves that its flash has the gains.")},
};

constexpr StoryStep limiting[] = {
    {Proof::Selected, Place::Parameters, QT_TRANSLATE_NOOP("Stories", "Select"),
        QT_TRANSLATE_NOOP("Stories", "Click %1 in the list at the left.")},
    {Proof::LimitOn, Place::Parameters, QT_TRANSLATE_NOOP("Stories", "Limit"),
        QT_TRANSLATE_NOOP("Stories",
            "On the page Parameters switch the current limit on (search: current_limit), set it to what the motor "
            "may have, and write.")},
    {Proof::Armed, Place::Tune, QT_TRANSLATE_NOOP("Stories", "Arm"),
        QT_TRANSLATE_NOOP("Stories", "Hold the Arm button at the top for one second (or Ctrl+Shift+F12).")},
    {Proof::CurrentShown, Place::Tune, QT_TRANSLATE_NOOP("Stories", "Step"),
        QT_TRANSLATE_NOOP("Stories", "Press %2 on the page Tune: the peak current of the step stands in its table."),
        "F5"},
    {Proof::Stored, Place::Parameters, QT_TRANSLATE_NOOP("Stories", "Store"),
        QT_TRANSLATE_NOOP("Stories",
            "15 s after its last change the unit stores by itself. Then press Store and prove on the page "
            "Parameters.")},
};

constexpr StoryStep reviving[] = {
    {Proof::Selected, Place::Firmware, QT_TRANSLATE_NOOP("Stories", "Select"),
        QT_TRANSLATE_NOOP("Stories", "Click %1 in the list at the left. It says: in bootloader.")},
    {Proof::Writing, Place::Firmware, QT_TRANSLATE_NOOP("Stories", "Write"),
        QT_TRANSLATE_NOOP("Stories",
            "The demo image is loaded on the page Firmware. Press %2 and watch the pages arrive, the last one first."),
        "F5"},
    {Proof::Answers, Place::Firmware, QT_TRANSLATE_NOOP("Stories", "Prove"),
        QT_TRANSLATE_NOOP("Stories", "Wait until the unit answers with its new version. Nothing else counts as done.")},
};

constexpr Story table[] = {
    {"tame", QT_TRANSLATE_NOOP("Stories", "%1 overshoots: tame it in a minute"), QT_TRANSLATE_NOOP("Stories", "775pro"),
        QT_TRANSLATE_NOOP("Stories", "4096 counts a turn · %1"),
        QT_TRANSLATE_NOOP("Stories", "This one overshoots by about 20 %. Find gains that do not."),
        QT_TRANSLATE_NOOP("Stories", "velocity, set-point dashed"), 1, StoryPicture::Overshoot,
        &DemoUnits::overshooting, taming},
    {"limit", QT_TRANSLATE_NOOP("Stories", "%1 has no current limit: set one that saves it"),
        QT_TRANSLATE_NOOP("Stories", "CIM"),
        QT_TRANSLATE_NOOP("Stories", "load 9 × rotor inertia · 4096 counts a turn · %1"),
        QT_TRANSLATE_NOOP("Stories", "A stalled CIM draws more than 100 A, and nothing holds this one back. Limit it."),
        QT_TRANSLATE_NOOP("Stories", "current, limit dashed"), 3, StoryPicture::Limit, &DemoUnits::tuned, limiting},
    {"revive", QT_TRANSLATE_NOOP("Stories", "%1 has no program: bring it back"),
        QT_TRANSLATE_NOOP("Stories", "Interrupted update"),
        QT_TRANSLATE_NOOP("Stories", "waits in its bootloader · %1"),
        QT_TRANSLATE_NOOP("Stories", "Somebody cut its power while it was written. Give it firmware again."),
        QT_TRANSLATE_NOOP("Stories", "flash pages, written from the last to the first"), 2, StoryPicture::Pages,
        &DemoUnits::inBootloader, reviving},
};

} // namespace

const Family *storyFamily()
{
    const auto all = families();
    const auto found = std::find_if(all.begin(), all.end(), [](const Family *family) { return family->demo; });
    return found == all.end() ? nullptr : *found;
}

std::span<const Story> stories()
{
    return storyFamily() ? std::span<const Story>(table) : std::span<const Story>();
}

QString storyText(const Story &story, const char *english, const QString &key)
{
    QString text = QCoreApplication::translate("Stories", english);
    const Family *family = storyFamily();
    if (!family)
        return text;
    const QString title = QString::fromUtf8(family->title.data(), static_cast<int>(family->title.size()));
    text.replace(QLatin1String("%1"), QStringLiteral("%1 #%2").arg(title).arg(family->demo->*story.unit));
    return text.replace(QLatin1String("%2"), key.isEmpty() ? StoryWords::tr("the button") : key);
}

} // namespace mb
