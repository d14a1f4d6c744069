// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/triggercontrol.h"

namespace mb {

TriggerControl::TriggerControl(PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent)
    : QObject(parent)
    , m_stack(stack)
    , m_board(board)
    , m_bar(new TriggerBar(theme, parent))
    , m_watch(stack)
{
    m_bar->hide();
    connect(m_bar, &TriggerBar::changed, this, &TriggerControl::arm);
    connect(m_bar, &TriggerBar::closed, this, &TriggerControl::disarm);
    connect(&stack.input(), &PlotInput::triggerLevelMoved, this, [this](double level) {
        m_bar->setLevel(level);
        arm();
    });
}

void TriggerControl::armOn(int id)
{
    m_bar->choose(id);
    m_bar->show();
    if (const auto middle = m_stack.readings().middleOf(id);
        middle && m_bar->setup().value_or(TriggerSetup()).level == 0.0)
        m_bar->setLevel(*middle);
    arm();
}

void TriggerControl::disarm()
{
    m_watch.disarm();
    m_stack.strips().setTrigger({});
    m_bar->hide();
    Q_EMIT armedChanged(false);
}

void TriggerControl::setOn(bool on)
{
    if (!on)
        disarm();
    else if (m_bar->isHidden() && !m_board.traces().empty())
        armOn(m_board.traces().front().id);
}

void TriggerControl::follow()
{
    std::vector<TriggerBar::Choice> choices;
    for (const PlotBoard::Trace &trace : m_board.traces())
        choices.push_back({trace.id, trace.signal, trace.style.name, trace.style.unit});
    const bool there = m_bar->setTraces(choices);
    if (m_bar->isHidden())
        return;
    if (!there)
        disarm();
    else if (m_watch.isOn(*m_board.traceOf(m_bar->trace())->source))
        showLine(); // an event that is caught stays
    else
        arm();
}

void TriggerControl::arm()
{
    const PlotBoard::Trace *trace = m_board.traceOf(m_bar->trace());
    if (!trace)
        return disarm();
    Q_EMIT armedChanged(true);
    m_bar->show();
    const auto setup = m_bar->setup();
    if (!setup) { // it waits for a level
        m_watch.disarm();
        return m_stack.strips().setTrigger({});
    }
    m_stack.view().setLive(true);
    m_watch.arm(*setup, trace->source, plotKey(m_board.present()));
    showLine();
}

void TriggerControl::showLine()
{
    m_stack.strips().setTrigger(PlotTrigger{
        m_bar->trace(), m_watch.setup().level, m_bar->description(m_watch.setup(), m_stack.view().window())});
}

} // namespace mb
