// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/sampleswindow.h"

#include "recording/exportcsv.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/pagekeys.h"
#include "widgets/plots/exportjob.h"
#include "widgets/plots/recordedtraces.h"
#include "widgets/plots/telemetrysource.h"

#include <QFile>
#include <QFileInfo>
#include <QListWidget>
#include <QMenu>
#include <QSignalBlocker>
#include <QThread>

#include <algorithm>
#include <chrono>
#include <optional>

namespace mb {
namespace {

constexpr std::chrono::milliseconds tickTime(16);
constexpr int listWidth = 232;
constexpr int edge = 12;

/// "12.3 s, 12 000 samples, 3 lost", and what is wrong with it.
QString stateOf(const LoadedRecording &recording)
{
    const RecordingTotals totals = totalsOf(recording);
    QString text = SamplesWindow::tr("%1 s, %2 samples, %3 lost")
                       .arg(formatNumber(totals.seconds), formatCount(static_cast<qint64>(totals.samples)),
                           formatCount(static_cast<qint64>(totals.lost)));
    if (!recording.complete)
        text += SamplesWindow::tr("; the end of the file is missing");
    if (recording.shortened)
        text += SamplesWindow::tr("; the file has more, of which nothing is shown: it is too large for the memory");
    return text;
}

} // namespace

bool SamplesWindow::isFor(const QString &path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    return suffix == QLatin1String("mcap") || suffix == QLatin1String("csv");
}

SamplesWindow::SamplesWindow(const QString &path, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent, Qt::Window)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("%1 (recorded samples)").arg(QFileInfo(path).fileName()));
    build(path, theme);
    addKeys();
    connect(&m_tick, &QTimer::timeout, m_stack, [this] { m_stack->refresh(m_stack->view().range().second); });
    read(path);
}

void SamplesWindow::build(const QString &path, const ThemeSource &theme)
{
    const int space = theme.theme().u(edge);
    auto *column = layoutIn<QVBoxLayout>(this, -1, {space, space, space, space});
    auto *head = new QHBoxLayout;
    m_state = textLabel(tr("Reading %1").arg(path), TextRole::Body, Tone::Dim, this);
    m_state->setWordWrap(true);
    head->addWidget(m_state, 1);
    auto *fit = new IconButton(theme, Symbol::Fit, tr("Fit time and value"), this);
    fit->setKeyHint(QStringLiteral("0"));
    auto *cursors = new IconButton(theme, Symbol::Cursors, tr("Cursors"), this);
    cursors->setKeyHint(QStringLiteral("L"));
    auto *save = new IconButton(theme, Symbol::Export, tr("Export"), this);
    for (QWidget *button : {static_cast<QWidget *>(fit), static_cast<QWidget *>(cursors), static_cast<QWidget *>(save)})
        head->addWidget(button);
    column->addLayout(head);
    m_said = textLabel({}, TextRole::Body, Tone::Dim, this);
    m_said->setWordWrap(true);
    m_said->hide();
    column->addWidget(m_said);
    auto *row = new QHBoxLayout;
    m_channels = new QListWidget(this);
    m_channels->setAccessibleName(tr("Channels"));
    m_channels->setFixedWidth(theme.theme().u(listWidth));
    m_stack = new PlotStack(theme, this);
    m_stack->setAccessibleName(tr("Recorded samples"));
    row->addWidget(m_channels);
    row->addWidget(m_stack, 1);
    column->addLayout(row, 1);
    resize(theme.theme().u(1100), theme.theme().u(700));
    connect(fit, &QToolButton::clicked, m_stack, &PlotStack::fit);
    connect(cursors, &QToolButton::clicked, this, [this] { m_stack->setCursorsShown(!m_stack->cursorsShown()); });
    connect(
        save, &QToolButton::clicked, this, [this, save] { showExports(save->mapToGlobal(QPoint(0, save->height()))); });
    connectExports();
    connect(m_channels, &QListWidget::itemChanged, this, [this](const QListWidgetItem *item) {
        m_stack->strips().setTraceVisible(item->data(Qt::UserRole).toInt(), item->checkState() == Qt::Checked);
    });
}

