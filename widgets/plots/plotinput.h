// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotstrips.h"
#include "widgets/plots/plotview.h"

class QDropEvent;
class QKeyEvent;
class QMouseEvent;
class QRubberBand;
class QWheelEvent;

namespace mb {

/// What hands do to a stack of plots: wheel, drag, box, keys, cursors, the handle of a trigger, drops. It sees the events
/// of the stack before that does. GUI thread.
class PlotInput : public QObject {
    Q_OBJECT
public:
    PlotInput(QWidget &stack, PlotFrame &plot, PlotStrips &strips, PlotView &view, const ThemeSource &theme);

    /// Things of this MIME type can be dropped on a strip: see dropped().
    void acceptDrops(const QString &mimeType);
    /// Follows the present, with value axes that follow the data.
    void backToLive();

Q_SIGNALS:
    void fitRequested();
    void cursorsToggled();
    /// A or B was moved.
    void cursorMoved();
    /// What was dropped, and on which strip; -1 below them.
    void dropped(const QByteArray &data, int strip);
    /// Somebody wants to write something at this time.
    void noteRequested(double key);
    void triggerLevelMoved(double level);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void wheel(QWheelEvent *event);
    void mousePress(QMouseEvent *event);
    void mouseMove(QMouseEvent *event);
    void mouseRelease(QMouseEvent *event);
    [[nodiscard]] bool key(QKeyEvent &event);
    [[nodiscard]] bool timeKey(int key);
    [[nodiscard]] bool valueKey(int key);
    [[nodiscard]] bool cursorKey(QKeyEvent &event);
    void drop(QDropEvent &event);
    void moveCursor(bool second, double key);
    void zoomValues(double factor);
    void pointAt(const QPoint &at);
    void beginBox(const QPoint &at);
    void endBox(const QPoint &at);
    [[nodiscard]] const PlotTrace *triggered() const;
    [[nodiscard]] bool overTrigger(const QPoint &at) const;
    void dragTrigger(const QPoint &at);

    QWidget &m_stack;
    PlotFrame &m_plot;
    PlotStrips &m_strips;
    PlotView &m_view;
    const ThemeSource &m_theme;
    QRubberBand *m_box = nullptr;
    QPoint m_boxStart;
    std::optional<QPoint> m_drag;
    std::optional<bool> m_draggedCursor; ///< true: B
    bool m_lastCursor = true;            ///< which one the arrow keys move
    bool m_draggedTrigger = false;
    QString m_dropType;
};

} // namespace mb
