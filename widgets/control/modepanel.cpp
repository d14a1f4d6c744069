// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/modepanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/control/slotpanel.h"

#include <QButtonGroup>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace mb {
namespace {

constexpr std::array shown{Mode::Velocity, Mode::Position, Mode::Current, Mode::Duty, Mode::Voltage, Mode::Follow,
    Mode::RampPosition, Mode::RampVelocity};
constexpr int longLabel = 12; ///< characters; three buttons with longer labels are wider than the column

/// Buttons in a line.
int perLineOf(const std::vector<Mode> &modes)
{
    const bool isLong = std::ranges::any_of(modes, [](Mode mode) { return modeText(mode).size() > longLabel; });
    return isLong ? 2 : 3;
}

QString titled(const QString &text)
{
    return text.left(1).toUpper() + text.mid(1);
}

} // namespace

ModePanel::ModePanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
{
    auto *column = layoutIn<QVBoxLayout>(this, 8);
    m_buttons = new QWidget(this);
    m_buttons->setAccessibleName(tr("Mode"));
    auto *grid = layoutIn<QGridLayout>(m_buttons);
    grid->setHorizontalSpacing(0);
    grid->setVerticalSpacing(4);
    m_group = new QButtonGroup(this);
    m_slots = new SlotPanel(theme, this);
    column->addWidget(m_buttons);
    column->addWidget(m_slots);
    connect(m_group, &QButtonGroup::idClicked, this, [this](int id) {
        const Mode mode = m_modes.at(static_cast<std::size_t>(id));
        if (mode == m_mode)
            return;
        m_mode = mode;
        Q_EMIT modeChanged(mode);
    });
    connect(m_slots, &SlotPanel::editedChanged, this, &ModePanel::editedSlotChanged);
    connect(m_slots, &SlotPanel::runningChanged, this, &ModePanel::runningSlotChanged);
}

void ModePanel::setFamily(const Family &family)
{
    if (&family == m_family)
        return;
    m_family = &family;
    m_modes.clear();
    for (const Mode mode : shown) {
        if (std::ranges::find(family.modes, mode) != family.modes.end())
            m_modes.push_back(mode);
    }
    if (std::ranges::find(m_modes, m_mode) == m_modes.end())
        m_mode = m_modes.empty() ? Mode::Off : m_modes.front();
    rebuild();
}

void ModePanel::rebuild()
{
    const auto old = m_group->buttons();
    for (QAbstractButton *button : old)
        delete button;
    auto &grid = static_cast<QGridLayout &>(*m_buttons->layout());
    const int count = static_cast<int>(m_modes.size());
    const int perLine = perLineOf(m_modes);
    grid.setColumnStretch(2, 0);
    for (int i = 0; i < count; ++i) {
        auto *button = new QToolButton(m_buttons);
        button->setText(titled(modeText(m_modes[static_cast<std::size_t>(i)])));
        button->setAccessibleName(tr("%1 mode").arg(button->text()));
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        const int place = i % perLine;
        const bool last = place == perLine - 1 || i == count - 1;
        setStyleProperty(*button, "segment",
            place == 0 ? last ? QStringLiteral("only") : QStringLiteral("first")
                : last ? QStringLiteral("last")
                       : QStringLiteral("middle"));
        m_group->addButton(button, i);
        grid.addWidget(button, i / perLine, place);
        grid.setColumnStretch(place, 1);
    }
    m_slots->setCount(m_family->capabilities.gainSlots);
    show(m_mode, 0, 0);
}

int ModePanel::editedSlot() const
{
    return m_slots->edited();
}

int ModePanel::runningSlot() const
{
    return m_slots->running();
}

void ModePanel::show(Mode mode, int edited, int running)
{
    const auto found = std::ranges::find(m_modes, mode);
    if (found != m_modes.end()) {
        m_mode = mode;
        m_group->button(static_cast<int>(found - m_modes.begin()))->setChecked(true);
    }
    m_slots->show(edited, running);
}

void ModePanel::swapSlots()
{
    m_slots->swap();
}

void ModePanel::chainAfter(QWidget *before)
{
    for (QWidget *box : {m_buttons, static_cast<QWidget *>(m_slots)}) {
        const auto buttons = box->findChildren<QAbstractButton *>();
        for (QAbstractButton *button : buttons) {
            setTabOrder(before, button);
            before = button;
        }
    }
}

} // namespace mb
