// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pageid.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

#include <functional>
#include <vector>

class QHBoxLayout;
class QStackedWidget;

namespace mb {

class Arming;
class DeviceLine;
class LiveStateBar;
class PageTabs;

/// The middle of the window: the tabs, what the selected device is and does above the pages that are about it, the pages, and below them
/// what goes back unless somebody keeps it. A page is made when it is asked for first, the others once the window was painted. GUI thread.
class PageStack : public QWidget {
    Q_OBJECT
public:
    PageStack(
        Workbench &workbench, Selection &selection, const Arming &arming, const ThemeSource &theme, QWidget *parent);

    /// In the order of PageId.
    void add(const QString &title, std::function<QWidget *(QWidget *)> make);
    void addBeforeTabs(QWidget &button);
    void addBesideTabs(QWidget &button);
    /// Below what is said of the device; takes it.
    void addAbovePages(QWidget &strip);

    [[nodiscard]] QWidget *page(PageId id);
    /// Where it is not available that is said instead.
    void showPage(PageId id);
    [[nodiscard]] PageId shown() const;
    [[nodiscard]] QWidget *shownPage() { return page(shown()); }
    [[nodiscard]] std::vector<PageId> all() const;
    [[nodiscard]] QString title(PageId id) const;
    /// It needs something first, and says what; empty: it is there.
    void setUnavailable(PageId id, const QString &reason);
    [[nodiscard]] bool isAvailable(PageId id) const;

Q_SIGNALS:
    void pageMade(mb::PageId id, QWidget *page);
    void shownChanged();

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makePages(int from);
    void followTab();
    void followLine();

    Workbench &m_workbench;
    const Arming &m_arming;
    const ThemeSource &m_theme;
    PageTabs *m_tabs = nullptr;
    QHBoxLayout *m_tabsRow = nullptr;
    DeviceLine *m_line = nullptr;
    LiveStateBar *m_states = nullptr;
    QStackedWidget *m_pages = nullptr;
    std::vector<std::function<QWidget *(QWidget *)>> m_makers; ///< by place in m_pages
};

} // namespace mb
