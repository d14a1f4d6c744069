// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/gainspanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/wrappedlabel.h"
#include "widgets/parameters/leap.h"

#include <QPushButton>

#include <algorithm>

namespace mb {

GainsPanel::GainsPanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const int gap = theme.theme().u(4);
    m_column = layoutIn<QVBoxLayout>(this, gap);
    auto *head = new QHBoxLayout;
    m_title = new SectionLabel(tr("Gains"), this);
    head->addWidget(m_title);
    auto *hint = new ElidedLabel(tr("G · ← → 2 % · Shift 0.2 %"), this);
    setTextRole(*hint, TextRole::Caption);
    setTone(*hint, Tone::Dim);
    hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    head->addWidget(hint, 1);
    m_column->addLayout(head);
    m_note = wrappedLabel({}, TextRole::Caption, Tone::Dim, this);
    m_column->addWidget(m_note);
    m_more = linkButton({}, this);
    connect(m_more, &QPushButton::clicked, this, [this] { showBounds(!m_boundsShown); });
    m_column->addWidget(m_more, 0, Qt::AlignLeft);
}

void GainsPanel::choose(const Family &family, StagedEdits &edits, Mode mode, int slot, int axis)
{
    if (&family == m_family && &edits == m_edits && mode == m_mode && slot == m_slot && axis == m_axis)
        return;
    if (m_edits)
        m_edits->endTyping(true);
    m_family = &family;
    m_edits = &edits;
    m_mode = mode;
    m_slot = slot;
    m_axis = axis;
    rebuild();
}

void GainsPanel::clear()
{
    m_family = nullptr;
    m_edits = nullptr;
    m_rows.clear();
    delete m_content;
    m_content = nullptr;
    m_bounds = nullptr;
}

void GainsPanel::rebuild()
{
    delete m_content;
    m_rows.clear();
    const int gap = m_theme.theme().u(2);
    m_content = new QWidget(this);
    auto *rows = layoutIn<QVBoxLayout>(m_content, gap);
    m_bounds = new QWidget(m_content);
    auto *boundRows = layoutIn<QVBoxLayout>(m_bounds, 0);
    const GainSet set = gainSet(*m_family, m_mode, m_slot, m_axis);
    for (const ParameterIndex index : set.gains) {
        m_rows.push_back(new GainRow(m_theme, GainRow::Kind::Gain, *m_edits, index, m_content));
        rows->addWidget(m_rows.back());
        rows->addWidget(separatorLine(Qt::Horizontal, m_content));
    }
    for (const ParameterIndex index : set.bounds) {
        m_rows.push_back(new GainRow(m_theme, GainRow::Kind::Bound, *m_edits, index, m_bounds));
        boundRows->addWidget(m_rows.back());
    }
    rows->addWidget(m_bounds);
    m_column->insertWidget(m_column->count() - 1, m_content);
    for (GainRow *row : m_rows)
        row->setUnit(gainUnit(*m_family, m_edits->parameter(row->index()), m_mode));
    m_title->setText(m_family->capabilities.gainSlots > 1 ? tr("Gains, slot %1").arg(m_slot)
            : m_axis > 0                                  ? tr("Gains, axis %1").arg(m_axis)
                                                          : tr("Gains"));
    showBounds(m_boundsShown);
    explain();
}

void GainsPanel::showBounds(bool shown)
{
    m_boundsShown = shown;
    if (m_bounds)
        m_bounds->setVisible(shown);
    const bool divided = m_family && m_family->loop && m_family->loop->divided;
    m_more->setText(shown ? tr("Hide limits of the loop")
            : divided     ? tr("Divisor")
            : m_axis > 0  ? tr("Limits of the axis")
                          : tr("Limits of the loop"));
    m_more->setVisible(m_family && !gainSet(*m_family, m_mode, m_slot, m_axis).bounds.empty());
}

void GainsPanel::explain()
{
    m_note->setText(isClosedLoop(m_mode) ? QString()
            : m_axis > 0
            ? tr("No loop runs in %1 mode: only the limits of the axis act.").arg(modeText(m_mode))
            : tr("No loop runs in %1 mode: these gains act in velocity, position and current.").arg(modeText(m_mode)));
    m_note->setVisible(!m_note->text().isEmpty());
}

void GainsPanel::refresh(const DeviceView &device, bool reading)
{
    if (!m_edits || m_edits->entries().size() != device.parameters->size())
        return;
    const GainRow *const divisor = m_family->loop && m_family->loop->divided ? row(Role::Divisor) : nullptr;
    const double divided = divisor ? divisor->number().value_or(0.0) : 1.0;
    for (GainRow *row : m_rows) {
        const auto number = row->number();
        const auto physical = number
            ? siGain(*m_family, m_edits->parameter(row->index()), m_mode, *number, m_units.countsPerRevolution, divided)
            : std::nullopt;
        const bool off = !number || *number == 0.0;
        row->setPhysical(physical && !off ? physical->text() : off && number ? tr("off") : QString());
        row->setReading(reading);
        row->refresh((*device.parameters)[row->index().value]);
    }
}

QStringList GainsPanel::stagedNames() const
{
    QStringList names;
    for (const GainRow *row : m_rows) {
        const StagedEdit *edit = m_edits ? m_edits->find(row->index()) : nullptr;
        if (edit && m_edits->isIncluded(row->index()))
            names << shortName(m_edits->parameter(row->index()));
    }
    return names;
}

std::vector<ParameterChange> GainsPanel::toWrite() const
{
    std::vector<ParameterChange> changes = m_edits ? m_edits->toWrite() : std::vector<ParameterChange>{};
    const auto elsewhere = [this](const ParameterChange &change) {
        return std::ranges::none_of(m_rows, [&](const GainRow *row) { return row->index() == change.index; });
    };
    changes.erase(std::remove_if(changes.begin(), changes.end(), elsewhere), changes.end());
    return changes;
}

bool GainsPanel::hasFault() const
{
    return std::ranges::any_of(m_rows, [this](const GainRow *row) {
        const StagedEdit *edit = m_edits ? m_edits->find(row->index()) : nullptr;
        return edit && !edit->value.raw;
    });
}

QString GainsPanel::unconfirmed() const
{
    for (const GainRow *row : m_rows) {
        const ParameterIndex index = row->index();
        if (const auto factor = m_edits ? m_edits->unconfirmed(index) : std::nullopt)
            return tr("%1: %2").arg(shortName(m_edits->parameter(index)),
                leapText(m_edits->parameter(index), *m_edits->known(index), *factor));
    }
    return {};
}

void GainsPanel::revertAll()
{
    for (const GainRow *row : m_rows) {
        if (m_edits && m_edits->find(row->index()))
            m_edits->revert(row->index());
    }
}

void GainsPanel::focusFirst()
{
    if (!m_rows.empty())
        m_rows.front()->focusField();
}

GainRow *GainsPanel::row(Role role) const
{
    const auto found = std::ranges::find_if(
        m_rows, [&](const GainRow *row) { return m_edits->parameter(row->index()).role == role; });
    return found == m_rows.end() ? nullptr : *found;
}

} // namespace mb
