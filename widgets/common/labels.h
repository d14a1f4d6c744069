// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QLabel>
#include <QVariant>

class QFrame;
class QPushButton;

namespace mb {

/// Sets a property that the style sheet selects by (card, banner, role, tone, primary …) and restyles the widget.
void setStyleProperty(QWidget &widget, const char *name, const QVariant &value);
/// Colour of a label's text by meaning; follows the theme by itself.
void setTone(QWidget &widget, Tone tone);
/// Text size of a label: Body, Emphasis, Caption, Title, Value and Raw come from the sheet; Section has its own class.
void setTextRole(QWidget &widget, TextRole role);

/// A label that never needs the width of its text; the full text moves to the tooltip when it is cut.
QLabel *textLabel(const QString &text, TextRole role, Tone tone, QWidget *parent);
/// The small outlined word at the right of rows and card heads. Dim and Text give the neutral outline.
QLabel *badge(const QString &text, Tone tone, QWidget *parent);
/// A link-coloured button without a frame: "Dismiss", "Use", "Details".
QPushButton *linkButton(const QString &text, QWidget *parent);
/// A one pixel line between parts of a panel.
QFrame *separatorLine(Qt::Orientation orientation, QWidget *parent);

/// Head of a panel: capitals, tracked, dim. Give the text in sentence case; readers and copies keep it so.
class SectionLabel : public QLabel {
    Q_OBJECT
public:
    explicit SectionLabel(const QString &text, QWidget *parent = nullptr);

protected:
    void changeEvent(QEvent *event) override;

private:
    void applyTracking();
};

/// One line that ends in "…" where it does not fit and shows the whole text in its tooltip.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(const QString &text, QWidget *parent = nullptr);
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    bool event(QEvent *event) override;
};

} // namespace mb
