// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/labels.h"

#include <QEvent>
#include <QFrame>
#include <QHelpEvent>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QToolTip>

namespace mb {
namespace {

QString toneWord(Tone tone)
{
    switch (tone) {
    case Tone::Text: return QStringLiteral("text");
    case Tone::Dim: return QStringLiteral("dim");
    case Tone::Faint: return QStringLiteral("faint");
    case Tone::Accent: return QStringLiteral("accent");
    case Tone::Ok: return QStringLiteral("ok");
    case Tone::Caution: return QStringLiteral("caution");
    case Tone::Danger: return QStringLiteral("danger");
    }
    return {};
}

QString roleWord(TextRole role)
{
    switch (role) {
    case TextRole::Body: return QStringLiteral("body");
    case TextRole::Emphasis: return QStringLiteral("emphasis");
    case TextRole::Caption: return QStringLiteral("caption");
    case TextRole::Section: return QStringLiteral("section");
    case TextRole::Title: return QStringLiteral("title");
    case TextRole::Large: return QStringLiteral("value");
    case TextRole::Stop: return QStringLiteral("stop");
    case TextRole::Verdict: return QStringLiteral("verdict");
    case TextRole::Raw: return QStringLiteral("raw");
    }
    return {};
}

} // namespace

void setStyleProperty(QWidget &widget, const char *name, const QVariant &value)
{
    if (widget.property(name) == value)
        return;
    widget.setProperty(name, value);
    widget.style()->unpolish(&widget);
    widget.style()->polish(&widget);
    widget.update();
}

void setTone(QWidget &widget, Tone tone)
{
    setStyleProperty(widget, "tone", toneWord(tone));
}

void setTextRole(QWidget &widget, TextRole role)
{
    setStyleProperty(widget, "role", roleWord(role));
}

QLabel *textLabel(const QString &text, TextRole role, Tone tone, QWidget *parent)
{
    auto *label = new ElidedLabel(text, parent);
    setTextRole(*label, role);
    setTone(*label, tone);
    return label;
}

QLabel *badge(const QString &text, Tone tone, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    const bool neutral = tone == Tone::Text || tone == Tone::Dim;
    label->setProperty("badge", neutral ? QStringLiteral("neutral") : toneWord(tone));
    label->setAlignment(Qt::AlignCenter);
    label->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    return label;
}

QPushButton *linkButton(const QString &text, QWidget *parent)
{
    auto *button = new QPushButton(text, parent);
    button->setProperty("link", true);
    button->setCursor(Qt::PointingHandCursor);
    button->setAccessibleName(text);
    button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    return button;
}

QFrame *separatorLine(Qt::Orientation orientation, QWidget *parent)
{
    auto *frame = new QFrame(parent);
    frame->setProperty("line", true);
    if (orientation == Qt::Horizontal)
        frame->setFixedHeight(1);
    else
        frame->setFixedWidth(1);
    return frame;
}

SectionLabel::SectionLabel(const QString &text, QWidget *parent)
    : QLabel(text, parent)
{
    setProperty("role", QStringLiteral("section"));
    applyTracking();
}

void SectionLabel::changeEvent(QEvent *event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange)
        applyTracking();
}

void SectionLabel::applyTracking()
{
    if (font().capitalization() == QFont::AllUppercase && qFuzzyCompare(font().letterSpacing(), 106.0))
        return;
    QFont tracked = font();
    tracked.setCapitalization(QFont::AllUppercase);
    tracked.setLetterSpacing(QFont::PercentageSpacing, 106);
    setFont(tracked);
}

ElidedLabel::ElidedLabel(const QString &text, QWidget *parent)
    : QLabel(text, parent)
{
    setTextFormat(Qt::PlainText);
}

QSize ElidedLabel::minimumSizeHint() const
{
    QSize hint = QLabel::minimumSizeHint();
    if (!wordWrap())
        hint.setWidth(std::min(hint.width(), fontMetrics().horizontalAdvance(QStringLiteral("mm…"))));
    return hint;
}

void ElidedLabel::paintEvent(QPaintEvent *event)
{
    if (wordWrap() || contentsRect().width() >= fontMetrics().horizontalAdvance(text())) {
        QLabel::paintEvent(event);
        return;
    }
    QPainter painter(this);
    const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
    style()->drawItemText(
        &painter, contentsRect(), static_cast<int>(alignment()), palette(), isEnabled(), shown, foregroundRole());
}

bool ElidedLabel::event(QEvent *event)
{
    const bool cut = !wordWrap() && contentsRect().width() < fontMetrics().horizontalAdvance(text());
    if (event->type() == QEvent::ToolTip && toolTip().isEmpty() && cut) {
        QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), text(), this);
        return true;
    }
    return QLabel::event(event);
}

} // namespace mb
