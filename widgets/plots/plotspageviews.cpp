// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/segmented.h"
#include "widgets/plots/curveplot.h"
#include "widgets/plots/plotanalysis.h"
#include "widgets/plots/plotdialogs.h"
#include "widgets/plots/plotscrubber.h"
#include "widgets/plots/plotspage.h"
#include "widgets/plots/recorder.h"
#include "widgets/plots/triggerbar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QStackedWidget>

namespace mb {
namespace {

constexpr double analyseEvery = 0.5;             ///< seconds
constexpr std::size_t liveSamples = 1U << 15U;   ///< of a spectrum that is made twice a second
constexpr std::size_t pausedSamples = 1U << 20U; ///< of one that is looked at

AnalysedTrace analysed(const PlotBoard::Trace &trace)
{
    return {trace.source, trace.style.name, trace.style.unit, trace.style.look()};
}

} // namespace

void PlotsPage::buildAgainst(QWidget &parent)
{
    m_againstPage = new QWidget(&parent);
    m_against = new CurvePlot(m_theme, tr("One signal against another"), m_againstPage);
    m_againstX = new QComboBox(m_againstPage);
    m_againstX->setAccessibleName(tr("Signal across"));
    m_againstY = new QComboBox(m_againstPage);
    m_againstY->setAccessibleName(tr("Signal upwards"));
    auto *row = new QHBoxLayout;
    const Theme &theme = m_theme.theme();
    row->setContentsMargins(theme.u(12), theme.u(4), theme.u(12), theme.u(4));
    row->addWidget(m_againstY);
    row->addWidget(textLabel(tr("against"), TextRole::Caption, Tone::Dim, m_againstPage));
    row->addWidget(m_againstX);
    row->addStretch(1);
    auto *column = new QVBoxLayout(m_againstPage);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(m_against, 1);
    for (QComboBox *box : {m_againstX, m_againstY})
        connect(box, qOverload<int>(&QComboBox::activated), this, [this] {
            m_against->setCurves({});
            refreshAgainst();
            m_against->fit();
        });
}

CurvePlot &PlotsPage::curves(View view)
{
    return view == View::Against ? *m_against : *m_spectrum;
}

void PlotsPage::showView(View view)
{
    m_view->setCurrent(static_cast<int>(view));
    const int timePage = m_board->traces().empty() ? 0 : 1;
    m_plots->setCurrentIndex(view == View::Time ? timePage : view == View::Against ? 2 : 3);
    m_analysedAt = -1.0;
    refreshView(plotKey(m_board->present()));
    if (view != View::Time)
        curves(view).fit();
}

void PlotsPage::fillAgainst()
{
    for (QComboBox *box : {m_againstX, m_againstY}) {
        const QString before = box->currentText();
        box->clear();
        for (const PlotBoard::Trace &trace : m_board->traces())
            box->addItem(trace.style.name);
        const int other = box == m_againstY || box->count() < 2 ? 0 : 1;
        box->setCurrentIndex(before.isEmpty() || box->findText(before) < 0 ? other : box->findText(before));
    }
    if (m_againstX->count() > 1 && m_againstX->currentIndex() == m_againstY->currentIndex())
        m_againstX->setCurrentIndex(m_againstY->currentIndex() == 0 ? 1 : 0); // against itself it is a line
}

void PlotsPage::refreshView(double now)
{
    const int page = m_plots->currentIndex();
    if (page < 2 || (m_analysedAt >= 0.0 && now - m_analysedAt < analyseEvery))
        return;
    if (m_analysedAt >= 0.0 && !m_stack->isLive() && !m_stack->cursorsShown())
        return; // nothing moves
    // The time plot is not drawn now, but its window goes on.
    const bool first = m_analysedAt < 0.0;
    m_analysedAt = now;
    if (m_stack->isLive() && !m_stack->heldKey())
        m_stack->follow(now);
    page == 2 ? refreshAgainst() : refreshSpectrum();
    if (first)
        curves(page == 2 ? View::Against : View::Spectrum).fit();
}

void PlotsPage::refreshSpectrum()
{
    std::vector<AnalysedTrace> traces;
    QStringList units;
    for (const PlotBoard::Trace &trace : m_board->traces()) {
        traces.push_back(analysed(trace));
        if (!units.contains(trace.style.unit))
            units << trace.style.unit;
    }
    const bool selection = m_stack->cursorsShown();
    const auto [a, b] = selection ? m_stack->cursorKeys() : m_stack->range();
    const bool still = selection || !m_stack->isLive();
    const Analysis analysis = spectra(traces, std::min(a, b), std::max(a, b), still ? pausedSamples : liveSamples);
    m_spectrum->setAxes(tr("frequency, Hz"), tr("amplitude, %1").arg(units.join(QStringLiteral(", "))), true);
    m_spectrum->setWatermark(m_stack->watermark());
    m_spectrum->setCurves(analysis.curves);
    m_spectrum->setNote(
        (selection ? tr("A … B") : tr("what is seen")) + tr(", Hann window, peak values. ") + analysis.note);
}

void PlotsPage::refreshAgainst()
{
    const auto &traces = m_board->traces();
    const int x = m_againstX->currentIndex();
    const int y = m_againstY->currentIndex();
    if (x < 0 || y < 0 || traces.size() <= static_cast<std::size_t>(std::max(x, y)))
        return;
    const PlotBoard::Trace &wide = traces[static_cast<std::size_t>(x)];
    const PlotBoard::Trace &high = traces[static_cast<std::size_t>(y)];
    const bool selection = m_stack->cursorsShown();
    const auto [a, b] = selection ? m_stack->cursorKeys() : m_stack->range();
    const Analysis analysis = against(analysed(wide), analysed(high), std::min(a, b), std::max(a, b));
    m_against->setAxes(
        tr("%1, %2").arg(wide.style.name, wide.style.unit), tr("%1, %2").arg(high.style.name, high.style.unit), false);
    m_against->setWatermark(m_stack->watermark());
    m_against->setCurves(analysis.curves);
    m_against->setNote((selection ? tr("A … B: ") : tr("what is seen: ")) + analysis.note);
}

void PlotsPage::triggerOn(int id)
{
    m_triggerBar->choose(id);
    m_triggerBar->show();
    if (const auto middle = m_stack->middleOf(id); middle && m_triggerBar->setup().level == 0.0)
        m_triggerBar->setLevel(*middle);
    arm();
}

void PlotsPage::triggerOff()
{
    m_trigger.disarm();
    m_stack->setTrigger({});
    m_triggerBar->hide();
    const QSignalBlocker quiet(m_triggerButton);
    m_triggerButton->setChecked(false);
}

void PlotsPage::arm()
{
    const PlotBoard::Trace *trace = m_board->traceOf(m_triggerBar->trace());
    if (!trace)
        return triggerOff();
    const QSignalBlocker quiet(m_triggerButton);
    m_triggerButton->setChecked(true);
    m_triggerBar->show();
    m_stack->setLive(true);
    m_trigger.arm(m_triggerBar->setup(), trace->source, plotKey(m_board->present()));
    showTrigger();
}

void PlotsPage::showTrigger()
{
    m_stack->setTrigger(
        PlotTrigger{m_triggerBar->trace(), m_triggerBar->setup().level, m_triggerBar->description(m_stack->window())});
}

void PlotsPage::showRowMenu(int id, const QPoint &at)
{
    const PlotBoard::Trace *trace = m_board->traceOf(id);
    if (!trace)
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const int strip = trace->style.strip;
    menu->addAction(tr("In a pane of its own"), this, [this, id] { m_board->moveToPane(id, m_board->paneOf(-1)); });
    QAction *above = menu->addAction(
        tr("Into the pane above"), this, [this, id, strip] { m_board->moveToPane(id, m_board->paneOf(strip - 1)); });
    above->setEnabled(strip > 0);
    menu->addAction(tr("With its unit"), this, [this, id] { m_board->moveToPane(id, {}); });
    QAction *second = menu->addAction(
        tr("Scale at the right"), this, [this, id, on = !trace->second] { m_board->setSecondAxis(id, on); });
    second->setCheckable(true);
    second->setChecked(trace->second);
    menu->addSeparator();
    menu->addAction(tr("Trigger on it\tT"), this, [this, id] { triggerOn(id); });
    menu->addAction(tr("Keep all as references"), m_board, &PlotBoard::keepReferences);
    QAction *clear = menu->addAction(tr("Remove references"), m_board, &PlotBoard::clearReferences);
    clear->setEnabled(!m_board->references().empty());
    menu->addAction(tr("Spectrum"), this, [this] { showView(View::Spectrum); });
    menu->addSeparator();
    menu->addAction(tr("Remove the trace"), this, [this, signal = trace->signal] { m_board->choose(signal, false); });
    menu->popup(at);
}

void PlotsPage::addMenuEntries(QMenu &menu, double key)
{
    menu.addSeparator();
    menu.addAction(tr("Note at this time…\tN"), this, [this, key] { newNote(key); });
    menu.addAction(tr("Keep what is seen as a reference"), m_board, &PlotBoard::keepReferences);
    QAction *clear = menu.addAction(tr("Remove references"), m_board, &PlotBoard::clearReferences);
    clear->setEnabled(!m_board->references().empty());
    menu.addAction(tr("Derived signal…"), this, &PlotsPage::newDerived);
    menu.addAction(tr("Spectrum of what is seen"), this, [this] { showView(View::Spectrum); });
    menu.addAction(tr("X-Y"), this, [this] { showView(View::Against); });
    menu.addAction(tr("Trigger: stands still at an edge or a level") + QStringLiteral("\tT"), m_triggerButton,
        &QAbstractButton::toggle);
    menu.addAction(tr("Export samples…"), this, [this] {
        askExport(*this, m_stack->cursorsShown(), [this](const ExportChoice &choice) { exportSamples(choice); });
    });
}

void PlotsPage::newDerived()
{
    const auto check
        = [this](const QString &name, const QString &formula) { return m_board->whatIsWrong(name, formula); };
    askDerived(*this, m_theme, m_board->variables(), check,
        [this](const QString &name, const QString &unit, const QString &formula) {
            if (const auto added = m_board->addDerived(name, unit, formula); !added)
                m_workbench.report(Severity::Danger, {}, tr("%1: %2").arg(name, errorText(added.error())));
        });
}

void PlotsPage::newNote(double key)
{
    askNote(*this, [this, key](const QString &text) {
        m_board->addNote(key, text);
        if (m_recorder && !m_board->notes().empty())
            m_recorder->note(m_board->notes().back().time, text);
    });
}

} // namespace mb
