// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunekeys.h"

#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/responseplot.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tunecommands.h"
#include "widgets/control/tuneexperiments.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tuneplot.h"
#include "widgets/plots/plotstack.h"

namespace mb {
namespace {

struct TuneKeys {
    Q_DECLARE_TR_FUNCTIONS(mb::TuneKeys)
};

/// The plot that is in sight.
PlotStack &shownStack(const TuneParts &parts)
{
    return parts.commands->isLive() ? parts.plot->stack() : parts.trials->plot().stack();
}

/// The keys of cursors go to the plot at once.
void toggleCursors(PlotStack &stack)
{
    stack.setCursorsShown(!stack.cursorsShown());
    if (stack.cursorsShown())
        stack.setFocus(Qt::ShortcutFocusReason);
}

/// Nothing where the experiments are shown.
void pauseLive(const TuneParts &parts)
{
    if (parts.commands->isLive())
        parts.plot->stack().view().setLive(!parts.plot->stack().view().isLive());
}

void addOrders(PageKeys &keys, const TuneKeyOrders &orders)
{
    keys.add({Qt::Key_F5}, TuneKeys::tr("writes what is staged and runs"), orders.run);
    keys.add({QKeySequence(QStringLiteral("Shift+F5"))}, TuneKeys::tr("the same, four times over"), [orders] {
        if (!orders.parts.commands->isLive())
            orders.form->setRepeats(4);
        orders.run();
    });
    keys.add(
        {Qt::Key_F7}, TuneKeys::tr("a battery of steps: several sizes, both ways, and the worst of them"), [orders] {
            if (!orders.parts.commands->isLive())
                orders.experiments->showBattery();
        });
}

void addViews(PageKeys &keys, const TuneParts &parts)
{
    keys.add({Qt::Key_G}, TuneKeys::tr("goes to the first gain"),
        [column = parts.column] { column->gainsPanel().focusFirst(); });
    keys.add({Qt::Key_S}, TuneKeys::tr("swaps the gain slots; disarms"),
        [column = parts.column] { column->modePanel().swapSlots(); });
    keys.add({Qt::Key_B}, TuneKeys::tr("flips trials A and B"), [trials = parts.trials] { trials->flip(); });
    keys.add({Qt::Key_A}, TuneKeys::tr("pins trial B as A"), [trials = parts.trials] { trials->pinCurrent(); });
    keys.add({Qt::Key_L}, TuneKeys::tr("cursors in the plot: arrows move one, C changes to the other"),
        [parts] { toggleCursors(shownStack(parts)); });
    keys.add({Qt::Key_0}, TuneKeys::tr("fits time and value of the plot"), [parts] { shownStack(parts).fit(); });
    keys.add({Qt::Key_P}, TuneKeys::tr("pauses the live view, and goes on"), [parts] { pauseLive(parts); });
}

} // namespace

PageKeys *makeTuneKeys(QWidget &page, const TuneKeyOrders &orders)
{
    auto *keys = new PageKeys(page);
    addOrders(*keys, orders);
    addViews(*keys, orders.parts);
    keys->add({Qt::Key_I}, TuneKeys::tr("identifies the device: it blinks"),
        [motion = orders.motion] { motion->identify(); });
    keys->add({QKeySequence::Undo}, TuneKeys::tr("undoes the last edit of gains, or else the last write to the unit"),
        [gains = orders.gains] { gains->undo(false); });
    keys->add({QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))},
        TuneKeys::tr("redoes the last edit or write"), [gains = orders.gains] { gains->undo(true); });
    keys->add({QKeySequence::Print}, TuneKeys::tr("writes a report of the trials that are shown"),
        [experiments = orders.experiments] { experiments->writeReport(); });
    keys->note({Qt::Key_J, Qt::Key_K}, TuneKeys::tr("held: moves the armed motor gently forwards or backwards"));
    keys->note({Qt::Key_Left, Qt::Key_Right},
        TuneKeys::tr("on a gain's slider: 2 %, with Shift 0.2 %, with Ctrl 20 %; the wheel does the same by 2 %"));
    return keys;
}

} // namespace mb