void SamplesWindow::connectExports()
{
    m_job = new ExportJob(this);
    m_stack->exporter().setTable([this] { return [this](const QString &path) { exportTable(path); }; });
    connect(&m_stack->exporter(), &PlotExport::exported, this,
        [this](const QString &to) { say(tr("Written: %1").arg(to), Tone::Dim); });
    connect(
        &m_stack->exporter(), &PlotExport::exportFailed, this, [this](const QString &why) { say(why, Tone::Danger); });
    connect(m_job, &ExportJob::finished, this, [this](const QString &to, const Result<ExportReport> &report) {
        report ? say(tr("Written: %1").arg(to), Tone::Dim) : say(errorText(report.error()), Tone::Danger);
    });
}

void SamplesWindow::say(const QString &text, Tone tone)
{
    m_said->setText(text);
    setTone(*m_said, tone);
    m_said->show();
}

void SamplesWindow::showExports(const QPoint &at)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    m_stack->fillMenu(*menu);
    menu->popup(at);
}

/// Every sample of what is seen, of the channels that are.
void SamplesWindow::exportTable(const QString &path)
{
    if (!m_recording)
        return;
    ExportPlan plan;
    for (int i = 0; i < m_channels->count(); ++i) {
        if (m_channels->item(i)->checkState() != Qt::Checked)
            continue;
        const auto place = static_cast<std::uint16_t>(i);
        const Channel &row = m_recording->table[place];
        plan.channels.push_back({m_recording->telemetry, {place}, {}, {}, std::string(row.label), std::string(row.unit),
            {}, m_recording->simulated});
    }
    for (const auto &[name, facts] : m_recording->about) {
        if (!name.starts_with("loss "))
            plan.about.emplace_back(name, facts);
    }
    const auto [from, to] = m_stack->view().range();
    constexpr Duration rounding = std::chrono::microseconds(1); // of keys
    plan.from = std::max(instantOf(from) - rounding, m_recording->first);
    plan.to = std::min(instantOf(to) + rounding, m_recording->last);
    const auto work = [plan, file = QFile::encodeName(path).toStdString()](
                          const ExportProgress &progress) { return exportCsv(plan, file, progress); };
    if (!m_job->start(work, path))
        say(tr("One export at a time: %1 is being written.").arg(m_job->path()), Tone::Caution);
}

void SamplesWindow::addKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_0}, tr("shows everything"), [this] { m_stack->fit(); });
    keys->add(
        {Qt::Key_L}, tr("shows or hides the cursors"), [this] { m_stack->setCursorsShown(!m_stack->cursorsShown()); });
    keys->add({QKeySequence::Close}, tr("closes this window"), [this] { close(); });
    keys->add({Qt::Key_F1}, tr("shows these keys"), [this, keys] { showKeys(*this, tr("Recorded samples"), {keys}); });
}

/// A recording of an hour takes seconds; the thread outlives a window that is closed meanwhile, and nobody takes its result.
void SamplesWindow::read(const QString &path)
{
    using Read = Result<std::shared_ptr<const LoadedRecording>>;
    const auto result = std::make_shared<std::optional<Read>>();
    QThread *thread = QThread::create(
        [result, file = QFile::encodeName(path).toStdString()] { result->emplace(loadRecording(file)); });
    connect(thread, &QThread::finished, this, [this, result] { take(**result); });
    connect(thread, &QThread::finished, thread, &QObject::deleteLater);
    thread->start();
}

void SamplesWindow::take(const Result<std::shared_ptr<const LoadedRecording>> &read)
{
    if (!read) {
        m_failure = errorText(read.error());
        m_state->setText(m_failure);
        setTone(*m_state, Tone::Danger);
        Q_EMIT loaded();
        return;
    }
    m_recording = *read;
    listChannels(showRecording(*m_stack, *m_recording));
    m_state->setText(stateOf(*m_recording));
    m_tick.start(tickTime);
    m_stack->setFocus();
    Q_EMIT loaded();
}

void SamplesWindow::listChannels(const std::vector<int> &traces)
{
    const QSignalBlocker quiet(m_channels); // nobody has switched anything yet
    for (std::size_t i = 0; i < traces.size(); ++i) {
        auto *item = new QListWidgetItem(qt(m_recording->table[i].label), m_channels);
        item->setToolTip(item->text());
        if (traces[i] < 0) {
            item->setFlags(Qt::NoItemFlags);
            item->setText(tr("%1: no samples").arg(item->text()));
            continue;
        }
        item->setData(Qt::UserRole, traces[i]);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(Qt::Checked);
    }
}

} // namespace mb
