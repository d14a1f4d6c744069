// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/analysisviews.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/plots/plotanalysis.h"
#include "widgets/plots/plotexport.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QMenu>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr std::size_t liveSamples = 1U << 15U;   ///< of a spectrum that is made twice a second
constexpr std::size_t pausedSamples = 1U << 20U; ///< of one that is looked at

AnalysedTrace analysed(const PlotBoard::Trace &trace)
{
    return {trace.source, trace.style.name, trace.style.unit, trace.style.look()};
}

std::pair<double, double> stretchOf(const PlotStack &stack)
{
    const auto [a, b] = stack.cursorsShown() ? stack.cursorKeys() : stack.view().range();
    return std::minmax({a, b});
}

} // namespace

void fillExportMenu(QMenu &menu, CurvePlot &plot, Workbench &workbench)
{
    menu.addAction(
        AgainstView::tr("Copy picture"), &plot, [&plot] { QApplication::clipboard()->setPixmap(plot.picture()); });
    addPictures(
        menu, plot, [&plot](const QString &kind) { return plot.contentAs(kind); },
        [&workbench](const QString &path, const Result<void> &written) {
            workbench.report(written ? Severity::Good : Severity::Danger, {},
                written ? AgainstView::tr("plot written to %1").arg(path) : errorText(written.error()));
        });
}

AgainstView::AgainstView(PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_stack(stack)
    , m_board(board)
    , m_plot(new CurvePlot(theme, tr("One signal against another"), this))
    , m_across(new QComboBox(this))
    , m_upwards(new QComboBox(this))
{
    m_across->setAccessibleName(tr("Signal across"));
    m_upwards->setAccessibleName(tr("Signal upwards"));
    m_plot->setSurroundings({.legend = false}); // the axes name the one curve
    auto *row = new QHBoxLayout;
    row->setContentsMargins(theme.theme().u(12), theme.theme().u(4), theme.theme().u(12), theme.theme().u(4));
    row->addWidget(m_upwards);
    row->addWidget(textLabel(tr("against"), TextRole::Caption, Tone::Dim, this));
    row->addWidget(m_across);
    row->addStretch(1);
    auto *column = layoutIn<QVBoxLayout>(this);
    column->addLayout(row);
    column->addWidget(m_plot, 1);
    for (QComboBox *box : {m_across, m_upwards})
        connect(box, qOverload<int>(&QComboBox::activated), this, [this] {
            m_plot->setCurves({});
            refresh();
            m_plot->fit();
        });
}

void AgainstView::follow()
{
    const auto listed = std::exchange(m_listed, {});
    for (const PlotBoard::Trace &trace : m_board.traces())
        m_listed.push_back(trace.signal);
    for (QComboBox *box : {m_across, m_upwards}) {
        const int before = box->currentIndex();
        box->clear();
        for (const PlotBoard::Trace &trace : m_board.traces())
            box->addItem(trace.style.name);
        const int other = box == m_upwards || box->count() < 2 ? 0 : 1;
        const auto kept
            = before < 0 ? m_listed.end() : std::ranges::find(m_listed, listed.at(static_cast<std::size_t>(before)));
        box->setCurrentIndex(kept == m_listed.end() ? other : static_cast<int>(kept - m_listed.begin()));
    }
    if (m_listed.empty())
        m_plot->setCurves({});
    if (m_across->count() > 1 && m_across->currentIndex() == m_upwards->currentIndex())
        m_across->setCurrentIndex(m_upwards->currentIndex() == 0 ? 1 : 0); // against itself it is a line
}

void AgainstView::refresh()
{
    const auto &traces = m_board.traces();
    const int x = m_across->currentIndex();
    const int y = m_upwards->currentIndex();
    if (x < 0 || y < 0 || traces.size() <= static_cast<std::size_t>(std::max(x, y)))
        return;
    const PlotBoard::Trace &wide = traces[static_cast<std::size_t>(x)];
    const PlotBoard::Trace &high = traces[static_cast<std::size_t>(y)];
    const auto [from, to] = stretchOf(m_stack);
    const Analysis analysis = against(analysed(wide), analysed(high), from, to);
    m_plot->setAxes(
        tr("%1, %2").arg(wide.style.name, wide.style.unit), tr("%1, %2").arg(high.style.name, high.style.unit), false);
    m_plot->setWatermark(m_stack.strips().watermark());
    m_plot->setCurves(analysis.curves);
    m_plot->setNote((m_stack.cursorsShown() ? tr("A … B: ") : tr("what is seen: ")) + analysis.note);
}

SpectrumView::SpectrumView(PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_stack(stack)
    , m_board(board)
    , m_plot(new CurvePlot(theme, tr("Spectrum"), this))
{
    auto *column = layoutIn<QVBoxLayout>(this);
    column->addWidget(m_plot);
    m_plot->setAxes(tr("frequency, Hz"), tr("amplitude"), true);
}

void SpectrumView::follow()
{
    if (m_board.traces().empty())
        m_plot->setCurves({});
}

void SpectrumView::refresh()
{
    std::vector<AnalysedTrace> traces;
    QStringList units;
    for (const PlotBoard::Trace &trace : m_board.traces()) {
        traces.push_back(analysed(trace));
        if (!units.contains(trace.style.unit))
            units << trace.style.unit;
    }
    const bool selection = m_stack.cursorsShown();
    const auto [from, to] = stretchOf(m_stack);
    const bool still = selection || !m_stack.view().isLive();
    const Analysis analysis = spectra(traces, from, to, still ? pausedSamples : liveSamples);
    m_plot->setAxes(tr("frequency, Hz"), tr("amplitude, %1").arg(units.join(QStringLiteral(", "))), true);
    m_plot->setWatermark(m_stack.strips().watermark());
    m_plot->setCurves(analysis.curves);
    m_plot->setNote(
        (selection ? tr("A … B") : tr("what is seen")) + tr(", Hann window, peak values. ") + analysis.note);
}

} // namespace mb
