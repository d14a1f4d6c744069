// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/labels.h"

#include <QFrame>
#include <vector>

class QVBoxLayout;

namespace mb {

enum class BannerKind { Caution, Danger, Ok, Info };

/// A condition above a page: glyph, bold cause with its number, dim remedy, at most one button, Dismiss.
class Banner : public QFrame {
    Q_OBJECT
public:
    Banner(const ThemeSource &theme, BannerKind kind, const QString &cause, const QString &remedy,
        QWidget *parent = nullptr);

    BannerKind kind() const { return m_kind; }
    QString cause() const;
    void setText(const QString &cause, const QString &remedy);
    /// A verb with an object; empty hides the button.
    void setAction(const QString &text);
    void setDismissable(bool dismissable);
    /// Two lines whatever the words: what has no room is in the tooltip.
    void setFlat(bool flat);

Q_SIGNALS:
    void actionTriggered();
    /// The owner hides or deletes the banner; it does nothing by itself.
    void dismissed();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void restyle();
    void fit();

    const ThemeSource &m_theme;
    BannerKind m_kind;
    bool m_flat = false;
    QLabel *m_cause = nullptr;
    QLabel *m_remedy = nullptr;
    QPushButton *m_action = nullptr;
    QPushButton *m_dismiss = nullptr;
};

/// The banners of a page, most severe and newest first: at most two are shown, then "3 more notices".
/// Each is known by a key, so that a condition that persists does not pile up. Dismissed keys stay silent until
/// cleared.
class BannerStack : public QWidget {
    Q_OBJECT
public:
    explicit BannerStack(const ThemeSource &theme, QWidget *parent = nullptr);

    void post(
        const QString &key, BannerKind kind, const QString &cause, const QString &remedy, const QString &action = {});
    /// A strip of one height, whether a notice stands in it or none: what is below never moves. One banner is shown, flat.
    void setReserved(bool on);
    /// The condition has ended.
    void clear(const QString &key);
    /// All that stand, dismissed ones excluded.
    int count() const;

Q_SIGNALS:
    void actionTriggered(const QString &key);
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
    void restyle();

    const ThemeSource &m_theme;
    bool m_reserved = false;
    std::vector<Entry> m_entries;
    QVBoxLayout *m_column = nullptr;
    QPushButton *m_more = nullptr;
};

} // namespace mb
