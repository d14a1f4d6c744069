// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings.h"

#include "widgets/common/keybook.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace mb {

class KeysPanel;

/// Theme, language, size of the text, units, motion, sounds, the guardian, where things are kept, and the key of every command. What is
/// chosen holds when the dialog is accepted.
class Preferences : public QDialog {
    Q_OBJECT
public:
    Preferences(const Look &look, const KeyBook &keys, QWidget *parent);

    [[nodiscard]] Look look() const;
    [[nodiscard]] KeyChoices keys() const;

private:
    [[nodiscard]] QWidget *makeLook(const Look &look);
    void addFolders(QFormLayout &form);

    QComboBox *m_theme = nullptr;
    QComboBox *m_language = nullptr;
    QComboBox *m_size = nullptr;
    QComboBox *m_units = nullptr;
    QCheckBox *m_motion = nullptr;
    QCheckBox *m_sounds = nullptr;
    KeysPanel *m_keys = nullptr;
};

} // namespace mb
