// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/setpointpanel.h"

#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/driveoptions.h"
#include "widgets/control/profilefields.h"
#include "widgets/control/setpointrange.h"
#include "widgets/control/wrappedlabel.h"

#include <QLineEdit>
#include <QPushButton>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr int sliderSteps = 1000; ///< one side

} // namespace

SetPointPanel::SetPointPanel(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this, theme.theme().u(4));
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
    m_range = new SetPointRange(theme, this);
    column->addWidget(m_range);
    m_profile = new ProfileFields(theme, this);
    m_profile->hide();
    column->addWidget(m_profile);
    buildOptions();
    column->addWidget(m_more, 0, Qt::AlignLeft);
    column->addWidget(m_options);
    column->addWidget(m_zero, 0, Qt::AlignLeft);
    connectFields();
    setMode(Mode::Velocity);
}

QWidget *SetPointPanel::buildTarget()
{
    const Theme &theme = m_theme.theme();
    auto *box = new QWidget(this);
    auto *row = layoutIn<QHBoxLayout>(box, theme.u(8));
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
    return box;
}

void SetPointPanel::connectFields()
{
    connect(m_field, &QLineEdit::textEdited, this, &SetPointPanel::textTyped);
    connect(m_field, &QLineEdit::returnPressed, this, [this] {
        if (target())
            Q_EMIT targetChosen();
    });
    connect(m_slider, &QSlider::valueChanged, this, &SetPointPanel::sliderMoved);
    connect(m_range, &SetPointRange::limitTyped, this, &SetPointPanel::limitTyped);
    connect(m_range, &SetPointRange::limitFinished, this, &SetPointPanel::showRange);
    connect(m_range, &SetPointRange::slewChosen, this, &SetPointPanel::changed);
    connect(m_profile, &ProfileFields::changed, this, &SetPointPanel::textTyped);
}

