// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/service/stationdialog.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/labels.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/workbench.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QVBoxLayout>

namespace mb {
namespace {

constexpr int letters = 44; ///< that an address may need

} // namespace

StationDialog::StationDialog(Workbench &workbench, QWidget *parent)
    : QDialog(parent)
    , m_workbench(workbench)
    , m_server(new QLineEdit(qt(workbench.journal().server), this))
    , m_station(new QLineEdit(qt(workbench.journal().station), this))
    , m_mistake(textLabel({}, TextRole::Body, Tone::Danger, this))
{
    setObjectName(QStringLiteral("station"));
    setWindowTitle(tr("Journal of this station"));
    auto *column = new QVBoxLayout(this);
    auto *form = new QFormLayout;
    m_station->setAccessibleName(tr("Name of this station"));
    m_server->setAccessibleName(tr("Server that stations share"));
    m_server->setPlaceholderText(QStringLiteral("postgresql://USER@HOST/DB"));
    m_server->setMinimumWidth(fontMetrics().averageCharWidth() * letters);
    form->addRow(tr("Name of this station"), m_station);
    form->addRow(tr("Server that stations share"), m_server);
    column->addLayout(form);
    auto *about
        = textLabel(tr("Without a server the journal is in the file of this computer alone. With one, every entry is "
                       "there first and delivered as soon as the server answers; numbers come in blocks of five."),
            TextRole::Caption, Tone::Dim, this);
    about->setWordWrap(true);
    column->addWidget(about);
    m_mistake->setWordWrap(true);
    m_mistake->hide();
    column->addWidget(m_mistake);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &StationDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
}

QString StationDialog::mistake() const
{
    return m_mistake->text();
}

void StationDialog::accept()
{
    m_workbench.send(
        orders::KeepJournal{m_server->text().trimmed().toStdString(), m_station->text().trimmed().toStdString()},
        guarded(this, [this](const Result<void> &kept) {
            if (kept)
                return QDialog::accept();
            m_mistake->setText(errorText(kept.error()));
            m_mistake->show();
        }));
}

} // namespace mb
