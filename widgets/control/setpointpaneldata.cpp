// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/setpointpanel.h"

#include "widgets/common/numberformat.h"
#include "widgets/control/driveoptions.h"
#include "widgets/control/setpointentry.h"
#include "widgets/control/wrappedlabel.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace mb {

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
