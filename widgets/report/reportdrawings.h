// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTextObjectInterface>

#include <memory>
#include <vector>

class QSvgRenderer;

namespace mb {

/// Inline drawings of an HTML text for QTextDocument, which knows images only: takes each out of the text, and paints it where its
/// image is laid out, as lines and not as pixels. Registered as the handler of QTextFormat::ImageObject; outlives the document.
class ReportDrawings : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)
public:
    /// `scale`: of their own size, where there is room.
    explicit ReportDrawings(QObject *parent = nullptr, double scale = 1.0);
    ~ReportDrawings() override;

    /// The text with an image where each `<svg>` was.
    [[nodiscard]] QString takeFrom(QString html);

    QSizeF intrinsicSize(QTextDocument *document, int position, const QTextFormat &format) override;
    void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *document, int position,
        const QTextFormat &format) override;

private:
    [[nodiscard]] QSvgRenderer *find(const QTextFormat &format) const;

    double m_scale;
    std::vector<std::unique_ptr<QSvgRenderer>> m_drawings;
};

} // namespace mb
