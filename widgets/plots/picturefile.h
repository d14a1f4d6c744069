// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <QByteArray>
#include <QImage>
#include <QString>

#include <functional>

class QCPPainter;

namespace mb {

/// What a vector drawing is made of.
struct PaintedPicture {
    QSize size; ///< pixels of the screen, points of a page
    QString title;
    QString description;
    std::function<void(QCPPainter &)> paint;
};

// The bytes of a file, which saveFile() writes whole or not at all; empty when it cannot be made.

[[nodiscard]] QByteArray pngOf(const QImage &picture);
/// `kind`: svg or pdf.
[[nodiscard]] QByteArray drawingAs(const QString &kind, const PaintedPicture &drawing);

/// Writes what was drawn or listed; nothing drawn is a name that ends in no kind of file that is known here.
[[nodiscard]] Result<void> savePlot(const QString &path, const QByteArray &content);

} // namespace mb
