// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QKeySequence>

#include <functional>
#include <vector>

class QAction;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QMenu;

namespace mb {

class PageKeys;

/// Something that can be ordered by its name.
struct Command {
    QString name;  ///< as it is read: "Read all"
    QString place; ///< page or menu: "Parameters"
    QString key;   ///< as written on a keyboard here; empty: none
    std::function<void()> run;
};

/// The rows of a page's or the window's keys. `prepare` runs first: the page is shown.
void addCommands(
    std::vector<Command> &into, const QString &place, const PageKeys &keys, const std::function<void()> &prepare);
/// The enabled entries of a menu, and of the menus in it.
void addCommands(std::vector<Command> &into, const QString &place, const QMenu &menu);
/// The buttons of a page that can be pressed now and have a name; those that must be held are left out.
void addButtons(std::vector<Command> &into, const QString &place, const QWidget &page);

/// How well a command answers to what was typed: 0 not at all; more is better. Every word must begin a word of name or place;
/// a command whose name begins with the text comes first.
[[nodiscard]] int matchOf(const Command &command, const QString &typed);

/// Ctrl+K: everything that has a name, found by typing, run by Enter. GUI thread.
class CommandPalette : public QDialog {
    Q_OBJECT
public:
    CommandPalette(std::vector<Command> commands, QWidget *parent);

protected:
    /// Up and Down move through the list while the text keeps the focus.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void list(const QString &typed);
    void run(const QListWidgetItem *item);

    std::vector<Command> m_commands;
    QLineEdit *m_text = nullptr;
    QListWidget *m_list = nullptr;
};

} // namespace mb
