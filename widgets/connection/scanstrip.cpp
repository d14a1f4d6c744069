// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/scanstrip.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"

#include <QProgressBar>

#include <algorithm>

namespace mb {

ScanStrip::ScanStrip(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
{
    setObjectName(QStringLiteral("scanStrip"));
    const Theme &t = theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, t.u(4), {t.u(8), t.u(6), t.u(8), 0});
    m_step = new ElidedLabel({}, this);
    setTextRole(*m_step, TextRole::Caption);
    setTone(*m_step, Tone::Dim);
    m_step->setAccessibleName(tr("What the scan looks for"));
    m_progress = new QProgressBar(this);
    m_progress->setAccessibleName(tr("Progress of the scan"));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(t.u(6));
    m_cancel = new CommandButton(theme, Symbol::Close, tr("Cancel"), this);
    m_cancel->setObjectName(QStringLiteral("cancelScan"));
    m_cancel->setAccessibleName(tr("Cancel the scan"));
    m_cancel->setToolTip(tr("Ends the search; what it has found stays."));
    auto *row = new QHBoxLayout;
    row->setSpacing(t.u(8));
    row->addWidget(m_progress, 1);
    row->addWidget(m_cancel);
    column->addWidget(m_step);
    column->addLayout(row);
    hide();
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_workbench.send(orders::CancelScan{m_link}); });
    connect(&workbench, &Workbench::changed, this, &ScanStrip::follow);
}

void ScanStrip::follow()
{
    const auto &links = m_workbench.snapshot().links;
    const auto scan = std::ranges::find_if(links,
        [](const LinkView &link) { return link.kind == LinkKind::Serial && link.scanning && link.scanTotal > 0; });
    setVisible(scan != links.end());
    if (scan == links.end())
        return;
    m_link = scan->address;
    m_step->setText(tr("%1: %2").arg(QString::fromStdString(scan->name), messageText(scan->scanStep)));
    m_step->setToolTip(m_step->text());
    m_progress->setRange(0, scan->scanTotal);
    m_progress->setValue(scan->scanDone);
}

} // namespace mb
