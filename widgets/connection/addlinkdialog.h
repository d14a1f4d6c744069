// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/connection/linkchoices.h"

#include <QDialog>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace mb {

class LinkOptions;

/// Adds a link by choosing: what can be opened and why the rest cannot, with its options; the address line says the same in one
/// line, for those who know it. Opens nothing itself.
class AddLinkDialog : public QDialog {
    Q_OBJECT
public:
    AddLinkDialog(const std::vector<LinkChoice> &choices, const ThemeSource &theme, QWidget *parent = nullptr);

    /// What can be chosen by now. What is chosen, typed and set stays.
    void setChoices(const std::vector<LinkChoice> &choices);
    /// GPIO lines of this computer, for SPI boards.
    void setLines(const std::vector<std::pair<QString, QString>> &lines);

Q_SIGNALS:
    /// Open this; `keep`: at every start.
    void chosen(const QString &address, bool keep);
    void recordingWanted();
    void helpWanted();

private:
    void buildList();
    /// Yields what is offered first.
    QTreeWidgetItem *fillList();
    [[nodiscard]] QWidget *buildDetail(const ThemeSource &theme);
    void buildFoot(QVBoxLayout &column, const ThemeSource &theme);
    void choose();
    void describe();
    void compose();
    void check();
    void finish();
    [[nodiscard]] const LinkChoice *current() const;

    const ThemeSource &m_theme;
    std::vector<LinkChoice> m_choices;
    QTreeWidget *m_list = nullptr;
    QLabel *m_name = nullptr;
    QLabel *m_words = nullptr;
    QLabel *m_command = nullptr;
    LinkOptions *m_options = nullptr;
    QLineEdit *m_address = nullptr;
    QLabel *m_fault = nullptr;
    QCheckBox *m_keep = nullptr;
    QPushButton *m_open = nullptr;
};

} // namespace mb
