// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/slotpanel.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/segmented.h"
#include "widgets/common/stateglyph.h"
#include "widgets/control/wrappedlabel.h"

#include <QPushButton>

#include <utility>

namespace mb {
namespace {

Segmented *slotChoice(const QString &name, int count, QWidget *parent)
{
    auto *choice = new Segmented(name, parent);
    for (int slot = 0; slot < count; ++slot)
        choice->addSegment(QString::number(slot));
    return choice;
}

QHBoxLayout *plainRow(QWidget *box)
{
    auto *row = layoutIn<QHBoxLayout>(box, 8);
    return row;
}

} // namespace

SlotPanel::SlotPanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    m_column = layoutIn<QVBoxLayout>(this);
    hide();
}

void SlotPanel::setCount(int count)
{
    delete std::exchange(m_content, new QWidget(this));
    m_count = count;
    auto *column = layoutIn<QVBoxLayout>(m_content, 4);
    m_joinedRow = buildJoined();
    m_apartRow = buildApart();
    m_noteRow = buildNote();
    for (QWidget *row : {m_joinedRow, m_apartRow, m_noteRow})
        column->addWidget(row);
    m_column->addWidget(m_content);
    setVisible(count > 1);
    show(0, 0);
}

QWidget *SlotPanel::buildJoined()
{
    auto *box = new QWidget(m_content);
    QHBoxLayout *row = plainRow(box);
    m_both = slotChoice(tr("Gain slot, edit and run"), m_count, box);
    m_both->setToolTip(tr("The slot that is edited and that runs. Changing it disarms."));
    QPushButton *split = linkButton(tr("Split"), box);
    split->setAccessibleName(tr("Edit one slot while another runs"));
    split->setToolTip(split->accessibleName());
    row->addWidget(new QLabel(tr("Slot"), box));
    row->addWidget(m_both);
    row->addWidget(new ElidedLabel(tr("edit and run"), box), 1);
    row->addWidget(split);
    connect(m_both, &Segmented::currentChanged, this, [this](int slot) { choose(slot, slot); });
    connect(split, &QPushButton::clicked, this, [this] {
        m_split = true;
        refresh();
    });
    return box;
}

QWidget *SlotPanel::buildApart()
{
    auto *box = new QWidget(m_content);
    QHBoxLayout *row = plainRow(box);
    m_editedChoice = slotChoice(tr("Gain slot that is edited"), m_count, box);
    m_runningChoice = slotChoice(tr("Gain slot that runs"), m_count, box);
    m_runningChoice->setToolTip(tr("The slot of the next run. Changing it disarms."));
    row->addWidget(new QLabel(tr("Editing slot"), box));
    row->addWidget(m_editedChoice);
    row->addStretch(1);
    row->addWidget(new QLabel(tr("running"), box));
    row->addWidget(m_runningChoice);
    connect(m_editedChoice, &Segmented::currentChanged, this, [this](int slot) { choose(slot, m_running); });
    connect(m_runningChoice, &Segmented::currentChanged, this, [this](int slot) { choose(m_edited, slot); });
    return box;
}

QWidget *SlotPanel::buildNote()
{
    auto *box = new QWidget(m_content);
    QHBoxLayout *row = plainRow(box);
    m_note = wrappedLabel({}, TextRole::Caption, Tone::Caution, box);
    m_note->setObjectName(QStringLiteral("splitSlots"));
    QPushButton *join = linkButton(tr("Join"), box);
    join->setAccessibleName(tr("Edit the slot that runs"));
    join->setToolTip(join->accessibleName());
    row->addWidget(new StateGlyph(m_theme, GlyphState::Warning, box));
    row->addWidget(m_note, 1);
    row->addWidget(join);
    connect(join, &QPushButton::clicked, this, [this] {
        m_split = false;
        choose(m_running, m_running);
    });
    return box;
}

void SlotPanel::show(int edited, int running)
{
    m_edited = edited;
    m_running = running;
    m_split = edited != running;
    refresh();
}

void SlotPanel::swap()
{
    if (m_count < 2)
        return;
    if (m_edited != m_running)
        choose(m_running, m_edited);
    else
        choose((m_running + 1) % m_count, (m_running + 1) % m_count);
}

void SlotPanel::choose(int edited, int running)
{
    const bool otherEdited = std::exchange(m_edited, edited) != edited;
    const bool otherRunning = std::exchange(m_running, running) != running;
    refresh();
    if (otherRunning)
        Q_EMIT runningChanged(running);
    else if (otherEdited)
        Q_EMIT editedChanged(edited);
}

void SlotPanel::refresh()
{
    if (!m_content)
        return;
    const std::pair<Segmented *, int> shown[]{
        {m_both, m_running}, {m_editedChoice, m_edited}, {m_runningChoice, m_running}};
    for (const auto &[choice, slot] : shown) {
        const QSignalBlocker quiet(choice);
        choice->setCurrent(slot);
    }
    m_joinedRow->setVisible(!m_split);
    m_apartRow->setVisible(m_split);
    m_noteRow->setVisible(m_split);
    m_note->setText(m_edited == m_running
            ? tr("Split: both are slot %1 now.").arg(m_running)
            : tr("Split: edits go to slot %1, slot %2 runs.").arg(m_edited).arg(m_running));
}

} // namespace mb
