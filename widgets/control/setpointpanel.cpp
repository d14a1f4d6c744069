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

bool SetPointPanel::startsAtPresent(Mode mode)
{
    return mode == Mode::Position || mode == Mode::RampPosition;
}

SetPointPanel::Entered SetPointPanel::entered() const
{
    Entered all{m_ranges, m_slew->currentIndex(), {}, {}};
    all.velocity = parseNumber(m_velocity->text()).value_or(0.0);
    all.acceleration = parseNumber(m_acceleration->text()).value_or(0.0);
    return all;
}

void SetPointPanel::restore(const Entered &entered)
{
    m_present.reset();
    m_ranges = entered.ranges;
    if (range().limit == 0.0)
        range().limit = usualLimit(m_mode);
    m_slew->setCurrentIndex(entered.slew < 0 ? usualSlew : entered.slew);
    m_velocity->setText(editText(entered.velocity));
    m_acceleration->setText(editText(entered.acceleration));
    setUnits(m_units);
}

double SetPointPanel::slewRate(const Entered &entered, Mode mode) const
{
    const auto found = entered.ranges.find(mode);
    const double limit
        = found == entered.ranges.end() || found->second.limit <= 0.0 ? usualLimit(mode) : found->second.limit;
    const int place = entered.slew < 0 ? usualSlew : entered.slew;
    const double time = slewTimes.at(static_cast<std::size_t>(place));
    return time > 0.0 && mode != Mode::Follow ? 2.0 * limit / time : 0.0;
}

double SetPointPanel::usualLimit(Mode mode) const
{
    return mode == Mode::Follow ? m_can.lastFollowed : usualRange(m_modeRanges, mode);
}

void SetPointPanel::setFamily(const Family &family)
{
    m_can = family.capabilities;
    m_modeRanges = family.ranges;
    showExtras();
}

bool SetPointPanel::isProfiled() const
{
    return m_can.commandsProfile && (m_mode == Mode::RampPosition || m_mode == Mode::RampVelocity);
}

void SetPointPanel::showExtras()
{
    m_more->setVisible(m_can.outputOptions);
    if (!m_can.outputOptions)
        m_options->hide();
    m_profileBox->setVisible(isProfiled());
    m_velocity->setEnabled(m_mode == Mode::RampPosition); // the other goes to its target velocity
    m_moves->setVisible(!isProfiled());
    m_slew->setVisible(!isProfiled()); // the device makes the way there
}

QString SetPointPanel::profileFault() const
{
    if (!isProfiled())
        return {};
    const auto velocity = parseNumber(m_velocity->text());
    const auto acceleration = parseNumber(m_acceleration->text());
    if (!velocity || *velocity <= 0.0 || *velocity > m_can.fastestProfile)
        return tr("The profile needs a velocity up to %1 counts/s.").arg(formatNumber(m_can.fastestProfile));
    if (!acceleration || *acceleration < 0.0 || *acceleration > m_can.steepestProfile)
        return tr("The profile needs an acceleration up to %1 counts/s²; 0 is none.")
            .arg(formatNumber(m_can.steepestProfile));
    return {};
}

void SetPointPanel::setMode(Mode mode)
{
    if (mode == m_mode)
        return;
    m_mode = mode;
    if (range().limit == 0.0)
        range().limit = usualLimit(mode);
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
    m_limitUnit->setText(m_unit.text);
    m_slider->setVisible(m_mode != Mode::Follow);
    m_rangeBox->setVisible(m_mode != Mode::Follow);
    showExtras();
    showRange();
    showTarget(range().target);
    showPresent(m_present);
}

void SetPointPanel::reset(const Capabilities &can)
{
    m_more->setVisible(can.outputOptions);
    if (!can.outputOptions && !m_options->isHidden())
        m_more->click();
    m_zero->setVisible(can.zeroPosition);
    m_ranges.clear();
    m_present.reset();
    m_options->reset();
    const Mode mode = m_mode;
    m_mode = Mode::Off;
    setMode(mode);
}

void SetPointPanel::forgetTargets()
{
    for (auto &[mode, range] : m_ranges) {
        if (mode == Mode::Position || mode == Mode::RampPosition)
            range = {0.0, range.limit, false};
    }
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
    if (const auto kept = m_ranges.find(m_mode);
        kept != m_ranges.end() && m_field->text() == shown(kept->second.target))
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
        const bool legal = *number == std::floor(*number) && *number >= 1.0 && *number <= m_can.lastFollowed;
        return legal ? QString() : tr("%1 is no device number. Enter the number of the device to follow.").arg(text);
    }
    constexpr double rounding = 0.0005; // the limit is shown with three decimals
    if (std::abs(*number) > limit() * m_unit.scale + rounding)
        return tr("%1 is beyond the range of ± %2. Enter less, or widen the range.").arg(text, most);
    const QString profile = profileFault();
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

void SetPointPanel::limitTyped()
{
    const auto number = parseNumber(m_limit->text());
    const bool legal = number && *number > 0.0 && (m_mode != Mode::Duty || *number <= 100.0);
    setStyleProperty(*m_limit, "state", legal ? QString() : QStringLiteral("error"));
    if (!legal)
        return;
    range().limit = *number / m_unit.scale;
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
    m_limit->setText(shown(limit()));
    setStyleProperty(*m_limit, "state", QString());
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
        range().limit = std::abs(whole) + usualLimit(m_mode);
        showRange();
    }
    if (whole != range().target)
        showTarget(whole);
}

double SetPointPanel::limit() const
{
    const auto found = m_ranges.find(m_mode);
    return found == m_ranges.end() || found->second.limit <= 0.0 ? usualLimit(m_mode) : found->second.limit;
}

double SetPointPanel::slewRate() const
{
    return isProfiled() ? 0.0 : slewRate(entered(), m_mode);
}

void SetPointPanel::apply(SetPoint &setPoint) const
{
    setPoint.mode = m_mode;
    setPoint.target = target().value_or(0.0);
    if (m_can.outputOptions)
        m_options->apply(setPoint);
    if (isProfiled()) {
        setPoint.velocity = parseNumber(m_velocity->text()).value_or(0.0);
        setPoint.acceleration = parseNumber(m_acceleration->text()).value_or(0.0);
    }
}

void SetPointPanel::focusField()
{
    m_field->setFocus(Qt::ShortcutFocusReason);
    m_field->selectAll();
}

} // namespace mb
