// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QEvent>
#include <QKeySequence>
#include <QObject>
#include <QPointer>
#include <QString>

#include <functional>
#include <map>
#include <vector>

class QLabel;
class QShortcut;

namespace mb {

/// Whether single letters belong to this widget rather than to the page: editors, trees, combo boxes, cells that are edited.
[[nodiscard]] bool takesLetters(const QWidget *widget);

/// Keys that somebody has chosen, by what their row is called (PageKeys::idOf); none at all: it has no key.
using KeyChoices = std::map<QString, std::vector<QKeySequence>>;

/// The keys of a page or of the window: each row makes its shortcut and is what F1 lists, so that the list cannot say what the
/// page does not do. Single letters and digits act only while no editor, tree or combo box has the focus. GUI thread.
class PageKeys : public QObject {
    Q_OBJECT
public:
    struct Row {
        std::vector<QKeySequence> keys;         ///< any of them, as they are now
        QString does;                           ///< a short phrase, translated: "flips A and B"
        std::vector<QShortcut *> shortcuts;     ///< empty: the key is handled elsewhere, as those that stop
        std::vector<QKeySequence> factory = {}; ///< as they came
        QPointer<QAction> action = {};          ///< entry of a menu that has the key; nullptr: none

        /// Not those that stop, arm, or belong to what has the focus.
        [[nodiscard]] bool isChangeable() const { return !shortcuts.empty() || action; }
    };

    explicit PageKeys(QWidget &page);
    /// Those of a page or of the window; nullptr: it has none.
    [[nodiscard]] static PageKeys *of(const QWidget &page);

    /// Acts on press, once, however long it is held.
    void add(std::vector<QKeySequence> keys, const QString &does, std::function<void()> act);
    /// The key of an entry of a menu, which has one.
    void add(QAction &action, const QString &does);
    /// Of what is handled elsewhere; only said.
    void note(std::vector<QKeySequence> keys, const QString &does);
    [[nodiscard]] const std::vector<Row> &rows() const { return m_rows; }
    /// The keys of a row as they are written on a keyboard here: "Ctrl+Y, Ctrl+Shift+Z".
    [[nodiscard]] static QString textOf(const Row &row);
    /// What a row is called in settings, the same in every language: its page and its first key as it came, "TunePage/F5".
    [[nodiscard]] QString idOf(const Row &row) const;
    /// Rows that were chosen get these keys, all others those they came with; buttons say so at once.
    void use(const KeyChoices &choices);

private:
    void followFocus(const QWidget *now);

    QWidget &m_page;
    std::vector<Row> m_rows;
};

/// Sent to everything in a page whose keys are others now.
[[nodiscard]] QEvent::Type keysChanged();
/// What a button has to say of its key, which came as this: the same, or what was chosen for that row of its page or window.
[[nodiscard]] QString keyShown(const QWidget &button, const QString &factory);

/// Words in parts with " · " between them, which name keys as %1, %2 …, by what they came as: with the keys as they are now, and
/// without the parts whose key was taken away.
[[nodiscard]] QString wordsOfKeys(const QWidget &near, const QString &words, const QStringList &factory);
/// The label says these words, and says them again when the keys are others.
void nameKeys(QLabel &label, const QString &words, const QStringList &factory);

/// What F1 opens: the keys of a page and those of the window.
void showKeys(QWidget &parent, const QString &page, const std::vector<const PageKeys *> &keys,
    const std::function<void()> &help = {});

} // namespace mb