void SetPointPanel::buildOptions()
{
    m_options = new DriveOptions(m_theme, this);
    m_options->hide();
    m_more = linkButton({}, this);
    m_more->setObjectName(QStringLiteral("driveOptions"));
    m_more->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // the summary may be longer than a line
    showSummary();
    connect(m_more, &QPushButton::clicked, this, [this] {
        m_options->setVisible(m_options->isHidden());
        showSummary();
    });
    connect(m_options, &DriveOptions::changed, this, &SetPointPanel::showSummary);
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

/// What differs from the device's own settings is said while the options are folded, too.
void SetPointPanel::showSummary()
{
    const QString summary = m_options->summary();
    const QString title = m_options->isHidden() ? tr("Drive options") : tr("Hide drive options");
    m_more->setText(summary.isEmpty() ? title : title + QStringLiteral(": ") + summary);
    m_more->setToolTip(summary);
}

SetPointEntries SetPointPanel::entered() const
{
    SetPointEntries all = m_entries;
    m_options->apply(all.options);
    all.slew = m_range->slew();
    m_profile->read(all);
    return all;
}

void SetPointPanel::show(const Family &family, Mode mode, const SetPointEntries &entered)
{
    m_family = &family;
    m_mode = mode;
    m_zero->setVisible(family.capabilities.zeroPosition);
    m_present.reset();
    m_entries = entered;
    if (range().limit == 0.0)
        range().limit = usualLimit(m_family, m_mode);
    m_range->setSlew(entered.slew);
    m_profile->show(entered);
    m_options->show(entered.options);
    setUnits(m_units);
}

void SetPointPanel::showExtras()
{
    const bool options = m_family && m_options->offer(m_family->capabilities.output, m_mode);
    m_more->setVisible(options);
    if (!options)
        m_options->hide();
    showSummary();
    const bool profiled = isProfiled(m_family, m_mode);
    m_profile->setVisible(profiled);
    m_profile->setMode(m_mode);
    m_range->setSlewShown(!profiled); // the device makes the way there
}

void SetPointPanel::setMode(Mode mode)
{
    if (mode == m_mode)
        return;
    m_mode = mode;
    if (range().limit == 0.0)
        range().limit = usualLimit(m_family, mode);
    m_present.reset();
    if (startsAtPresent(mode))
        range().touched = false;
    setUnits(m_units);
}

void SetPointPanel::setUnits(const DisplayUnits &units)
{
    m_units = units;
    m_unit = shownUnit(m_mode, units);
    m_unitLabel->setText(m_mode == Mode::Follow ? tr("device") : m_unit.text);
    m_range->setUnit(m_unit.text);
    m_range->setMost(m_mode == Mode::Duty ? std::optional(100.0) : std::nullopt);
    m_slider->setVisible(m_mode != Mode::Follow);
    m_range->setVisible(m_mode != Mode::Follow);
    showExtras();
    showRange();
    showTarget(range().target);
    showPresent(m_present);
}

void SetPointPanel::forgetTargets()
{
    m_entries.forgetPositions();
    showTarget(range().target);
}

QString SetPointPanel::shown(double target) const
{
    constexpr double digits = 1e3; // of what is shown; what is meant stays exact
    return editText(std::round(target * m_unit.scale * digits) / digits);
}

std::optional<double> SetPointPanel::target() const
{
    if (!fault().isEmpty())
        return std::nullopt;
    if (const auto kept = m_entries.ranges.find(m_mode);
        kept != m_entries.ranges.end() && m_field->text() == shown(kept->second.target))
        return kept->second.target; // the field rounds
    const auto number = parseNumber(m_field->text(), limit() * m_unit.scale);
    return number ? std::optional(*number / m_unit.scale) : std::nullopt;
}

QString SetPointPanel::fault() const
{
    const QString text = m_field->text().trimmed();
    const auto number = parseNumber(text, limit() * m_unit.scale);
    const QString most = formatValue(limit() * m_unit.scale, m_unit.decimals > 0 ? 1 : 0, m_unit.text);
    if (!number)
        return text.isEmpty() ? tr("No set-point. Enter a number up to ± %1.").arg(most)
                              : tr("\"%1\" is no number. Enter one up to ± %2.").arg(text, most);
    if (m_mode == Mode::Follow) {
        const bool legal = *number == std::floor(*number) && *number >= 1.0 && *number <= usualLimit(m_family, m_mode);
        return legal ? QString() : tr("%1 is no device number. Enter the number of the device to follow.").arg(text);
    }
    constexpr double rounding = 0.0005; // the limit is shown with three decimals
    if (std::abs(*number) > limit() * m_unit.scale + rounding)
        return tr("%1 is beyond the range of ± %2. Enter less, or widen the range.").arg(text, most);
    const QString profile = isProfiled(m_family, m_mode) ? m_profile->fault(m_family->capabilities) : QString();
    return profile.isEmpty() ? m_options->fault() : profile;
}

void SetPointPanel::textTyped()
{
    range().touched = true;
    if (const auto number = target())
        range().target = *number;
    showSlider();
    showFault();
    Q_EMIT changed();
}

void SetPointPanel::limitTyped(double shown)
{
    range().limit = shown / m_unit.scale;
    showSlider();
    showFault();
    Q_EMIT changed();
}

void SetPointPanel::sliderMoved(int place)
{
    range().touched = true;
    range().target = limit() * place / m_slider->maximum();
    if (m_mode == Mode::Position || m_mode == Mode::Velocity)
        range().target = std::round(range().target);
    m_field->setText(shown(range().target));
    showFault();
    Q_EMIT changed();
    Q_EMIT targetChosen();
}

void SetPointPanel::showRange()
{
    m_range->showLimit(shown(limit()));
    showSlider();
}

void SetPointPanel::showSlider()
{
    const QSignalBlocker quiet(m_slider);
    const double part = std::clamp(range().target / limit(), -1.0, 1.0);
    m_slider->setValue(static_cast<int>(std::lround(part * m_slider->maximum())));
}

void SetPointPanel::showFault()
{
    const QString text = fault();
    m_fault->setText(text);
    m_fault->setVisible(!text.isEmpty());
    setStyleProperty(*m_field, "state", text.isEmpty() ? QString() : QStringLiteral("error"));
}

void SetPointPanel::showTarget(double target)
{
    range().target = target;
    m_field->setText(m_mode == Mode::Follow && target == 0.0 ? QString() : shown(target));
    showSlider();
    if (m_mode != Mode::Follow || target != 0.0)
        showFault();
}

void SetPointPanel::showPresent(std::optional<double> present)
{
    m_present = present;
    const int decimals = m_unit.scale == 1.0 && m_mode != Mode::Current && m_mode != Mode::Voltage ? 0 : 1;
    m_now->setText(m_mode == Mode::Follow
            ? QString()
            : tr("now %1").arg(
                present ? formatValue(*present * m_unit.scale, decimals, m_unit.text) : QString(UnknownMark)));
    if (!startsAtPresent(m_mode) || !present || range().touched)
        return;
    const double whole = std::round(*present);
    if (std::abs(whole) > limit()) { // somewhere else than expected: no reason to refuse it
        range().limit = std::abs(whole) + usualLimit(m_family, m_mode);
        showRange();
    }
    if (whole != range().target)
        showTarget(whole);
}

double SetPointPanel::slewRate() const
{
    return isProfiled(m_family, m_mode) ? 0.0 : entered().slewRate(m_family, m_mode);
}

void SetPointPanel::apply(SetPoint &setPoint) const
{
    setPoint.mode = m_mode;
    setPoint.target = target().value_or(0.0);
    m_options->apply(setPoint);
    if (!m_family || !m_family->capabilities.output.ramps(m_mode))
        setPoint.ramp = 0.0;
    if (isProfiled(m_family, m_mode)) {
        const SetPointEntries all = entered();
        setPoint.velocity = all.velocity;
        setPoint.acceleration = all.acceleration;
    }
}

} // namespace mb
