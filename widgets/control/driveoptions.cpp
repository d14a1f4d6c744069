// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/driveoptions.h"

#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/wrappedlabel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>

#include <array>
#include <utility>

namespace mb {
namespace {

enum Brake { AsDevice, Braked, Coasting };

} // namespace

DriveOptions::DriveOptions(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(theme.theme().u(4));
    m_form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    addRamp();
    m_brake = new QComboBox(this);
    m_brake->addItems({tr("as the device is set"), tr("brake"), tr("coast")});
    m_brake->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_brake->setAccessibleName(tr("At zero output"));
    m_form->addRow(tallLabel(tr("At zero")), m_brake);
    m_reverseMotor
        = addFlag(tr("Reverse motor"), tr("Forward output turns the motor the other way. Changing it disarms."));
    m_reverseSensor = addFlag(tr("Reverse sensor"), tr("The encoder counts the other way. Changing it disarms."));
    m_override = addFlag(tr("Override limits"),
        tr("The two below replace the device's own settings for limit switches. Changing it disarms."));
    m_forwardOff = addFlag(tr("Forward limit off"), tr("The motor runs past the forward limit. Changing it disarms."));
    m_reverseOff = addFlag(tr("Reverse limit off"), tr("The motor runs past the reverse limit. Changing it disarms."));
    connect(m_brake, qOverload<int>(&QComboBox::activated), this, &DriveOptions::changed);
    show({});
}

/// As tall as the field beside it.
QLabel *DriveOptions::tallLabel(const QString &text)
{
    auto *label = new QLabel(text, this);
    label->setMinimumHeight(m_theme.theme().u(32));
    return label;
}

void DriveOptions::addRamp()
{
    m_rampRow = new QWidget(this);
    m_ramp = new NumberField(QStringLiteral("0"), m_rampRow);
    m_ramp->setFixedWidth(m_theme.theme().u(88));
    m_ramp->setAccessibleName(tr("Ramp of the output, duty per second"));
    m_ramp->setToolTip(tr("Greatest change of the output in duty per second: 2 takes 0.5 s from 0 to 100 %."));
    auto *row = layoutIn<QHBoxLayout>(m_rampRow, m_theme.theme().u(8));
    row->addWidget(m_ramp);
    m_noRamp = textLabel({}, TextRole::Caption, Tone::Dim, m_rampRow);
    row->addWidget(m_noRamp, 1);
    m_form->addRow(tallLabel(tr("Ramp")), m_rampRow);
    m_fault = wrappedLabel({}, TextRole::Caption, Tone::Danger, this);
    m_fault->hide();
    m_form->addRow(m_fault);
    connect(m_ramp, &QLineEdit::textEdited, this, &DriveOptions::checkRamp);
}

QCheckBox *DriveOptions::addFlag(const QString &text, const QString &help)
{
    auto *box = new QCheckBox(text, this);
    box->setAccessibleName(text);
    box->setToolTip(help);
    connect(box, &QCheckBox::toggled, this, [this] {
        m_forwardOff->setEnabled(m_override->isChecked());
        m_reverseOff->setEnabled(m_override->isChecked());
        Q_EMIT polarityChanged();
        Q_EMIT changed();
    });
    m_form->addRow(box);
    return box;
}

bool DriveOptions::offer(const OutputOptions &can, Mode mode)
{
    const std::array<std::pair<QWidget *, bool>, 7> rows{{{m_rampRow, can.ramps(mode)}, {m_brake, can.brake},
        {m_reverseMotor, can.directions}, {m_reverseSensor, can.directions}, {m_override, can.limits},
        {m_forwardOff, can.limits}, {m_reverseOff, can.limits}}};
    bool any = false;
    for (const auto &[row, isOffered] : rows) {
        row->setVisible(isOffered);
        if (QWidget *const label = m_form->labelForField(row))
            label->setVisible(isOffered);
        any = any || isOffered;
    }
    m_noRamp->setText(
        can.usualRamp > 0.0 ? tr("duty/s, 0 = %1").arg(formatNumber(can.usualRamp)) : tr("duty/s, 0 = none"));
    m_fault->setVisible(!fault().isEmpty());
    return any;
}

std::optional<double> DriveOptions::ramp() const
{
    const auto number = parseNumber(m_ramp->text());
    return number && *number >= 0.0 ? number : std::nullopt;
}

QString DriveOptions::fault() const
{
    return ramp() || m_rampRow->isHidden() ? QString()
                                           : tr("%1 is no ramp. Enter 0 or a positive number of duty per second.")
                                                 .arg(m_ramp->text().isEmpty() ? tr("Nothing") : m_ramp->text());
}

void DriveOptions::checkRamp()
{
    m_fault->setText(fault());
    m_fault->setVisible(!ramp());
    setStyleProperty(*m_ramp, "state", ramp() ? QString() : QStringLiteral("error"));
    Q_EMIT changed();
}

void DriveOptions::apply(SetPoint &setPoint) const
{
    setPoint.ramp = ramp().value_or(0.0);
    setPoint.brake.reset();
    if (m_brake->currentIndex() != AsDevice)
        setPoint.brake = m_brake->currentIndex() == Braked;
    setPoint.reverseMotor = m_reverseMotor->isChecked();
    setPoint.reverseSensor = m_reverseSensor->isChecked();
    setPoint.overrideLimits = m_override->isChecked();
    setPoint.disableForwardLimit = m_override->isChecked() && m_forwardOff->isChecked();
    setPoint.disableReverseLimit = m_override->isChecked() && m_reverseOff->isChecked();
}

QString DriveOptions::summary() const
{
    QStringList parts;
    if (!m_rampRow->isHidden() && ramp().value_or(0.0) > 0.0)
        parts << tr("ramp %1 duty/s").arg(editText(*ramp()));
    if (m_brake->currentIndex() != AsDevice)
        parts << m_brake->currentText();
    if (m_reverseMotor->isChecked())
        parts << tr("motor reversed");
    if (m_reverseSensor->isChecked())
        parts << tr("sensor reversed");
    if (m_override->isChecked())
        parts << tr("limits overridden");
    return parts.join(QStringLiteral(", "));
}

void DriveOptions::show(const SetPoint &setPoint)
{
    m_ramp->setText(editText(setPoint.ramp));
    m_brake->setCurrentIndex(!setPoint.brake ? AsDevice : *setPoint.brake ? Braked : Coasting);
    const auto tick = [](QCheckBox *box, bool on) {
        const QSignalBlocker quiet(box);
        box->setChecked(on);
    };
    tick(m_reverseMotor, setPoint.reverseMotor);
    tick(m_reverseSensor, setPoint.reverseSensor);
    tick(m_override, setPoint.overrideLimits);
    tick(m_forwardOff, setPoint.disableForwardLimit);
    tick(m_reverseOff, setPoint.disableReverseLimit);
    m_forwardOff->setEnabled(setPoint.overrideLimits);
    m_reverseOff->setEnabled(setPoint.overrideLimits);
    m_fault->hide();
    setStyleProperty(*m_ramp, "state", QString());
}

} // namespace mb
