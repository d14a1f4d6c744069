// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/setpointpanel.h"

#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/driveoptions.h"
#include "widgets/control/setpointentry.h"
#include "widgets/control/wrappedlabel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>

namespace mb {
namespace {

constexpr int sliderSteps = 1000; ///< one side

} // namespace

SetPointPanel::SetPointPanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.theme().u(4));
    auto *head = new QHBoxLayout;
    head->addWidget(new SectionLabel(tr("Set-point"), this));
    m_now = textLabel({}, TextRole::Caption, Tone::Dim, this);
    m_now->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    head->addWidget(m_now, 1);
    column->addLayout(head);
    column->addWidget(buildTarget());
    m_fault = wrappedLabel({}, TextRole::Caption, Tone::Danger, this);
    m_fault->hide();
    column->addWidget(m_fault);
    column->addWidget(buildRange());
    buildProfile();
    column->addWidget(m_profileBox);
    buildOptions();
    column->addWidget(m_more, 0, Qt::AlignLeft);
    column->addWidget(m_options);
    column->addWidget(m_zero, 0, Qt::AlignLeft);
    setMode(Mode::Velocity);
}

QWidget *SetPointPanel::buildTarget()
{
    const Theme &theme = m_theme.theme();
    auto *box = new QWidget(this);
    auto *row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme.u(8));
    m_field = new NumberField(box);
    m_field->setFixedWidth(theme.u(104));
    m_field->setAccessibleName(tr("Set-point"));
    m_field->setToolTip(tr("Enter applies it while the motor runs; it never starts one."));
    m_unitLabel = textLabel({}, TextRole::Caption, Tone::Dim, box);
    m_unitLabel->setFixedWidth(theme.u(52));
    m_slider = new QSlider(Qt::Horizontal, box);
    m_slider->setRange(-sliderSteps, sliderSteps);
    m_slider->setPageStep(sliderSteps / 10);
    m_slider->setSingleStep(sliderSteps / 50);
    m_slider->setAccessibleName(tr("Set-point, slider"));
    row->addWidget(m_field);
    row->addWidget(m_unitLabel);
    row->addWidget(m_slider, 1);
    connect(m_field, &QLineEdit::textEdited, this, &SetPointPanel::textTyped);
    connect(m_field, &QLineEdit::returnPressed, this, [this] {
        if (target())
            Q_EMIT targetChosen();
    });
    connect(m_slider, &QSlider::valueChanged, this, &SetPointPanel::sliderMoved);
    return box;
}

QWidget *SetPointPanel::buildRange()
{
    const Theme &theme = m_theme.theme();
    m_rangeBox = new QWidget(this);
    auto *grid = new QGridLayout(m_rangeBox);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(theme.u(8));
    grid->setVerticalSpacing(theme.u(4));
    m_limit = new NumberField(m_rangeBox);
    m_limit->setFixedWidth(theme.u(104));
    m_limit->setAccessibleName(tr("Range of the set-point, either way"));
    m_limit->setToolTip(tr("A set-point beyond it is refused: the limit of the hand, not of the drive."));
    m_limitUnit = textLabel({}, TextRole::Caption, Tone::Dim, m_rangeBox);
    m_slew = new QComboBox(m_rangeBox);
    for (const double time : slewTimes)
        m_slew->addItem(
            time == 0.0 ? tr("at once, as a step") : tr("full range in %1").arg(formatDuration(time)), time);
    m_slew->setCurrentIndex(usualSlew);
    m_slew->setAccessibleName(tr("How fast the set-point moves"));
    m_slew->setToolTip(tr("This program moves the set-point no faster, whatever is typed."));
    m_slew->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    grid->addWidget(textLabel(tr("Range ±"), TextRole::Body, Tone::Dim, m_rangeBox), 0, 0);
    grid->addWidget(m_limit, 0, 1);
    grid->addWidget(m_limitUnit, 0, 2);
    m_moves = textLabel(tr("Moves"), TextRole::Body, Tone::Dim, m_rangeBox);
    grid->addWidget(m_moves, 1, 0);
    grid->addWidget(m_slew, 1, 1, 1, 2);
    grid->setColumnStretch(2, 1);
    connect(m_limit, &QLineEdit::textEdited, this, &SetPointPanel::limitTyped);
    connect(m_limit, &QLineEdit::editingFinished, this, &SetPointPanel::showRange);
    connect(m_slew, qOverload<int>(&QComboBox::activated), this, &SetPointPanel::changed);
    return m_rangeBox;
}

/// Of modes whose profile the device makes from what the command says.
void SetPointPanel::buildProfile()
{
    const Theme &theme = m_theme.theme();
    m_profileBox = new QWidget(this);
    auto *grid = new QGridLayout(m_profileBox);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(theme.u(8));
    grid->setVerticalSpacing(theme.u(4));
    const auto add = [&](int row, const QString &name, const QString &unit, const QString &help) {
        auto *field = new NumberField(m_profileBox);
        field->setFixedWidth(theme.u(104));
        field->setAccessibleName(help);
        field->setToolTip(help);
        grid->addWidget(textLabel(name, TextRole::Body, Tone::Dim, m_profileBox), row, 0);
        grid->addWidget(field, row, 1);
        grid->addWidget(textLabel(unit, TextRole::Caption, Tone::Dim, m_profileBox), row, 2);
        connect(field, &QLineEdit::textEdited, this, &SetPointPanel::textTyped);
        return field;
    };
    m_velocity = add(0, tr("Velocity"), tr("counts/s"), tr("Velocity of the profile"));
    m_acceleration = add(1, tr("Acceleration"), tr("counts/s²"), tr("Acceleration of the profile"));
    m_velocity->setText(editText(Entered().velocity));
    m_acceleration->setText(editText(Entered().acceleration));
    grid->setColumnStretch(2, 1);
    m_profileBox->hide();
}

void SetPointPanel::buildOptions()
{
    m_options = new DriveOptions(m_theme, this);
    m_options->hide();
    m_more = linkButton({}, this);
    m_more->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // the summary may be longer than a line
    const auto retitle = [this] {
        const QString summary = m_options->summary();
        const QString title = m_options->isHidden() ? tr("Ramp, brake, direction, limits") : tr("Hide drive options");
        m_more->setText(summary.isEmpty() ? title : title + QStringLiteral(": ") + summary);
        m_more->setToolTip(summary);
    };
    retitle();
    connect(m_more, &QPushButton::clicked, this, [this, retitle] {
        m_options->setVisible(m_options->isHidden());
        retitle();
    });
    connect(m_options, &DriveOptions::changed, this, retitle);
    connect(m_options, &DriveOptions::changed, this, &SetPointPanel::changed);
    connect(m_options, &DriveOptions::polarityChanged, this, &SetPointPanel::polarityChanged);
    m_zero = linkButton(tr("Stop and count from 0"), this);
    m_zero->setObjectName(QStringLiteral("zeroPosition"));
    m_zero->setToolTip(
        tr("Stops the motor, and makes where it stands position 0. It starts again with Run only: a motor "
           "that runs would jump."));
    m_zero->hide();
    connect(m_zero, &QPushButton::clicked, this, &SetPointPanel::zeroRequested);
}

} // namespace mb
