// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/readstatus.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"

#include <QProgressBar>

#include <algorithm>

namespace mb {
namespace {

bool isReading(const OperationView *operation)
{
    return operation && operation->status.kind == OperationKind::ReadParameters;
}

} // namespace

bool isUnderWay(const OperationView *operation)
{
    return operation && operation->status.state == OperationStatus::State::Running;
}

ReadStatus::ReadStatus(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
{
    const Theme &t = theme.theme();
    auto *row = layoutIn<QHBoxLayout>(this, t.u(8));
    m_glyph = new StateGlyph(theme, GlyphState::Waiting, this);
    m_text = new QLabel(this);
    setTextRole(*m_text, TextRole::Caption);
    m_bar = new QProgressBar(this);
    m_bar->setTextVisible(false);
    m_bar->setFixedWidth(t.u(120));
    m_bar->setAccessibleName(tr("Reading"));
    m_bar->hide();
    row->addWidget(m_glyph);
    row->addWidget(m_text);
    row->addWidget(m_bar);
}

void ReadStatus::say(GlyphState glyph, const QString &text)
{
    m_glyph->setState(glyph);
    m_text->setText(text);
    updateGeometry();
}

void ReadStatus::showFile(const QString &name, const QString &family)
{
    m_bar->hide();
    say(GlyphState::Assumed, tr("%1, values for %2 from a file").arg(name, family));
}

bool ReadStatus::showReading(const OperationView *operation)
{
    const bool reading = isReading(operation) && isUnderWay(operation);
    m_bar->setVisible(reading);
    if (!reading)
        return false;
    const OperationStatus &status = operation->status;
    m_bar->setRange(0, std::max(1, status.total));
    m_bar->setValue(status.done);
    say(GlyphState::Busy, status.total > 0 ? tr("Reading %1 of %2").arg(status.done).arg(status.total) : tr("Reading"));
    return true;
}

void ReadStatus::showDevice(const DeviceView &device, const OperationView *operation, const ParameterCounts &counts)
{
    if (showReading(operation))
        return;
    GlyphState glyph = GlyphState::Done;
    const QString text = outcome(device, operation, counts, glyph);
    say(glyph, text);
}

QString ReadStatus::outcome(
    const DeviceView &device, const OperationView *operation, const ParameterCounts &counts, GlyphState &glyph) const
{
    const auto known = std::count_if(device.parameters->begin(), device.parameters->end(),
        [](const auto &entry) { return entry.raw && entry.state != ParameterState::Failed; });
    if (!device.liveness.heard) {
        glyph = GlyphState::Gone;
        return known > 0 ? tr("no answer, the values are old") : tr("no answer");
    }
    if (counts.unread > 0) {
        glyph = GlyphState::Warning;
        return tr("%1 of %2 are read, %3 gave no answer").arg(known).arg(counts.all).arg(counts.unread);
    }
    if (known == 0) {
        glyph = GlyphState::Waiting;
        return tr("not read yet");
    }
    if (known < counts.all) {
        glyph = GlyphState::Gone;
        return tr("%1 of %2 known").arg(known).arg(counts.all);
    }
    if (!isReading(operation) || operation->status.state != OperationStatus::State::Done)
        return tr("all %1 read").arg(counts.all);
    const double seconds
        = std::chrono::duration<double>(operation->status.endedAt - operation->status.startedAt).count();
    return tr("all %1 read in %2").arg(counts.all).arg(formatDuration(seconds));
}

} // namespace mb
