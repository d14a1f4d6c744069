// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/setpointrange.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/setpointentries.h"

#include <QComboBox>
#include <QLabel>

namespace mb {

SetPointRange::SetPointRange(const ThemeSource &source, QWidget *parent)
    : QWidget(parent)
    , m_limit(new NumberField(this))
    , m_unit(textLabel({}, TextRole::Caption, Tone::Dim, this))
    , m_slew(new QComboBox(this))
{
    const Theme &theme = source.theme();
    auto *grid = layoutIn<QGridLayout>(this);
    grid->setHorizontalSpacing(theme.u(8));
    grid->setVerticalSpacing(theme.u(4));
    grid->setColumnStretch(2, 1);
    grid->addWidget(textLabel(tr("Range ±"), TextRole::Body, Tone::Dim, this), 0, 0);
    grid->addWidget(m_limit, 0, 1);
    grid->addWidget(m_unit, 0, 2);
    m_moves = textLabel(tr("Moves"), TextRole::Body, Tone::Dim, this);
    grid->addWidget(m_moves, 1, 0);
    grid->addWidget(m_slew, 1, 1, 1, 2);
    m_limit->setFixedWidth(theme.u(104));
    m_limit->setAccessibleName(tr("Range of the set-point, either way"));
    m_limit->setToolTip(tr("A set-point beyond it is refused: the limit of the hand, not of the drive."));
    fillSlew();
    connect(m_limit, &QLineEdit::textEdited, this, &SetPointRange::read);
    connect(m_limit, &QLineEdit::editingFinished, this, &SetPointRange::limitFinished);
    connect(m_slew, qOverload<int>(&QComboBox::activated), this, &SetPointRange::slewChosen);
}

void SetPointRange::fillSlew()
{
    for (const double time : slewTimes)
        m_slew->addItem(
            time == 0.0 ? tr("at once, as a step") : tr("full range in %1").arg(formatDuration(time)), time);
    m_slew->setCurrentIndex(usualSlew);
    m_slew->setAccessibleName(tr("How fast the set-point moves"));
    m_slew->setToolTip(tr("This program moves the set-point no faster, whatever is typed."));
    m_slew->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
}

void SetPointRange::read(const QString &text)
{
    const auto number = parseNumber(text);
    const bool legal = number && *number > 0.0 && (!m_most || *number <= *m_most);
    setStyleProperty(*m_limit, "state", legal ? QString() : QStringLiteral("error"));
    if (legal)
        Q_EMIT limitTyped(*number);
}

void SetPointRange::showLimit(const QString &number)
{
    m_limit->setText(number);
    setStyleProperty(*m_limit, "state", QString());
}

void SetPointRange::setUnit(const QString &unit)
{
    m_unit->setText(unit);
}

int SetPointRange::slew() const
{
    return m_slew->currentIndex();
}

void SetPointRange::setSlew(int place)
{
    m_slew->setCurrentIndex(place < 0 ? usualSlew : place);
}

void SetPointRange::setSlewShown(bool shown)
{
    m_moves->setVisible(shown);
    m_slew->setVisible(shown);
}

} // namespace mb
