// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/faultline.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/icons.h"
#include "widgets/common/labels.h"
#include "widgets/common/wraplayout.h"
#include "widgets/parameters/leap.h"

#include <QPainter>
#include <QPushButton>

namespace mb {

FaultLine::FaultLine(const ThemeSource &theme, ParameterModel &model, ParameterIndex index, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_model(model)
    , m_index(index)
{
    auto *row = new WrapLayout(this);
    const Theme &t = theme.theme();
    row->setSpacing(t.u(4));
    row->setContentsMargins(t.u(54), t.u(3), t.u(8), t.u(4));
    m_fault = new QLabel(this);
    setTextRole(*m_fault, TextRole::Emphasis);
    setTone(*m_fault, Tone::Danger);
    m_remedy = new QLabel(this);
    m_nearest = linkButton(QString(), this);
    m_revert = linkButton(QString(), this);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_fault, m_remedy, m_nearest, m_revert})
        row->addWidget(widget);
    connect(m_nearest, &QPushButton::clicked, this, &FaultLine::useNearest);
    connect(m_revert, &QPushButton::clicked, this, &FaultLine::revert);
    refresh();
}

void FaultLine::refresh()
{
    const StagedEdit *edit = m_model.edits()->find(m_index);
    if (!edit)
        return;
    const Parameter &row = m_model.parameter(m_index);
    const QString label = tableText(row.label);
    const auto known = m_model.edits()->known(m_index);
    const auto factor = m_model.edits()->unconfirmed(m_index);
    m_looking = factor.has_value();
    setTone(*m_fault, m_looking ? Tone::Caution : Tone::Danger);
    m_fault->setText(m_looking ? leapText(row, *known, *factor) : edit->value.fault);
    m_remedy->setText(m_looking ? tr("Is that meant?") : edit->value.remedy);
    const auto &nearest = edit->value.nearest;
    const bool offered = nearest && isSensibleFix(row, known, *nearest);
    m_nearest->setVisible(m_looking || offered);
    if (m_looking)
        m_nearest->setText(tr("Use %1").arg(edit->text));
    else if (offered)
        m_nearest->setText(tr("Use %1").arg(valueText(row, *nearest)));
    m_nearest->setAccessibleName(tr("%1: %2").arg(label, m_nearest->text()));
    m_revert->setText(known ? tr("Revert to %1").arg(valueText(row, *known)) : tr("Revert"));
    m_revert->setAccessibleName(tr("%1: %2").arg(label, m_revert->text()));
    layout()->invalidate();
    layout()->activate();
}

int FaultLine::heightForWidth(int width) const
{
    return layout()->heightForWidth(width);
}

void FaultLine::useNearest()
{
    if (m_looking) {
        Q_EMIT mended();
        m_model.edits()->confirm(m_index);
        return;
    }
    const StagedEdit *edit = m_model.edits()->find(m_index);
    if (!edit || !edit->value.nearest)
        return;
    const QString text = fieldText(m_model.parameter(m_index), *edit->value.nearest);
    Q_EMIT mended();
    m_model.edits()->stage(m_index, text);
}

void FaultLine::revert()
{
    Q_EMIT mended();
    m_model.edits()->revert(m_index);
}

void FaultLine::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    const QColor edge = m_looking ? theme.caution : theme.danger;
    painter.fillRect(rect(), m_looking ? theme.bannerCaution : theme.errorTint);
    painter.fillRect(0, 0, theme.u(3), height(), edge);
    painter.fillRect(0, height() - 1, width(), 1, edge);
    const double side = theme.u(14);
    paintSymbol(painter, QRectF(theme.u(34), theme.u(15) - side / 2, side, side), Symbol::Warning, edge);
}

} // namespace mb
