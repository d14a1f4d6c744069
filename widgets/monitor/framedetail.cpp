// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framedetail.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/monitor/framebits.h"
#include "widgets/monitor/frametext.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPainter>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace mb {
namespace {

constexpr std::array fieldColors{TraceRole::Duty, TraceRole::Position, TraceRole::Velocity, TraceRole::Error,
    TraceRole::Temperature, TraceRole::Current};

QColor fieldColor(const Theme &theme, const DecodedField &field, int place)
{
    return isFlag(field) ? theme.trace(TraceRole::Neutral)
                         : theme.trace(fieldColors.at(static_cast<std::size_t>(place) % fieldColors.size()));
}

QPixmap swatch(const Theme &theme, const QColor &color)
{
    QPixmap picture(theme.u(4), theme.u(15));
    picture.fill(color);
    return picture;
}

} // namespace

ByteStrip::ByteStrip(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&theme, &ThemeSource::changed, this, [this] { update(); });
}

QSize ByteStrip::sizeHint() const
{
    return {m_theme.theme().u(260), m_theme.theme().u(50)};
}

QSize ByteStrip::minimumSizeHint() const
{
    return {m_theme.theme().u(160), m_theme.theme().u(50)};
}

void ByteStrip::show(const std::vector<std::uint8_t> &bytes, const std::vector<QColor> &bitColors)
{
    m_bytes = bytes;
    m_colors = bitColors;
    setAccessibleName(tr("Bytes %1").arg(hexBytes(bytes)));
    update();
}

void ByteStrip::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    const int head = theme.u(16);
    const int bar = theme.u(3);
    const double step = std::min(static_cast<double>(width()) / 8.0, static_cast<double>(theme.u(44)));
    for (std::size_t i = 0; i < std::min<std::size_t>(m_bytes.size(), 8); ++i) {
        const double left = step * static_cast<double>(i);
        const QRectF box(left, head, step - theme.u(2), height() - head - bar);
        painter.setFont(theme.font(TextRole::Caption, font()));
        painter.setPen(theme.dim);
        painter.drawText(QRectF(left, 0, box.width(), head), Qt::AlignCenter, QString::number(i));
        painter.fillRect(box, theme.control);
        painter.setFont(theme.font(TextRole::Raw, font()));
        painter.setPen(theme.text);
        painter.drawText(box, Qt::AlignCenter, hexBytes(std::span(m_bytes).subspan(i, 1)));
        // The highest bit stands left, as it is read.
        const double bit = box.width() / 8.0;
        for (std::size_t n = 0; n < 8; ++n) {
            const QColor color = i * 8 + n < m_colors.size() ? m_colors[i * 8 + n] : QColor();
            if (color.isValid())
                painter.fillRect(QRectF(left + bit * static_cast<double>(7 - n), box.bottom(), bit, bar), color);
        }
    }
}

FrameDetail::FrameDetail(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Selected frame"));
    auto *column = new QVBoxLayout(this);
    const int pad = theme.theme().u(12);
    column->setContentsMargins(pad, theme.theme().u(8), pad, theme.theme().u(8));
    column->setSpacing(theme.theme().u(4));
    auto *head = new QHBoxLayout;
    m_time = textLabel({}, TextRole::Caption, Tone::Dim, this);
    head->addWidget(new SectionLabel(tr("Frame"), this));
    head->addStretch();
    head->addWidget(m_time);
    column->addLayout(head);
    m_message = textLabel({}, TextRole::Title, Tone::Text, this);
    m_id = textLabel({}, TextRole::Caption, Tone::Dim, this);
    m_bytes = new ByteStrip(theme, this);
    column->addWidget(m_message);
    column->addWidget(m_id);
    column->addWidget(m_bytes);
    buildFields(*column);
    setMinimumWidth(column->minimumSize().width()); // before parts of it hide
    clear();
}

void FrameDetail::buildFields(QVBoxLayout &column)
{
    m_fields = new QTableWidget(0, 3, this);
    m_fields->setAccessibleName(tr("Fields"));
    m_fields->horizontalHeader()->hide();
    m_fields->verticalHeader()->hide();
    m_fields->verticalHeader()->setDefaultSectionSize(m_theme.theme().u(24));
    m_fields->horizontalHeader()->setMinimumSectionSize(m_theme.theme().u(20));
    m_fields->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_fields->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_fields->horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_fields->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_fields->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_fields->setIconSize({m_theme.theme().u(4), m_theme.theme().u(15)});
    m_fields->setShowGrid(false);
    m_fields->setFrameShape(QFrame::NoFrame);
    m_fields->setMinimumHeight(m_theme.theme().u(48));
    column.addWidget(m_fields, 1);
    auto *row = new QHBoxLayout;
    m_copy = new CommandButton(m_theme, Symbol::Copy, tr("Copy"), this);
    m_copy->setToolTip(tr("Copy the selected frames as candump text (Ctrl+C)"));
    m_send = new CommandButton(m_theme, Symbol::FrameSend, tr("Send again…"), this);
    row->addWidget(m_copy, 1);
    row->addWidget(m_send, 1);
    column.addLayout(row);
    column.addStretch(0);
    connect(m_copy, &QPushButton::clicked, this, &FrameDetail::copyRequested);
    connect(m_send, &QPushButton::clicked, this, [this] { Q_EMIT sendRequested(m_record->frame); });
}

