// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/changerow.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/parameters/leap.h"

#include <QCheckBox>
#include <QMouseEvent>
#include <QPainter>

namespace mb {

QString transitionText(const QString &from, const QString &to)
{
    return QStringLiteral("%1 → <b>%2</b>").arg(from.toHtmlEscaped(), to.toHtmlEscaped());
}

ChangeRow::ChangeRow(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const Theme &t = theme.theme();
    auto *grid = layoutIn<QGridLayout>(this, -1, {t.u(12), t.u(6), t.u(12), t.u(7)});
    grid->setHorizontalSpacing(t.u(2));
    grid->setVerticalSpacing(t.u(2));
    m_check = new QCheckBox(this);
    m_key = textLabel({}, TextRole::Raw, Tone::Text, this);
    m_values = new QLabel(this);
    m_values->setTextFormat(Qt::RichText);
    m_values->setWordWrap(true);
    setTone(*m_values, Tone::Dim);
    m_place = badge({}, Tone::Dim, this);
    m_fix = badge(tr("fix first"), Tone::Danger, this);
    grid->addWidget(m_check, 0, 0);
    grid->addWidget(m_key, 0, 1);
    m_look = badge(tr("look again"), Tone::Caution, this);
    grid->addWidget(m_place, 0, 2);
    grid->addWidget(m_look, 0, 2);
    grid->addWidget(m_fix, 0, 2);
    grid->addWidget(m_values, 1, 1, 1, 2);
    grid->setColumnStretch(1, 1);
    setCursor(Qt::PointingHandCursor);
    connect(m_check, &QCheckBox::clicked, this, [this](bool on) { Q_EMIT includedChanged(m_index, on); });
}

void ChangeRow::show(const ParameterModel &model, ParameterIndex index, int place)
{
    m_index = index;
    const StagedEdit *edit = model.edits()->find(index);
    if (!edit)
        return;
    const Parameter &row = model.parameter(index);
    const auto known = model.edits()->known(index);
    const bool legal = edit->value.raw.has_value();
    const bool included = model.edits()->isIncluded(index);
    const auto factor = model.edits()->unconfirmed(index);
    const QString from = known ? valueWithUnit(row, *known) : QString(UnknownMark);
    const QString to = legal   ? valueWithUnit(row, *edit->value.raw)
        : edit->text.isEmpty() ? QString(UnknownMark)
                               : edit->text;
    m_key->setText(qt(row.key));
    QFont bold = m_theme.theme().font(TextRole::Raw, font());
    bold.setBold(true);
    m_key->setFont(bold);
    m_values->setText(legal ? transitionText(from, to)
                            : QStringLiteral("%1 → <b style=\"color:%2\">%3</b>")
                                  .arg(from.toHtmlEscaped(), m_theme.theme().danger.name(), to.toHtmlEscaped()));
    m_check->setEnabled(legal);
    m_check->setChecked(included);
    m_check->setAccessibleName(tr("Write %1: %2 to %3").arg(qt(row.key), from, to));
    m_place->setText(included ? QString::number(place) : tr("later"));
    m_place->setToolTip(included ? tr("Written as number %1").arg(place) : tr("Stays staged"));
    m_place->setVisible(legal && !factor);
    m_look->setVisible(factor.has_value());
    m_look->setToolTip(factor ? leapText(row, *known, *factor) : QString());
    m_fix->setVisible(!legal);
    setToolTip(tableText(row.label));
    QWidget::show();
}

void ChangeRow::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && rect().contains(event->pos()))
        Q_EMIT activated(m_index);
}

void ChangeRow::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_theme.theme().panel);
    painter.fillRect(0, height() - 1, width(), 1, m_theme.theme().line);
}

} // namespace mb
