// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace mb {

/// Theme, language, size of the text, motion, and where things are kept. What is chosen holds when the dialog is accepted.
class Preferences : public QDialog {
    Q_OBJECT
public:
    Preferences(const Look &look, QWidget *parent);

    [[nodiscard]] Look look() const;

private:
    void addFolders(QFormLayout &form);

    QComboBox *m_theme = nullptr;
    QComboBox *m_language = nullptr;
    QComboBox *m_size = nullptr;
    QCheckBox *m_motion = nullptr;
};

} // namespace mb
