// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QSplitter>

#include <optional>
#include <vector>

namespace mb {

class FrameModel;
class IdModel;
class TrafficView;

/// Every frame in order above, every identifier below.
class BusTables : public QSplitter {
    Q_OBJECT
public:
    BusTables(const ThemeSource &theme, FrameModel &frames, IdModel &ids, QWidget *parent);

    /// Where something else has room beside the identifiers.
    [[nodiscard]] QSplitter &lower() { return *m_lower; }
    /// Bytes of a serial or SPI link have none.
    void setIdentifiersShown(bool shown);
    /// The newest frame.
    void toEnd();
    void goTo(int frame);
    /// The frame that the cursor is on, though it be there since another one was taken out.
    [[nodiscard]] std::optional<int> current() const;
    /// In their order.
    [[nodiscard]] std::vector<int> selected() const;

Q_SIGNALS:
    /// By somebody: not where the row of the cursor was taken out.
    void currentChanged();
    void copyRequested();
    /// Somebody scrolled: away from the newest frame, or to it.
    void scrolled(bool back);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void build();
    void chooseField(const QPoint &at);

    const ThemeSource &m_theme;
    FrameModel &m_model;
    IdModel &m_ids;
    bool m_isTrimmed = false; ///< the model, at this moment
    QSplitter *m_lower = nullptr;
    TrafficView *m_frames = nullptr;
    TrafficView *m_idTable = nullptr;
};

} // namespace mb
