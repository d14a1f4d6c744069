// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framedetail.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

namespace mb {

FrameDetail::FrameDetail(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Selected frame"));
    auto *column = new QVBoxLayout(this);
    const int pad = theme.theme().u(12);
    column->setContentsMargins(pad, pad, pad, pad);
    column->setSpacing(theme.theme().u(6));
    column->addWidget(new SectionLabel(tr("Frame"), this));
    m_message = textLabel(tr("Select a frame"), TextRole::Title, Tone::Text, this);
    m_id = textLabel({}, TextRole::Raw, Tone::Dim, this);
    m_bytes = textLabel({}, TextRole::Raw, Tone::Text, this);
    m_fields = new QTableWidget(0, 2, this);
    m_fields->setAccessibleName(tr("Fields"));
    m_fields->setHorizontalHeaderLabels({tr("field"), tr("value")});
    m_fields->verticalHeader()->hide();
    m_fields->verticalHeader()->setDefaultSectionSize(theme.theme().u(24));
    m_fields->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_fields->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_fields->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_fields->setShowGrid(false);
    auto *copy = new CommandButton(theme, Symbol::Copy, tr("Copy as candump text"), this);
    for (QWidget *widget :
        {static_cast<QWidget *>(m_message), static_cast<QWidget *>(m_id), static_cast<QWidget *>(m_bytes)})
        column->addWidget(widget);
    column->addWidget(m_fields, 1);
    column->addWidget(copy);
    connect(copy, &QPushButton::clicked, this,
        [this] { QApplication::clipboard()->setText(QString::fromStdString(toText(m_row.record.frame))); });
}

void FrameDetail::show(const FrameRow &row)
{
    m_row = row;
    m_message->setText(row.decoded ? qt(row.decoded->message) : tr("Unknown frame"));
    const QString direction = row.record.direction == Direction::Sent ? tr("sent") : tr("received");
    m_id->setText(row.decoded ? tr("%1 · %2 %3 · %4")
                                    .arg(hexId(row.record.frame), qt(row.family->title))
                                    .arg(row.decoded->address)
                                    .arg(direction)
                              : tr("%1 · %2").arg(hexId(row.record.frame), direction));
    m_bytes->setText(hexBytes(row.record.frame));
    const auto &fields = row.decoded ? row.decoded->fields : std::vector<DecodedField>{};
    m_fields->setRowCount(static_cast<int>(fields.size()));
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const QString unit = fields[i].unit.empty() ? QString() : QLatin1Char(' ') + qt(fields[i].unit);
        auto *value = new QTableWidgetItem(QString::fromStdString(numberText(fields[i].value)) + unit);
        value->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_fields->setItem(static_cast<int>(i), 0, new QTableWidgetItem(qt(fields[i].name)));
        m_fields->setItem(static_cast<int>(i), 1, value);
    }
}

} // namespace mb
