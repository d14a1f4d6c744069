// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/labels.h"

#include <QFrame>
#include <vector>

class QHBoxLayout;

namespace mb {

class CommandButton;

enum class BannerKind { Caution, Danger, Ok, Info, Ended };

/// A condition, in one line (two where the window is narrow for the size of the text): glyph, bold cause with its
/// number, dim remedy, at most two buttons, Dismiss. What has no room is in the tooltip.
class Banner : public QFrame {
    Q_OBJECT
public:
    Banner(const ThemeSource &theme, BannerKind kind, const QString &cause, const QString &remedy,
        QWidget *parent = nullptr);

    BannerKind kind() const { return m_kind; }
    QString cause() const { return m_cause->text(); }
    void setText(const QString &cause, const QString &remedy);
    /// A verb with an object; empty hides the button.
    void setAction(const QString &text);
    /// The other way out of it, where there are two.
    void setOther(const QString &text);
    /// The cause in a line of its own.
    void setTwoLines(bool on);
    /// Of any banner, whatever it says.
    static int heightOf(const Theme &theme, bool twoLines);

Q_SIGNALS:
    void actionTriggered();
    void otherTriggered();
    /// The owner hides or deletes the banner; it does nothing by itself.
    void dismissed();

protected:
    void paintEvent(QPaintEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void restyle();
    void place();

    const ThemeSource &m_theme;
    BannerKind m_kind;
    bool m_twoLines = false;
    QLabel *m_cause = nullptr;
    QLabel *m_remedy = nullptr;
    CommandButton *m_action = nullptr;
    CommandButton *m_other = nullptr;
    QPushButton *m_dismiss = nullptr;
};

/// The notices of the window, most severe and newest first, in a strip of one height, whether one stands in it or none: what
/// is below never moves. The first is shown, the others are counted: "3 more notices".
/// Each is known by a key, so that a condition that persists does not pile up. Dismissed keys stay silent until
/// cleared.
class BannerStack : public QWidget {
    Q_OBJECT
public:
    explicit BannerStack(const ThemeSource &theme, QWidget *parent = nullptr);

    void post(const QString &key, BannerKind kind, const QString &cause, const QString &remedy,
        const QString &action = {}, const QString &other = {});
    /// The condition has ended. `forget`: false where one that was dismissed is to stay silent should it come back.
    void clear(const QString &key, bool forget = true);
    /// All that stand, dismissed ones excluded.
    int count() const;
    void setTwoLines(bool on);

Q_SIGNALS:
    void actionTriggered(const QString &key);
    void otherTriggered(const QString &key);
    void countChanged(int count);
    /// "3 more notices" was clicked.
    void allRequested();

private:
    struct Entry {
        QString key;
        Banner *banner = nullptr;
        bool dismissed = false;
    };
    Entry *find(const QString &key);
    void arrange();

    bool m_twoLines = false;
    const ThemeSource &m_theme;
    std::vector<Entry> m_entries;
    QHBoxLayout *m_row = nullptr;
    QPushButton *m_more = nullptr;
};

} // namespace mb
