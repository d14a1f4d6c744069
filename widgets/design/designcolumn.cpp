// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designcolumn.h"

#include "widgets/common/labels.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/design/modelpanel.h"
#include "widgets/design/ownproposal.h"
#include "widgets/design/proposallist.h"

namespace mb {

DesignColumn::DesignColumn(const ThemeSource &theme, QWidget *parent)
    : ScrollColumn(theme.theme(), parent)
{
}

void DesignColumn::setParts(ModelPanel *model, ProposalList *proposals, EnvelopePanel *envelope)
{
    m_model = model;
    m_proposals = proposals;
    m_line = separatorLine(Qt::Horizontal, content());
    rows().addWidget(model);
    rows().addWidget(m_line);
    rows().addWidget(proposals);
    rows().addWidget(separatorLine(Qt::Horizontal, content()));
    rows().addWidget(envelope);
    rows().addStretch(1);
    connect(proposals, &ProposalList::aimChosen, this, &DesignColumn::scrollToChosen, Qt::QueuedConnection);
    connect(model, &ModelPanel::wanted, this, [this](bool all) {
        m_wantsAll = all;
        fit();
    });
}

void DesignColumn::resizeEvent(QResizeEvent *event)
{
    ScrollColumn::resizeEvent(event);
    fit();
}

void DesignColumn::fitSoon()
{
    QMetaObject::invokeMethod(this, &DesignColumn::fit, Qt::QueuedConnection);
}

void DesignColumn::fit()
{
    if (!m_model)
        return;
    m_line->setHidden(m_proposals->own().isHidden()); // one is enough where there is no set
    const bool all = m_wantsAll.value_or(false);
    arrange(m_wantsAll && !all, CardDensity::Comfortable);
    if (all)
        return;
    for (const CardDensity density : {CardDensity::Comfortable, CardDensity::Compact, CardDensity::Dense}) {
        if (isInSight())
            return;
        arrange(true, density);
    }
    if (!isInSight())
        QMetaObject::invokeMethod(this, &DesignColumn::scrollToChosen, Qt::QueuedConnection); // where it will stand
}

void DesignColumn::scrollToChosen()
{
    if (QWidget *const card = m_proposals->chosenCard())
        ensureWidgetVisible(card, 0, 0);
}

void DesignColumn::arrange(bool folded, CardDensity density)
{
    m_model->setFolded(folded);
    m_proposals->setDensity(density);
}

/// All down to the sliders.
bool DesignColumn::isInSight() const
{
    return ScrollColumn::isInSight({m_model, m_line, m_proposals});
}

} // namespace mb
