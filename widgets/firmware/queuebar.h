// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/turningrow.h"
#include "widgets/firmware/queuelines.h"

class QLabel;
class QProgressBar;

namespace mb {

class CommandButton;

/// How far a queue is, and what can be ordered of the whole. GUI thread.
class QueueBar : public TurningRow {
    Q_OBJECT
public:
    QueueBar(const ThemeSource &theme, QWidget *parent);

    /// `hindrance`: why it cannot be started, empty when it can.
    void follow(const ServiceView &view, const QueueTotals &totals, const QString &hindrance);
    /// "Updating 4 of 7", as it stands there.
    [[nodiscard]] QString headline() const;
    /// Of the buttons, by what they order.
    [[nodiscard]] CommandButton &start() const { return *m_start; }
    [[nodiscard]] CommandButton &pause() const { return *m_pause; }
    [[nodiscard]] CommandButton &cancel() const { return *m_cancel; }
    [[nodiscard]] CommandButton &retry() const { return *m_retry; }

Q_SIGNALS:
    void startWanted();
    void pauseWanted(bool on);
    void cancelWanted();
    void retryWanted();
    void exportWanted();

private:
    void buildProgress();
    void buildOrders();

    const ThemeSource &m_theme;
    QLabel *m_headline = nullptr;
    QLabel *m_left = nullptr;
    QProgressBar *m_share = nullptr;
    QLabel *m_counts = nullptr;
    CommandButton *m_start = nullptr;
    CommandButton *m_pause = nullptr;
    CommandButton *m_cancel = nullptr;
    CommandButton *m_retry = nullptr;
    CommandButton *m_export = nullptr;
    bool m_pausing = false;
};

} // namespace mb
