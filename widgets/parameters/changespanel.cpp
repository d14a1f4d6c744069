// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/changespanel.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/parameters/changerow.h"
#include "widgets/parameters/ramblock.h"
#include "widgets/parameters/readstatus.h"

#include <QProgressBar>
#include <QScrollArea>

#include <algorithm>

namespace mb {
namespace {

QWidget *surface(const char *name, QWidget *parent)
{
    auto *widget = new QWidget(parent);
    widget->setAttribute(Qt::WA_StyledBackground);
    widget->setProperty("surface", QLatin1String(name));
    return widget;
}

} // namespace

ChangesPanel::ChangesPanel(const ThemeSource &theme, Workbench &workbench, ParameterModel &model, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_workbench(workbench)
    , m_model(model)
{
    setObjectName(QStringLiteral("changesPanel"));
    setAttribute(Qt::WA_StyledBackground);
    setProperty("surface", QStringLiteral("window"));
    setAccessibleName(tr("Changes to write"));
    m_all = layoutIn<QVBoxLayout>(this, 0);
    m_head = buildHead();
    m_all->addWidget(m_head);
    m_all->addWidget(separatorLine(Qt::Horizontal, this));
    m_all->addWidget(buildBody(), 1);
    m_all->addWidget(separatorLine(Qt::Horizontal, this));
    m_foot = buildFoot();
    m_all->addWidget(m_foot);
}

QSize ChangesPanel::sizeHint() const
{
    return {std::max(minimumWidth(), minimumSizeHint().width()), QWidget::sizeHint().height()};
}

QWidget *ChangesPanel::buildHead()
{
    const Theme &t = m_theme.theme();
    auto *head = new QWidget(this);
    auto *row = layoutIn<QHBoxLayout>(head, -1, {t.u(12), t.u(8), t.u(12), t.u(8)});
    row->addWidget(new SectionLabel(tr("Changes to write"), head));
    row->addStretch();
    auto *order = textLabel(tr("order is chosen for you"), TextRole::Caption, Tone::Dim, head);
    order->setToolTip(tr(
        "Limits first, then what makes the loop calmer, then what makes it livelier: damping before P, P before I."));
    row->addWidget(order);
    head->setMinimumHeight(t.u(40));
    return head;
}

QWidget *ChangesPanel::buildBody()
{
    const Theme &t = m_theme.theme();
    auto *area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setAccessibleName(tr("Staged changes"));
    area->setFocusPolicy(Qt::NoFocus);
    area->setMinimumHeight(t.u(40));
    auto *list = surface("window", area);
    m_column = layoutIn<QVBoxLayout>(list, 0);
    m_empty = textLabel(
        tr("Nothing is staged. Edit a value in the table, or import a file."), TextRole::Caption, Tone::Dim, list);
    m_empty->setWordWrap(true);
    m_empty->setContentsMargins(t.u(12), t.u(12), t.u(12), t.u(12));
    m_ram = new RamBlock(
        m_theme, [this] { return m_workbench.now(); }, list);
    m_column->addWidget(m_empty);
    m_column->addWidget(m_ram);
    m_column->addStretch(1);
    area->setWidget(list);
    connect(m_ram, &RamBlock::storeRequested, this, &ChangesPanel::storeRequested);
    return area;
}

QWidget *ChangesPanel::buildFoot()
{
    const Theme &t = m_theme.theme();
    auto *foot = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(foot, t.u(8), {t.u(12), t.u(10), t.u(12), t.u(12)});
    m_note = textLabel({}, TextRole::Caption, Tone::Dim, foot);
    m_note->setWordWrap(true);
    m_step = textLabel({}, TextRole::Caption, Tone::Text, foot);
    m_progress = new QProgressBar(foot);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(t.u(8));
    m_discard = new CommandButton(m_theme, tr("Discard"), foot);
    m_write = new CommandButton(m_theme, tr("Write"), foot);
    m_write->setObjectName(QStringLiteral("writeButton"));
    m_write->setPrimary(true);
    buttons->addWidget(m_discard);
    buttons->addWidget(m_write, 1);
    column->addWidget(m_note);
    column->addWidget(m_step);
    column->addWidget(m_progress);
    column->addLayout(buttons);
    connect(m_discard, &QPushButton::clicked, this, &ChangesPanel::discardRequested);
    connect(m_write, &QPushButton::clicked, this, &ChangesPanel::writeRequested);
    return foot;
}

void ChangesPanel::refresh(const DeviceView *device, const OperationView *operation)
{
    fillRows();
    const bool busy = isUnderWay(operation);
    RamBlock::State ram;
    if (device) {
        ram.family = device->family;
        ram.parameters = device->parameters;
        ram.lastWrite = device->lastWrite;
        ram.mayStore = !busy && device->liveness.heard;
    }
    const bool holds = device && !inRam(*device->parameters).empty();
    m_ram->show(std::move(ram));
    fillFoot(device, operation);
    const bool staged = m_model.edits() && m_model.edits()->count() > 0;
    m_filled = staged || holds || busy;
    Q_EMIT filled(m_filled);
}

void ChangesPanel::fillRows()
{
    std::vector<std::pair<ParameterIndex, int>> wanted;
    if (const StagedEdits *edits = m_model.edits()) {
        int place = 0;
        for (const StagedChange &change : edits->ordered())
            wanted.emplace_back(change.index, edits->isIncluded(change.index) ? ++place : 0);
        for (const ParameterIndex index : edits->illegal())
            wanted.emplace_back(index, 0);
    }
    while (m_rows.size() < wanted.size()) {
        auto *row = new ChangeRow(m_theme, m_column->parentWidget());
        connect(row, &ChangeRow::activated, this, &ChangesPanel::parameterActivated);
        connect(row, &ChangeRow::includedChanged, this,
            [this](ParameterIndex index, bool included) { m_model.edits()->setIncluded(index, included); });
        m_column->insertWidget(static_cast<int>(m_rows.size()), row);
        m_rows.push_back(row);
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (i < wanted.size())
            m_rows[i]->show(m_model, wanted[i].first, wanted[i].second);
        else
            m_rows[i]->hide();
    }
    m_empty->setVisible(wanted.empty());
}

/// What will be known of what is written: of the staged values, of all that can be staged where none is.
QString ChangesPanel::proofNote(const DeviceView *device) const
{
    std::vector<const Parameter *> rows;
    if (const StagedEdits *edits = m_model.edits()) {
        for (const ParameterChange &change : edits->toWrite())
            rows.push_back(&edits->parameter(change.index));
    }
    if (rows.empty() && device) {
        for (const Parameter &row : device->family->parameters) {
            if (isEditable(row))
                rows.push_back(&row);
        }
    }
    const auto blind
        = std::ranges::count_if(rows, [](const Parameter *row) { return row->access == Access::WriteOnly; });
    if (blind == 0)
        return tr("Each value is written, read back and compared.");
    if (blind == static_cast<std::ptrdiff_t>(rows.size()))
        return tr("Each value is written. None can be read back: what stands here then is assumed.");
    return tr("Each value is written. %1 of %2 cannot be read back: they are assumed then; the others are compared.")
        .arg(blind)
        .arg(rows.size());
}

QString ChangesPanel::obstacle(const DeviceView *device, bool busy) const
{
    const StagedEdits *edits = m_model.edits();
    if (!edits || edits->count() == 0)
        return tr("nothing is staged");
    if (edits->faults() > 0)
        return edits->faults() == 1 ? tr("fix 1 value first") : tr("fix %1 values first").arg(edits->faults());
    if (edits->toWrite().empty()) {
        const auto changes = edits->ordered();
        const bool leaps = std::ranges::any_of(
            changes, [edits](const StagedChange &change) { return edits->unconfirmed(change.index).has_value(); });
        return leaps ? tr("look again first") : tr("none is ticked");
    }
    if (!device || !device->liveness.heard)
        return tr("no answer");
    if (device->identity->state == DeviceState::Duplicate)
        return tr("two units, one number");
    if (device->identity->state != DeviceState::Online)
        return glyphWord(glyphOf(*device));
    return busy || !device->busy.empty() ? tr("busy") : QString();
}

void ChangesPanel::fillFoot(const DeviceView *device, const OperationView *operation)
{
    const bool busy = isUnderWay(operation);
    m_step->setVisible(busy);
    m_progress->setVisible(busy && operation->status.total > 0);
    m_note->setVisible(!busy && !m_compact);
    if (busy) {
        const OperationStatus &status = operation->status;
        const QString step = messageText(status.step.empty() ? status.title : status.step);
        m_step->setText(status.total > 0 ? tr("%1, %2 of %3").arg(step).arg(status.done).arg(status.total) : step);
        m_progress->setRange(0, std::max(1, status.total));
        m_progress->setValue(status.done);
    }
    const auto seconds = device ? device->family->capabilities.storesAfter.count() : 0;
    QString note = proofNote(device);
    if (seconds > 0)
        note += QLatin1Char(' ')
            + tr("The drive stores by itself %1 s after the last change: keep power on.").arg(seconds);
    m_note->setText(note);

    const QString why = obstacle(device, busy);
    const int count = m_model.edits() ? static_cast<int>(m_model.edits()->toWrite().size()) : 0;
    m_write->setText(count > 0 ? tr("Write %1").arg(count) : tr("Write"));
    m_write->setEnabled(why.isEmpty());
    m_write->setKeyHint(why.isEmpty() ? QStringLiteral("Ctrl+Shift+W")
            : count > 0               ? QStringLiteral("· ") + why
                                      : QString());
    m_write->setToolTip(why.isEmpty() ? tr("Write the staged changes") : why);
    m_write->setAccessibleName(why.isEmpty() ? m_write->text() : m_write->text() + QStringLiteral(", ") + why);
    m_discard->setEnabled(m_model.edits() && m_model.edits()->count() > 0);
}

void ChangesPanel::setCompact(bool compact)
{
    m_compact = compact;
    m_head->setVisible(!compact);
    m_note->setVisible(!compact);
    m_all->setDirection(compact ? QBoxLayout::BottomToTop : QBoxLayout::TopToBottom);
    const Theme &t = m_theme.theme();
    m_foot->layout()->setContentsMargins(t.u(12), t.u(compact ? 4 : 10), t.u(12), t.u(compact ? 4 : 12));
}

bool ChangesPanel::mayWrite() const
{
    return m_write->isEnabled();
}

} // namespace mb
