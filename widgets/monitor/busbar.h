// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/monitor/framefilter.h"

#include <QStringList>
#include <QWidget>

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace mb {

class CommandButton;
class SearchField;
class Segmented;

/// What stands above the tables of the Bus page: which link, how full it is, pause, export, send; filter or search, direction.
class BusBar : public QWidget {
    Q_OBJECT
public:
    explicit BusBar(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Which there are, and which is looked at (−1: none); linkChosen() is what a person does.
    void setLinks(const QStringList &names, int current);
    /// Whether there is something to send on.
    void setSendable(bool sendable);
    /// Stands before the other buttons. For the page's own.
    void addButton(QWidget &button);
    void setState(const QString &richText);
    void setPaused(bool paused);
    /// What the filter leaves, "1 204 of 1 391 shown".
    void setResult(const QString &result);
    void setSendShown(bool shown);
    void setFilterText(const QString &text);
    void focusFilter();

Q_SIGNALS:
    void linkChosen(int place);
    /// Filter, search or direction. Only well-formed ones; a search that is not used is empty.
    void filterChanged(const mb::FrameFilter &filter, const mb::FrameFilter &search);
    void findRequested(bool forward);
    void pauseRequested();
    void clearRequested();
    void exportRequested(bool all);
    void sendToggled(bool shown);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void buildState(QVBoxLayout &column);
    void buildFilter(QVBoxLayout &column);
    void applyFilter();

    const ThemeSource &m_theme;
    Segmented *m_links = nullptr;
    QHBoxLayout *m_extra = nullptr;
    QLabel *m_state = nullptr;
    CommandButton *m_pause = nullptr;
    CommandButton *m_send = nullptr;
    SearchField *m_filter = nullptr;
    Segmented *m_mode = nullptr;
    Segmented *m_direction = nullptr;
    QLabel *m_problem = nullptr;
};

} // namespace mb
