// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QShortcut;

namespace mb {

/// Whether single letters belong to this widget rather than to the page: editors, trees, combo boxes, cells that are edited.
[[nodiscard]] bool takesLetters(const QWidget *widget);

/// The keys of a page or of the window: each row makes its shortcut and is what F1 lists, so that the list cannot say what the
/// page does not do. Single letters and digits act only while no editor, tree or combo box has the focus. GUI thread.
class PageKeys : public QObject {
    Q_OBJECT
public:
    struct Row {
        std::vector<QKeySequence> keys;     ///< any of them
        QString does;                       ///< a short phrase, translated: "flips A and B"
        std::vector<QShortcut *> shortcuts; ///< empty: the key is handled elsewhere, as those that stop
    };

    explicit PageKeys(QWidget &page);

    /// Acts on press, and again while it is held where Ctrl is part of it.
    void add(std::vector<QKeySequence> keys, const QString &does, std::function<void()> act);
    /// Of what is handled elsewhere; only said.
    void note(std::vector<QKeySequence> keys, const QString &does);
    [[nodiscard]] const std::vector<Row> &rows() const { return m_rows; }
    /// The keys of a row as they are written on a keyboard here: "Ctrl+Y, Ctrl+Shift+Z".
    [[nodiscard]] static QString textOf(const Row &row);

private:
    void followFocus(const QWidget *now);

    QWidget &m_page;
    std::vector<Row> m_rows;
};

/// What F1 opens: the keys of a page and those of the window.
void showKeys(QWidget &parent, const QString &page, const std::vector<const PageKeys *> &keys,
    const std::function<void()> &help = {});

} // namespace mb
