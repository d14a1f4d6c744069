// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/journalcard.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/stateglyph.h"
#include "widgets/common/workbench.h"
#include "widgets/service/stationdialog.h"

#include <QUrl>

namespace mb {

JournalCard::JournalCard(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
{
    auto *column = layoutIn<QVBoxLayout>(this);
    column->addWidget(new SectionLabel(tr("Journal"), this));
    auto *row = new QHBoxLayout;
    row->setSpacing(theme.theme().u(10));
    row->addWidget(m_glyph = new StateGlyph(theme, GlyphState::Done, this));
    auto *lines = new QVBoxLayout;
    lines->setSpacing(0);
    lines->addWidget(m_place = new ElidedLabel({}, this));
    setTextRole(*m_place, TextRole::Emphasis);
    m_place->setAccessibleName(tr("Journal"));
    lines->addWidget(m_state = new ElidedLabel({}, this));
    setTextRole(*m_state, TextRole::Caption);
    setTone(*m_state, Tone::Dim);
    row->addLayout(lines, 1);
    m_change = new CommandButton(theme, tr("Change…"), this);
    m_change->setAccessibleName(tr("Change the journal"));
    row->addWidget(m_change);
    column->addLayout(row);
    connect(m_change, &QPushButton::clicked, this, &JournalCard::ask);
    connect(&workbench, &Workbench::serviceChanged, this, &JournalCard::follow);
    follow();
}

void JournalCard::follow()
{
    const JournalState &journal = m_workbench.journal();
    const QUrl server(qt(journal.server));
    m_place->setText(
        journal.server.empty() ? tr("On this computer") : tr("PostgreSQL, %1").arg(server.host() + server.path()));
    QString state = tr("station %1").arg(qt(journal.station));
    if (const int ended = m_workbench.service().counts.ended();
        ended > 0 && journal.trouble.empty() && journal.waiting == 0)
        state += QStringLiteral(" · ") + tr("%n units of this run are in it", nullptr, ended);
    if (journal.waiting > 0)
        state += QStringLiteral(" · ") + tr("%n entries wait for the server", nullptr, journal.waiting);
    if (!journal.trouble.empty())
        state += QStringLiteral(": ") + messageText(journal.trouble);
    m_state->setText(state);
    m_glyph->setState(
        journal.trouble.empty() ? journal.waiting > 0 ? GlyphState::Busy : GlyphState::Done : GlyphState::Warning);
    m_change->setEnabled(!m_workbench.service().running);
}

QString JournalCard::text() const
{
    return m_place->text() + QLatin1Char('\n') + m_state->text();
}

void JournalCard::ask()
{
    auto *dialog = new StationDialog(m_workbench, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

} // namespace mb
