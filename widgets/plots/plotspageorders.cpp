// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/curveplot.h"
#include "widgets/plots/exportjob.h"
#include "widgets/plots/plotdialogs.h"
#include "widgets/plots/plotspage.h"
#include "widgets/plots/recorder.h"

#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QStackedWidget>

namespace mb {

void PlotsPage::fillExportMenu(QMenu &menu)
{
    if (m_plots->currentWidget() == m_stack) {
        m_stack->fillMenu(menu);
        return addMenuEntries(menu, m_stack->range().second);
    }
    menu.addAction(tr("Copy picture"), this, [this] {
        QApplication::clipboard()->setPixmap(
            curves(m_plots->currentIndex() == 2 ? View::Against : View::Spectrum).picture());
    });
    menu.addAction(tr("Export PNG…"), this, [this] { exportView(QStringLiteral("png"), tr("PNG picture (*.png)")); });
    menu.addAction(tr("Export SVG…"), this, [this] { exportView(QStringLiteral("svg"), tr("SVG drawing (*.svg)")); });
    menu.addAction(tr("Export PDF…"), this, [this] { exportView(QStringLiteral("pdf"), tr("PDF document (*.pdf)")); });
}

void PlotsPage::exportView(const QString &suffix, const QString &filter)
{
    auto *dialog = new QFileDialog(this, tr("Export plot"), QString(), filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) {
        const auto written = curves(m_plots->currentIndex() == 2 ? View::Against : View::Spectrum).exportTo(path);
        m_workbench.report(written ? Severity::Good : Severity::Danger, {},
            written ? tr("plot written to %1").arg(path) : errorText(written.error()));
    });
    dialog->open();
}

void PlotsPage::exportSamples(const ExportChoice &choice)
{
    ExportPlan plan;
    plan.channels = m_board->exportChannels(choice.everything);
    plan.unixOffset = m_workbench.unixOffset();
    plan.about = m_board->about();
    plan.notes = m_board->notes();
    const auto instant
        = [](double key) { return Instant(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(key))); };
    const auto [a, b] = choice.range == ExportChoice::Range::Selection ? m_stack->cursorKeys() : m_stack->range();
    plan.from = instant(std::min(a, b));
    plan.to = instant(std::max(a, b));
    if (choice.range == ExportChoice::Range::Session) {
        plan.from = plan.to = m_workbench.now();
        for (const ExportChannel &channel : plan.channels) {
            const auto first = channel.telemetry->first(channel.channel);
            plan.from = first ? std::min(plan.from, first->time) : plan.from;
        }
    }
    if (!m_job->start(std::move(plan), choice.path)) {
        m_workbench.report(Severity::Caution, {}, tr("One export at a time: %1 is being written.").arg(m_job->path()));
        return;
    }
    m_progress->setValue(0);
    m_jobBar->show();
    m_workbench.report(Severity::Info, {}, tr("writing %1").arg(choice.path));
}

void PlotsPage::finished(const QString &path, const Result<ExportReport> &report)
{
    m_jobBar->hide();
    if (report)
        m_workbench.report(Severity::Good, {},
            tr("%1 written: %2 samples, %3 lost")
                .arg(path, formatCount(static_cast<qint64>(report->samples)),
                    formatCount(static_cast<qint64>(report->lost))));
    else if (report.error().fault == Fault::Cancelled)
        m_workbench.report(Severity::Info, {}, tr("export cancelled, nothing was written"));
    else
        m_workbench.report(Severity::Danger, {}, errorText(report.error()));
}

void PlotsPage::setLayoutFolder(const QString &folder)
{
    m_layouts = PlotLayouts(folder);
    m_defaultsOf = {};
    if (const auto last = m_layouts.load(PlotLayouts::lastName()))
        return applyLayout(*last);
    follow();
}

PlotLayout PlotsPage::currentLayout() const
{
    PlotLayout layout;
    layout.window = m_stack->window();
    for (const PlotBoard::Derived &derived : m_board->derived()) {
        if (!derived.name.isEmpty())
            layout.derived.push_back({derived.name, derived.unit, derived.formula});
    }
    for (const PlotBoard::Trace &trace : m_board->traces()) {
        const DeviceView *device = m_workbench.snapshot().device(trace.signal.device);
        const QString key = device ? qt(device->family->channels[trace.signal.channel.value].key) : trace.style.name;
        layout.traces.push_back({device ? qt(device->selector) : QString(), key, trace.pane, trace.second});
    }
    return layout;
}

std::vector<PlotBoard::Trace> PlotsPage::tracesOf(const PlotLayout &layout, DeviceId standIn) const
{
    std::vector<PlotBoard::Trace> traces;
    for (const PlotLayout::Trace &wanted : layout.traces) {
        if (wanted.device.isEmpty()) {
            const auto &derived = m_board->derived();
            for (std::uint16_t i = 0; i < derived.size(); ++i) {
                if (derived[i].name == wanted.key)
                    traces.push_back({{derivedDevice, {i}}, wanted.pane, wanted.second});
            }
            continue;
        }
        for (const DeviceView &device : m_workbench.snapshot().devices) {
            const bool fits
                = wanted.device == QLatin1String("*") ? device.id == standIn : qt(device.selector) == wanted.device;
            const auto channel = fits ? device.telemetry->find(wanted.key.toStdString()) : std::nullopt;
            if (channel)
                traces.push_back({{device.id, *channel}, wanted.pane, wanted.second});
        }
    }
    return traces;
}

