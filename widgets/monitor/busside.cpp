// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/busside.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/monitor/busloadview.h"
#include "widgets/monitor/framedetail.h"
#include "widgets/monitor/frametext.h"
#include "widgets/monitor/idmodel.h"

#include <QScrollBar>

namespace mb {

/// At large fonts it is higher than the room that is left: it scrolls.
BusSide::BusSide(const ThemeSource &theme, QWidget *parent)
    : QScrollArea(parent)
    , m_theme(theme)
{
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setFocusPolicy(Qt::NoFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *content = new QWidget(this);
    setStyleProperty(*content, "surface", QStringLiteral("window"));
    content->setAttribute(Qt::WA_StyledBackground);
    setWidget(content);
    build(*content);
    setMinimumWidth(content->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
}

void BusSide::build(QWidget &content)
{
    const Theme &theme = m_theme.theme();
    auto *column = layoutIn<QVBoxLayout>(&content, theme.u(4), {0, 0, 0, theme.u(8)});
    m_detail = new FrameDetail(m_theme, &content);
    m_load = new BusLoadView(m_theme, &content);
    m_caption = textLabel({}, TextRole::Caption, Tone::Dim, &content);
    m_facts = textLabel({}, TextRole::Caption, Tone::Dim, &content);
    m_facts->setWordWrap(true);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.u(12), 0, theme.u(12), 0);
    head->addWidget(new SectionLabel(tr("Bus load, %"), &content));
    head->addStretch();
    head->addWidget(m_caption);
    auto *foot = new QVBoxLayout;
    foot->setContentsMargins(theme.u(12), 0, theme.u(12), 0);
    foot->addWidget(m_load);
    foot->addWidget(m_facts);
    column->addWidget(m_detail, 1);
    column->addWidget(separatorLine(Qt::Horizontal, &content));
    column->addLayout(head);
    column->addLayout(foot);
}

void BusSide::showLoads(const std::string &link)
{
    m_load->setLoads(m_loads.of(link));
}

void BusSide::showFacts(const LinkView &link, const IdModel &ids)
{
    m_caption->setText(tr("last 60 s, peak %1 %").arg(formatNumber(m_load->peak() * 100.0, 0)));
    QStringList facts;
    if (link.kind == LinkKind::Can)
        facts += tr("%1 identifiers").arg(ids.rowCount());
    if (const TrafficRow *busiest = ids.busiest())
        facts += tr("busiest %1, %2 frames/s").arg(hexId(busiest->last), formatNumber(busiest->rate, 0));
    if (ids.unlisted() > 0)
        facts += tr("%1 frames of identifiers without a row").arg(formatCount(static_cast<qint64>(ids.unlisted())));
    if (link.unknown > 0)
        facts += tr("%1 frames that no decoder knows").arg(formatCount(static_cast<qint64>(link.unknown)));
    if (link.kind == LinkKind::Can)
        facts += tableText(toString(link.health.state));
    if (link.health.transmitErrors && link.health.receiveErrors)
        facts += tr("error counters TEC %1, REC %2").arg(*link.health.transmitErrors).arg(*link.health.receiveErrors);
    m_facts->setText(facts.join(QStringLiteral(" · ")));
}

} // namespace mb
