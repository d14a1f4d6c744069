// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/readstatus.h"

#include <vector>

class QMenu;
class QUndoStack;

namespace mb {

class CommandButton;
class IconButton;
class WrapLayout;

/// What the orders above the parameters are: words, symbols, or those that are used most as symbols and the others in a menu.
enum class HeadRoom : std::uint8_t { Words, Symbols, Menu };

/// Above the parameters: how well they are known, and what can be done with all of them.
class ParameterHead : public QWidget {
    Q_OBJECT
public:
    ParameterHead(const ThemeSource &theme, QWidget *parent);
    /// A device; `edits` are the steps of what is staged for it.
    void showDevice(const DeviceView &device, const OperationView *operation, const ParameterCounts &counts,
        const QUndoStack &edits);
    void showFile(const QString &name, const QString &family, const QUndoStack &edits);
    [[nodiscard]] bool isHistoryChosen() const;
    void chooseHistory(bool on);
    /// In a menu the status stands elsewhere.
    void setRoom(HeadRoom room);
    /// px that it takes in one line, with words.
    [[nodiscard]] int wordsWidth() const;

Q_SIGNALS:
    void undoRequested(bool again);
    void readRequested();
    void importRequested();
    void exportRequested();
    void snapshotRequested();
    void historyToggled(bool on);
    /// The menu opens; others may add to it.
    void menuFilled(QMenu *menu);

private:
    void build();
    void fillMenu();
    [[nodiscard]] std::vector<CommandButton *> inMenu() const { return {m_import, m_export, m_snapshot, m_history}; }
    void enable(const DeviceView *device, bool free, const QUndoStack &edits);

    const ThemeSource &m_theme;
    WrapLayout *m_row = nullptr;
    ReadStatus *m_status = nullptr;
    IconButton *m_undo = nullptr;
    IconButton *m_redo = nullptr;
    CommandButton *m_read = nullptr;
    CommandButton *m_import = nullptr;
    CommandButton *m_export = nullptr;
    CommandButton *m_snapshot = nullptr;
    CommandButton *m_history = nullptr;
    IconButton *m_more = nullptr;
    QMenu *m_menu = nullptr;
};

} // namespace mb
