// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/profilefields.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"

#include <QLabel>

namespace mb {

ProfileFields::ProfileFields(const ThemeSource &source, QWidget *parent)
    : QWidget(parent)
{
    const Theme &theme = source.theme();
    m_grid = layoutIn<QGridLayout>(this);
    m_grid->setHorizontalSpacing(theme.u(8));
    m_grid->setVerticalSpacing(theme.u(4));
    m_velocity = field(theme, tr("Velocity"), tr("counts/s"), tr("Velocity of the profile"));
    m_acceleration = field(theme, tr("Acceleration"), tr("counts/s²"), tr("Acceleration of the profile"));
    m_grid->setColumnStretch(2, 1);
    show(SetPointEntries());
}

QLineEdit *ProfileFields::field(const Theme &theme, const QString &name, const QString &unit, const QString &help)
{
    const int row = m_grid->count() > 0 ? m_grid->rowCount() : 0;
    auto *field = new NumberField(this);
    field->setFixedWidth(theme.u(104));
    field->setAccessibleName(help);
    field->setToolTip(help);
    m_grid->addWidget(textLabel(name, TextRole::Body, Tone::Dim, this), row, 0);
    m_grid->addWidget(field, row, 1);
    m_grid->addWidget(textLabel(unit, TextRole::Caption, Tone::Dim, this), row, 2);
    connect(field, &QLineEdit::textEdited, this, &ProfileFields::changed);
    return field;
}

void ProfileFields::show(const SetPointEntries &entries)
{
    m_velocity->setText(editText(entries.velocity));
    m_acceleration->setText(editText(entries.acceleration));
}

void ProfileFields::read(SetPointEntries &entries) const
{
    entries.velocity = parseNumber(m_velocity->text()).value_or(0.0);
    entries.acceleration = parseNumber(m_acceleration->text()).value_or(0.0);
}

void ProfileFields::setMode(Mode mode)
{
    m_velocity->setEnabled(mode == Mode::RampPosition);
}

QString ProfileFields::fault(const Capabilities &can) const
{
    const auto velocity = parseNumber(m_velocity->text());
    const auto acceleration = parseNumber(m_acceleration->text());
    if (!velocity || *velocity <= 0.0 || *velocity > can.fastestProfile)
        return tr("The profile needs a velocity up to %1 counts/s.").arg(formatNumber(can.fastestProfile));
    if (!acceleration || *acceleration < 0.0 || *acceleration > can.steepestProfile)
        return tr("The profile needs an acceleration up to %1 counts/s²; 0 is none.")
            .arg(formatNumber(can.steepestProfile));
    return {};
}

} // namespace mb
