// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTabBar>
#include <QWidget>

class QButtonGroup;
class QComboBox;
class QHBoxLayout;

namespace mb {

class ThemeSource;

/// A row of joined buttons of which one is on: "All 55 | Changed 14 | Errors 1". Arrow keys move along.
class Segmented : public QWidget {
    Q_OBJECT
public:
    explicit Segmented(const QString &accessibleName, QWidget *parent = nullptr);
    Segmented(const QString &accessibleName, const QStringList &texts, QWidget *parent = nullptr);

    int addSegment(const QString &text);
    /// Takes the last one away; the first is current when that was it.
    void removeLast();
    void setText(int index, const QString &text);
    void setSegmentEnabled(int index, bool enabled, const QString &reason = {});
    int count() const;
    int current() const;
    /// Emits currentChanged when it changes.
    void setCurrent(int index);
    /// All segments share the width evenly instead of following their texts.
    void setEven(bool even);
    /// The same choice as a list that opens, where there is no room for all of it.
    void setFolded(bool folded);
    bool isFolded() const { return m_list != nullptr; }
    /// Of the joined buttons, folded or not.
    int unfoldedWidth() const;
    /// The same without their air.
    int leastUnfoldedWidth() const;

Q_SIGNALS:
    void currentChanged(int index);

private:
    void updateEnds();
    void fillList();

    QButtonGroup *m_group = nullptr;
    QHBoxLayout *m_row = nullptr;
    QComboBox *m_list = nullptr; ///< while it is folded
    bool m_even = false;
};

/// The tabs of the pages: bold with a 2 px underline where we are, faint with a reason where a page cannot be used yet.
class PageTabs : public QTabBar {
    Q_OBJECT
public:
    explicit PageTabs(const ThemeSource &theme, QWidget *parent = nullptr);
    /// A page that needs something first stays visible, faint, and says what it needs; whoever was on it is on the first. Empty enables it.
    void setUnavailable(int index, const QString &reason);
    /// What is said of a page that can be used.
    void setHint(int index, const QString &hint);

protected:
    QSize tabSizeHint(int index) const override;
    QSize minimumTabSizeHint(int index) const override { return tabSizeHint(index); }
    void paintEvent(QPaintEvent *event) override;

private:
    QFont bold() const;
    int air() const;

    const ThemeSource &m_theme;
};

} // namespace mb
