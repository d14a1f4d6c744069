// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

class QComboBox;

namespace mb {

class CommandButton;

/// Limits that were kept under a name: one is chosen again from the list, the present ones are kept under the name that is
/// typed, one is forgotten. Knows names only.
class SavedLimits : public QWidget {
    Q_OBJECT
public:
    explicit SavedLimits(const ThemeSource &theme, QWidget *parent = nullptr);
    void setNames(const QStringList &names);

Q_SIGNALS:
    void chosen(const QString &name);
    void keepRequested(const QString &name);
    void forgetRequested(const QString &name);

private:
    void follow();

    QComboBox *m_names = nullptr;
    CommandButton *m_keep = nullptr;
    CommandButton *m_forget = nullptr;
};

} // namespace mb
