// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunekeys.h"

#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tunepage.h"
#include "widgets/plots/plotstack.h"

namespace mb {
namespace {

struct TuneKeys {
    Q_DECLARE_TR_FUNCTIONS(mb::TuneKeys)
};

/// The keys of cursors go to the plot at once.
void toggleCursors(PlotStack &stack)
{
    stack.setCursorsShown(!stack.cursorsShown());
    if (stack.cursorsShown())
        stack.setFocus(Qt::ShortcutFocusReason);
}

} // namespace

PageKeys *makeTuneKeys(TunePage &page)
{
    auto *keys = new PageKeys(page);
    TunePage *const tune = &page;
    keys->add({Qt::Key_F5}, TuneKeys::tr("writes what is staged and runs"), [tune] { tune->run(); });
    keys->add({QKeySequence(QStringLiteral("Shift+F5"))}, TuneKeys::tr("the same, four times over"),
        [tune] { tune->runRepeated(4); });
    keys->add({Qt::Key_F7}, TuneKeys::tr("a battery of steps: several sizes, both ways, and the worst of them"),
        [tune] { tune->showBattery(); });
    keys->add({Qt::Key_G}, TuneKeys::tr("goes to the first gain"), [tune] { tune->gainsPanel().focusFirst(); });
    keys->add({Qt::Key_S}, TuneKeys::tr("swaps the gain slots; disarms"), [tune] { tune->modePanel().swapSlots(); });
    keys->add({Qt::Key_B}, TuneKeys::tr("flips trials A and B"), [tune] { tune->trials().flip(); });
    keys->add({Qt::Key_A}, TuneKeys::tr("pins trial B as A"), [tune] { tune->trials().pinCurrent(); });
    keys->add({Qt::Key_L}, TuneKeys::tr("cursors in the plot: arrows move one, C changes to the other"),
        [tune] { toggleCursors(tune->shownStack()); });
    keys->add({Qt::Key_0}, TuneKeys::tr("fits time and value of the plot"), [tune] { tune->shownStack().fit(); });
    keys->add({Qt::Key_P}, TuneKeys::tr("pauses the live view, and goes on"), [tune] { tune->pauseLive(); });
    keys->add({Qt::Key_I}, TuneKeys::tr("identifies the device: it blinks"), [tune] { tune->identify(); });
    keys->add({QKeySequence::Undo}, TuneKeys::tr("undoes the last edit of gains, or else the last write to the unit"),
        [tune] { tune->undo(false); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))},
        TuneKeys::tr("does it again"), [tune] { tune->undo(true); });
    keys->add({QKeySequence::Print}, TuneKeys::tr("writes a report of the trials that are shown"),
        [tune] { tune->writeReport(); });
    keys->note({Qt::Key_J, Qt::Key_K}, TuneKeys::tr("held: moves the armed motor gently forwards or backwards"));
    keys->note({Qt::Key_Left, Qt::Key_Right},
        TuneKeys::tr("on a gain's slider: 2 %, with Shift 0.2 %, with Ctrl 20 %; the wheel does the same by 2 %"));
    return keys;
}

} // namespace mb
