// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/monitor/framemodel.h"

#include <QWidget>

#include <optional>

class QLabel;
class QTableWidget;
class QVBoxLayout;

namespace mb {

class ByteStrip;
class CommandButton;

/// The frame that was selected last: what it is, its bytes, every field with its bits and its value.
class FrameDetail : public QWidget {
    Q_OBJECT
public:
    explicit FrameDetail(const ThemeSource &theme, QWidget *parent = nullptr);
    /// `meaning`: nullptr when nobody knows the frame.
    void show(const FrameRow &row, const FrameMeaning *meaning, const FrameDecoder &decoder, Instant origin);
    void clear();
    /// What is shown; nothing: no frame.
    [[nodiscard]] const std::optional<TrafficRecord> &record() const { return m_record; }

Q_SIGNALS:
    void copyRequested();
    /// The frame shall be put into the panel that sends.
    void sendRequested(const mb::CanFrame &frame);

private:
    void buildFields(QVBoxLayout &column);
    void showFields(const FrameMeaning *meaning, const std::vector<std::uint64_t> &bits);
    void setFilled(bool filled);

    const ThemeSource &m_theme;
    std::optional<TrafficRecord> m_record;
    std::vector<std::uint8_t> m_raw; ///< what is shown of it
    QLabel *m_time = nullptr;
    QLabel *m_message = nullptr;
    QLabel *m_id = nullptr;
    ByteStrip *m_bytes = nullptr;
    QTableWidget *m_fields = nullptr;
    CommandButton *m_copy = nullptr;
    CommandButton *m_send = nullptr;
};

/// The bytes of a frame as boxes with their numbers, each with the colours of the fields that it holds.
class ByteStrip : public QWidget {
    Q_OBJECT
public:
    explicit ByteStrip(const ThemeSource &theme, QWidget *parent = nullptr);
    /// One colour a bit, invalid for none.
    void show(const std::vector<std::uint8_t> &bytes, const std::vector<QColor> &bitColors);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const ThemeSource &m_theme;
    std::vector<std::uint8_t> m_bytes;
    std::vector<QColor> m_colors;
};

} // namespace mb
