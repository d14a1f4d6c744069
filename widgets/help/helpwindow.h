// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QDialog>

class QListWidget;

namespace mb {

class HelpBrowser;

/// The documentation in a window of its own: pages at the left, the page at the right. Stays while one works.
class HelpWindow : public QDialog {
    Q_OBJECT
public:
    HelpWindow(const ThemeSource &theme, QWidget *parent);

    void showTopic(const QString &topic);
    [[nodiscard]] QString topic() const;

    /// The one of this window, opened or raised.
    static HelpWindow &open(const ThemeSource &theme, QWidget &parent, const QString &topic);

protected:
    void changeEvent(QEvent *event) override;

private:
    void connectList();
    void fillList();
    void name();
    void mark(const QString &topic);

    const ThemeSource &m_theme;
    QListWidget *m_list = nullptr;
    HelpBrowser *m_browser = nullptr;
};

} // namespace mb