void PlotsPage::applyLayout(const PlotLayout &layout)
{
    m_waiting = layout;
    m_stack->setWindow(layout.window);
    for (const PlotLayout::Derived &derived : layout.derived)
        m_board->ensureDerived(derived.name, derived.unit, derived.formula);
    applyWaiting(true);
}

/// Devices come one by one: the rest of the layout waits for them.
void PlotsPage::applyWaiting(bool first)
{
    auto traces = tracesOf(*m_waiting, m_selection.device());
    const bool more = traces.size() != m_board->traces().size();
    if (traces.size() >= m_waiting->traces.size())
        m_waiting.reset();
    if (first || more)
        m_board->setTraces(std::move(traces), true);
}

void PlotsPage::resetLayout()
{
    m_waiting.reset();
    m_defaultsOf = {};
    m_layouts.remove(PlotLayouts::lastName());
    m_stack->setWindow(10.0);
    m_stack->setLive(true);
    triggerOff();
    m_board->reset();
    follow();
    m_remember.stop();
}

void PlotsPage::rememberLayout()
{
    m_remember.stop();
    if (m_layouts.remembers() && m_board->isTouched() && !m_waiting)
        (void)m_layouts.save(PlotLayouts::lastName(), currentLayout());
}

void PlotsPage::fillLayoutMenu(QMenu &menu)
{
    menu.addAction(tr("Save layout as…"), this,
            [this] {
                askName(*this, tr("Save layout"), {}, [this](const QString &name) {
                    if (const auto saved = m_layouts.save(name.trimmed().remove(QLatin1Char('@')), currentLayout());
                        !saved)
                        m_workbench.report(Severity::Danger, {}, errorText(saved.error()));
                });
            })
        ->setEnabled(m_layouts.remembers());
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    if (device && m_layouts.remembers()) {
        menu.addAction(
            tr("Begin like this with every %1").arg(qt(device->family->title)), this, [this, id = device->id] {
                const DeviceView *selected = m_workbench.snapshot().device(id);
                PlotLayout layout = currentLayout();
                for (PlotLayout::Trace &trace : layout.traces) {
                    if (selected && trace.device == qt(selected->selector))
                        trace.device = QStringLiteral("*");
                }
                if (selected)
                    (void)m_layouts.save(PlotLayouts::familyName(qt(selected->family->key)), layout);
            });
        menu.addAction(tr("Begin with the usual for every %1").arg(qt(device->family->title)), this,
            [this, family = qt(device->family->key)] { m_layouts.remove(PlotLayouts::familyName(family)); });
    }
    menu.addAction(tr("Reset"), this, &PlotsPage::resetLayout);
    const QStringList names = m_layouts.names();
    if (!names.isEmpty())
        menu.addSeparator();
    for (const QString &name : names)
        menu.addAction(name, this, [this, name] {
            const auto layout = m_layouts.load(name);
            if (layout)
                applyLayout(*layout);
            else
                m_workbench.report(Severity::Danger, {}, errorText(layout.error()));
        });
}

void PlotsPage::setRecorder(Recorder *recorder, const QString &folder)
{
    m_recorder = recorder;
    m_recordFolder = folder;
    m_record->setVisible(recorder != nullptr);
    followWidth();
    if (!recorder)
        return;
    m_record->setToolTip(tr("Keeps everything that devices send, beginning with the last %1.\n"
                            "What was recorded lately is on disk all the time and outlives a crash.")
                             .arg(formatDuration(std::chrono::duration<double>(recorder->kept()).count())));
    connect(recorder, &Recorder::changed, this, &PlotsPage::showRecording);
    connect(recorder, &Recorder::saved, this, [this](const QString &path, const QString &error) {
        m_workbench.report(error.isEmpty() ? Severity::Good : Severity::Danger, {},
            error.isEmpty() ? tr("recording written to %1").arg(path) : error);
        showRecording();
    });
}

/// On a narrow window the numbers of the recording stand in the tooltip only.
void PlotsPage::followWidth()
{
    m_recordText->setVisible(m_recorder && width() > m_theme.theme().u(1250));
}

void PlotsPage::toggleRecording()
{
    if (!m_recorder->state().keeping)
        return m_recorder->startKeeping();
    if (m_recorder->state().saving)
        return;
    QDir().mkpath(m_recordFolder);
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
    m_recorder->save(QDir(m_recordFolder).filePath(name + QStringLiteral(".mcap")));
}

void PlotsPage::showRecording()
{
    if (!m_recorder)
        return;
    const Recorder::State state = m_recorder->state();
    m_record->setText(state.keeping ? tr("Save") : tr("Record"));
    m_record->setSymbol(Symbol::Record, state.keeping ? Tone::Danger : Tone::Text);
    m_record->setEnabled(!state.saving);
    if (!state.failure.isEmpty()) {
        m_recordText->setText(tr("not recorded: %1").arg(state.failure));
        return;
    }
    const double seconds = state.samples > 0 ? plotKey(m_workbench.now()) - state.since : 0.0;
    const QString length = formatDuration(std::floor(std::max(seconds, 0.0)));
    const QString size = formatBytes(static_cast<qint64>(state.bytes));
    m_recordText->setText(state.keeping
            ? tr("%1 · %2 · %3 samples").arg(length, size, formatCount(static_cast<qint64>(state.samples)))
            : tr("last %1 on disk · %2").arg(length, size));
    m_record->setAccessibleDescription(m_recordText->text());
}

} // namespace mb
