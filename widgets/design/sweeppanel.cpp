// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/sweeppanel.h"

#include "model/family.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/wrappedlabel.h"

namespace mb {
namespace {

QString announced(const tuning::SweepPlan &plan)
{
    return SweepPanel::tr(
        "%1 sines from %2 to %3 Hz, both ways in turn: duty %4 ± %5 %, at most %6 counts/s, %7 counts one "
        "way, %8.")
        .arg(plan.hertz.size())
        .arg(formatSignificant(plan.hertz.front(), 2), formatSignificant(plan.hertz.back(), 2),
            formatNumber(100.0 * plan.bias), formatNumber(100.0 * plan.swing), formatNumber(plan.speed),
            formatNumber(plan.travel), formatDuration(plan.seconds));
}

} // namespace

SweepPanel::SweepPanel(Arming &arming, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_arming(arming)
{
    const Theme &look = theme.theme();
    auto *row = layoutIn<QHBoxLayout>(this, look.u(12), {look.u(12), look.u(6), look.u(12), look.u(6)});
    m_button = new CommandButton(theme, tr("Frequency response"), this);
    m_button->setToolTip(tr("Measures the motor by sines and draws it over its model, as far as it may be trusted"));
    m_words = wrappedLabel({}, TextRole::Caption, Tone::Dim, this);
    row->addWidget(m_button);
    row->addWidget(m_words, 1);
    connect(m_button, &QPushButton::clicked, this, &SweepPanel::measure);
    follow({});
}

void SweepPanel::follow(const State &state)
{
    m_plan.reset();
    m_place = state.place;
    const bool known = state.family && state.family->trials && state.report && state.report->plant.gain > 0.0
        && state.report->loop != Mode::Current && !(state.family->trials->nudge > 0.0);
    setVisible(known);
    m_mayRun = known && state.mayRun;
    if (!known)
        return;
    m_plant = state.report->plant;
    const auto plan = tuning::planSweep(
        m_plant, state.inForce, std::chrono::duration<double>(state.family->capabilities.commandPeriod).count());
    if (plan) {
        m_plan = *plan;
        m_plan->axis = state.report->axis;
        m_plan->slot = state.report->slot;
        m_plan->limits = state.entered;
    }
    m_words->setText(plan ? announced(*plan) : errorText(plan.error()));
    m_button->setAccessibleDescription(m_words->text());
    m_button->setEnabled(m_mayRun && m_plan);
}

void SweepPanel::measure()
{
    if (!m_mayRun || !m_plan)
        return;
    m_arming.runSweep(*m_plan, m_plant, guarded(this, [this, place = m_place](const auto &response) {
        if (response && response->stopReason == tuning::EndReason::None) // else it is a part of one
            Q_EMIT measured(place, *response);
    }));
}

QString SweepPanel::announcement() const
{
    return m_words->text();
}

} // namespace mb
