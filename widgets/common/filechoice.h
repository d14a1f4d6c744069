// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>

class QWidget;

namespace mb {

/// Gets the name of the file or folder that was accepted.
using FileChosen = std::function<void(const QString &path)>;

// These open a dialog above `parent`, with which it goes, and return at once; `chosen` is called later, or never. `start`: the folder that is
// shown first, the name that is proposed, or both. `filters`: as QFileDialog has them, "Table (*.csv);;All files (*)".

void askForFile(QWidget &parent, const QString &title, const QString &filters, const QString &start, FileChosen chosen);
void askForFolder(QWidget &parent, const QString &title, const QString &start, FileChosen chosen);
/// A name without an ending gets the first one of the filter that is chosen.
void askWhereToSave(
    QWidget &parent, const QString &title, const QString &filters, const QString &start, FileChosen chosen);

} // namespace mb
