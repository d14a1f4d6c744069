// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/keybook.h"

#include <QLineEdit>

#include <optional>

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace mb {

/// A field that takes one press of a key, with Ctrl, Shift and Alt as they are held, and does not act on it. Tab and Enter pass, and
/// those that stop do so here too.
class KeyField : public QLineEdit {
    Q_OBJECT
public:
    explicit KeyField(QWidget *parent = nullptr);

Q_SIGNALS:
    void pressed(const QKeySequence &key);

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
};

/// Every command with its key, where it can be given another one. Nothing holds before the book is given back.
class KeysPanel : public QWidget {
    Q_OBJECT
public:
    explicit KeysPanel(KeyBook book, QWidget *parent = nullptr);
    [[nodiscard]] const KeyBook &book() const { return m_book; }

private:
    void build();
    void fill();
    void filter(const QString &text);
    void follow();
    void choose(const QKeySequence &key);
    void reset();
    void say(const QString &words, bool refused);
    [[nodiscard]] std::optional<std::size_t> row() const;

    KeyBook m_book;
    QTreeWidget *m_list = nullptr;
    KeyField *m_field = nullptr;
    QPushButton *m_factory = nullptr;
    QPushButton *m_none = nullptr;
    QLabel *m_answer = nullptr;
};

} // namespace mb
