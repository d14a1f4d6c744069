// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pageid.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <functional>

class QDialog;

namespace mb {

class HelpWindow;

/// Opens the help where it is asked for: the `?` beside the tabs, F1 and `?` in dialogs. Knows which page of the help belongs
/// to what is shown. Lives as long as the window.
class HelpDesk : public QObject {
    Q_OBJECT
public:
    HelpDesk(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget &window);

    /// What the page of the window is about, for the selected device where it is about hardware.
    [[nodiscard]] QString topicOf(PageId page) const;
    /// Of a form by the name of its class; empty where it has none.
    [[nodiscard]] static QString topicOfForm(const QWidget &form);
    HelpWindow &open(const QString &topic);
    /// What the help shows now; empty: it is not open.
    [[nodiscard]] QString shown() const;
    /// The `?` of a page; `shown` says which one.
    [[nodiscard]] QWidget *makeButton(std::function<PageId()> shown, QWidget *parent);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] QString hardware() const;
    void equip(QDialog &form);

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    QWidget &m_window;
};

} // namespace mb
