// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/exportbar.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/exportjob.h"
#include "widgets/plots/plotboard.h"
#include "widgets/plots/plotdialogs.h"

#include <QProgressBar>

#include <iterator>

namespace mb {
namespace {

ExportChannel derivedChannel(const SignalBook::Derived &derived)
{
    return {derived.signal->telemetry(), {0}, {}, {}, derived.name.toStdString(), derived.unit.toStdString(),
        derived.formula.toStdString(), false};
}

std::vector<ExportChannel> channelsHere(const Snapshot &snapshot, const DeviceView &device)
{
    const LinkView *link = snapshot.link(device.link);
    return channelsOf(device, link && link->simulated);
}

/// The signals that a file of samples gets: everything that there is, or what is plotted.
std::vector<ExportChannel> exportChannels(const Snapshot &snapshot, const PlotBoard &board, bool everything)
{
    std::vector<ExportChannel> channels;
    if (everything) {
        for (const DeviceView &device : snapshot.devices) {
            const auto all = channelsHere(snapshot, device);
            channels.insert(channels.end(), all.begin(), all.end());
        }
        for (const SignalBook::Derived &derived : board.book().derived()) {
            if (derived.signal)
                channels.push_back(derivedChannel(derived));
        }
        return channels;
    }
    for (const PlotBoard::Trace &trace : board.traces()) {
        if (const DeviceView *device = snapshot.device(trace.signal.device))
            channels.push_back(channelsHere(snapshot, *device).at(trace.signal.channel.value));
        else if (const auto *derived = board.book().derivedOf(trace.signal))
            channels.push_back(derivedChannel(*derived));
    }
    return channels;
}

/// What is known of every device, for the head of the file.
std::vector<std::pair<std::string, mcap::Map>> aboutDevices(const Snapshot &snapshot)
{
    std::vector<std::pair<std::string, mcap::Map>> facts;
    for (const DeviceView &device : snapshot.devices) {
        auto described = describe(device);
        std::move(described.begin(), described.end(), std::back_inserter(facts));
    }
    return facts;
}

} // namespace

ExportBar::ExportBar(Workbench &workbench, PlotBoard &board, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_board(board)
    , m_job(new ExportJob(this))
    , m_progress(new QProgressBar(this))
{
    auto *row = layoutIn<QHBoxLayout>(
        this, -1, {theme.theme().u(12), theme.theme().u(4), theme.theme().u(12), theme.theme().u(4)});
    m_progress->setRange(0, 100);
    m_progress->setAccessibleName(tr("Progress of the export"));
    auto *cancel = new CommandButton(theme, tr("Cancel"), this);
    row->addWidget(textLabel(tr("Writing samples"), TextRole::Caption, Tone::Dim, this));
    row->addWidget(m_progress, 1);
    row->addWidget(cancel);
    hide();
    connect(cancel, &QPushButton::clicked, m_job, &ExportJob::cancel);
    connect(m_job, &ExportJob::progressed, m_progress, &QProgressBar::setValue);
    connect(m_job, &ExportJob::finished, this, &ExportBar::finished);
}

ExportPlan ExportBar::planFor(const ExportChoice &choice) const
{
    ExportPlan plan;
    plan.channels = exportChannels(m_workbench.snapshot(), m_board, choice.everything);
    plan.clock = m_workbench.wallClock(m_board.link());
    plan.about = aboutDevices(m_workbench.snapshot());
    plan.notes = m_board.notes();
    if (choice.stretch) {
        const auto [from, to] = std::minmax(choice.stretch->first, choice.stretch->second);
        plan.from = instantOf(from);
        plan.to = instantOf(to);
        return plan;
    }
    plan.from = plan.to = m_workbench.now();
    for (const ExportChannel &channel : plan.channels) {
        const auto first = channel.telemetry->first(channel.channel);
        plan.from = first ? std::min(plan.from, first->time) : plan.from;
    }
    return plan;
}

void ExportBar::exportSamples(const ExportChoice &choice)
{
    if (!m_job->start(planFor(choice), choice.path)) {
        m_workbench.report(Severity::Caution, {}, tr("One export at a time: %1 is being written.").arg(m_job->path()));
        return;
    }
    m_progress->setValue(0);
    show();
    m_workbench.report(Severity::Info, {}, tr("writing %1").arg(choice.path));
}

void ExportBar::finished(const QString &path, const Result<ExportReport> &report)
{
    hide();
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

} // namespace mb
