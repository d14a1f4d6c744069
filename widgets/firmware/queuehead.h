// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/turningrow.h"

class QLabel;

namespace mb {

class QueueRecipe;
class ThemeSource;

/// What a queue does to every unit, in one line, and where another recipe is chosen. GUI thread.
class QueueHead : public TurningRow {
    Q_OBJECT
public:
    QueueHead(const ThemeSource &theme, QWidget *parent);

    void show(const QueueRecipe &recipe);
    /// Off while units are served.
    void setChoosing(bool on);

Q_SIGNALS:
    void imageChosen(const QString &path);
    void recipeChosen(const QString &path);
    /// The recipe that is open, or a new one.
    void editWanted();

private:
    void askImage();
    void askRecipe();

    const ThemeSource &m_theme;
    QLabel *m_name = nullptr;
    QLabel *m_image = nullptr;
    QLabel *m_parameters = nullptr;
    QLabel *m_number = nullptr;
    QWidget *m_openImage = nullptr;
    QWidget *m_openRecipe = nullptr;
    QWidget *m_edit = nullptr;
};

} // namespace mb
