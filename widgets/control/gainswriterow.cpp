// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/gainswriterow.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"

namespace mb {

GainsWriteRow::GainsWriteRow(const ThemeSource &source, QWidget *parent)
    : QWidget(parent)
{
    const Theme &theme = source.theme();
    auto *row = layoutIn<QHBoxLayout>(this, theme.u(8), {theme.u(12), theme.u(8), theme.u(12), theme.u(8)});
    m_write = new CommandButton(source, tr("Write gains"), this);
    m_write->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_write->setObjectName(QStringLiteral("writeGains"));
    m_revert = new CommandButton(source, Symbol::Undo, tr("Revert"), this);
    m_revert->setAccessibleName(tr("Revert all staged gains"));
    row->addWidget(m_write, 1);
    row->addWidget(m_revert);
    connect(m_write, &QPushButton::clicked, this, &GainsWriteRow::writeRequested);
    connect(m_revert, &QPushButton::clicked, this, &GainsWriteRow::revertRequested);
}

void GainsWriteRow::show(const State &state)
{
    const QStringList &staged = state.staged;
    const QString names
        = staged.size() > 3 ? tr("%n value(s)", nullptr, staged.size()) : staged.join(QStringLiteral(", "));
    m_write->setText(staged.isEmpty() ? tr("Write gains")
            : state.slot              ? tr("Write %1 to slot %2").arg(names).arg(*state.slot)
                                      : tr("Write %1").arg(names));
    m_write->setEnabled(!staged.isEmpty() && state.free && !state.fault);
    m_write->setToolTip(state.fault ? tr("A gain is out of range")
            : staged.isEmpty()      ? tr("No gain is edited")
            : state.free            ? QString()
                                    : tr("The device is busy"));
    m_revert->setEnabled(!staged.isEmpty() || state.fault || state.leap);
}

bool GainsWriteRow::mayWrite() const
{
    return m_write->isEnabled();
}

} // namespace mb