void FrameDetail::clear()
{
    m_record.reset();
    m_time->clear();
    m_message->setText(tr("No frame selected"));
    m_id->setText(tr("Select one to see its fields"));
    m_bytes->show({}, {});
    m_fields->setRowCount(0);
    setFilled(false);
}

/// Without a frame it is two lines.
void FrameDetail::setFilled(bool filled)
{
    for (QWidget *part : {static_cast<QWidget *>(m_bytes), static_cast<QWidget *>(m_fields),
             static_cast<QWidget *>(m_copy), static_cast<QWidget *>(m_send)})
        part->setVisible(filled);
}

void FrameDetail::show(const FrameRow &row, const FrameMeaning *meaning, const FrameDecoder &decoder, Instant origin)
{
    const TrafficRecord &record = row.record;
    const CanFrame &frame = record.frame;
    m_record = record;
    m_raw = record.isFrame() ? std::vector<std::uint8_t>(frame.bytes().begin(), frame.bytes().end()) : record.bytes;
    setFilled(true);
    m_send->setEnabled(record.isFrame() && !frame.error);
    m_time->setText(tr("%1 s").arg(std::chrono::duration<double>(frame.time - origin).count(), 0, 'f', 6));
    m_message->setText(frame.error ? tr("Error frame")
            : meaning              ? qt(meaning->frame.message)
            : record.isFrame()     ? tr("Unknown frame")
                                   : tr("%1 bytes").arg(record.length));
    const QString direction = record.direction == Direction::Sent ? tr("sent") : tr("received");
    m_id->setText(frame.error              ? errorFrameText(frame)
            : meaning && !record.isFrame() ? tr("%1 · %2").arg(qt(meaning->family->title), direction)
            : meaning                      ? tr("%1 · %2 #%3 · %4")
                            .arg(hexId(frame), qt(meaning->family->title), addressText(meaning->frame), direction)
            : record.isFrame() ? tr("%1 · %2").arg(hexId(frame), direction)
                               : direction);
    const auto bits = meaning && record.isFrame() ? fieldBits(frame, decoder) : std::vector<std::uint64_t>{};
    showFields(meaning, bits);
}

void FrameDetail::showFields(const FrameMeaning *meaning, const std::vector<std::uint64_t> &bits)
{
    const Theme &theme = m_theme.theme();
    const auto &fields = meaning ? meaning->frame.fields : std::vector<DecodedField>{};
    std::vector<QColor> colors(64);
    // Names matter more; the bits are in the tooltip too, and their colours under the bytes.
    m_fields->setColumnHidden(1, width() < theme.u(330));
    m_fields->setRowCount(static_cast<int>(fields.size()));
    int place = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const QColor color = fieldColor(theme, fields[i], place);
        place += isFlag(fields[i]) ? 0 : 1;
        for (std::size_t bit = 0; bit < 64; ++bit) {
            if (i < bits.size() && ((bits[i] >> bit) & 1U) != 0)
                colors[bit] = color;
        }
        const QString bit = i < bits.size() ? bitsText(bits[i]) : QString();
        const std::array texts{qt(fields[i].name), bit, fieldValue(fields[i])};
        for (int column = 0; column < 3; ++column) {
            auto *item = new QTableWidgetItem(texts.at(static_cast<std::size_t>(column)));
            item->setTextAlignment(static_cast<int>(Qt::AlignVCenter | (column == 0 ? Qt::AlignLeft : Qt::AlignRight)));
            item->setToolTip(tr("%1 = %2, bits %3").arg(qt(fields[i].name), wireValue(fields[i]), bit));
            if (column == 0)
                item->setIcon(QIcon(swatch(theme, color)));
            if (column == 1)
                item->setForeground(theme.dim);
            m_fields->setItem(static_cast<int>(i), column, item);
        }
    }
    m_bytes->show(m_raw, colors);
}

} // namespace mb
