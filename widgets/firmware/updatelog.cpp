// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/updatelog.h"

#include "files/filebytes.h"
#include "widgets/common/clocktext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/theme.h"

#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>

namespace mb {
UpdateLog::UpdateLog(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
{
    build();
}

void UpdateLog::build()
{
    const Theme &theme = m_theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.u(16), theme.u(6), theme.u(8), theme.u(6));
    head->addWidget(new SectionLabel(tr("Log"), this));
    head->addStretch();
    QPushButton *save = linkButton(tr("Save log…"), this);
    head->addWidget(save);
    column->addLayout(head);
    m_lines = new QTableWidget(0, 2, this);
    m_lines->setAccessibleName(tr("Log of the update"));
    m_lines->horizontalHeader()->hide();
    m_lines->verticalHeader()->hide();
    m_lines->verticalHeader()->setDefaultSectionSize(theme.u(22));
    m_lines->setColumnWidth(0, theme.u(120));
    m_lines->horizontalHeader()->setStretchLastSection(true);
    m_lines->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_lines->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_lines->setShowGrid(false);
    m_lines->setFrameShape(QFrame::NoFrame);
    column->addWidget(m_lines, 1);
    connect(save, &QPushButton::clicked, this, &UpdateLog::askSave);
}

void UpdateLog::clear()
{
    m_lines->setRowCount(0);
}

int UpdateLog::count() const
{
    return m_lines->rowCount();
}

void UpdateLog::add(const LogLine &line, const QString &who)
{
    const int row = m_lines->rowCount();
    m_lines->insertRow(row);
    auto *time = new QTableWidgetItem(timeOf(line.time));
    time->setForeground(m_theme.theme().dim);
    const QString said = messageText(line.text);
    auto *text = new QTableWidgetItem(
        glyphIcon(glyphOf(line.severity), m_theme.theme()), who.isEmpty() ? said : who + QStringLiteral("  ") + said);
    text->setToolTip(said);
    m_lines->setItem(row, 0, time);
    m_lines->setItem(row, 1, text);
    m_lines->scrollToBottom();
}

QString UpdateLog::timeOf(Instant time) const
{
    return clockText(momentOf(m_workbench, time), ClockPart::Milliseconds);
}

QString UpdateLog::text() const
{
    QString text;
    for (int row = 0; row < m_lines->rowCount(); ++row)
        text += m_lines->item(row, 0)->text() + QLatin1Char('\t') + m_lines->item(row, 1)->text() + QLatin1Char('\n');
    return text;
}

void UpdateLog::askSave()
{
    const auto save = [this, said = text()](const QString &path) {
        if (const auto saved = saveFile(path.toStdString(), said.toUtf8()); !saved)
            m_workbench.report(Severity::Danger, {}, errorText(saved.error()));
    };
    askWhereToSave(
        *this, tr("Save the log of the update"), tr("Text (*.log *.txt)"), QStringLiteral("update.log"), save);
}

} // namespace mb
