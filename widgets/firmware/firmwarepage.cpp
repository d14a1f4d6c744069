// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/firmwarepage.h"

#include "files/filebytes.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/updates.h"
#include "widgets/firmware/pagemap.h"
#include "widgets/firmware/routepanel.h"
#include "widgets/firmware/stepspanel.h"

#include <QDateTime>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QProgressBar>
#include <QTableWidget>
#include <QUrl>

namespace mb {
namespace {

constexpr std::int64_t largestFile = 16 * 1024 * 1024;

} // namespace

void FirmwarePage::loadImage(const QString &path)
{
    m_path = path;
    m_image.reset();
    m_summary.reset();
    m_imageError.clear();
    const auto bytes = loadFile(path.toStdString(), largestFile);
    if (!bytes) {
        m_imageError = errorText(bytes.error());
        inspectImage();
        return;
    }
    auto image
        = FirmwareImage::fromIntelHex(std::string_view(bytes->constData(), static_cast<std::size_t>(bytes->size())));
    if (image)
        m_image = std::make_shared<const FirmwareImage>(std::move(*image));
    else
        m_imageError = errorText(image.error());
    inspectImage();
}

void FirmwarePage::inspectImage()
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    m_inspectedFor = m_selection.device();
    m_summary.reset();
    if (m_image && device && device->family->inspect) {
        auto summary = device->family->inspect(*m_image);
        m_imageError = summary ? QString() : errorText(summary.error());
        if (summary)
            m_summary = std::move(*summary);
    }
    m_imageName->setText(m_path.isEmpty() ? tr("no image yet") : QFileInfo(m_path).fileName());
    if (!m_imageError.isEmpty())
        m_imageDetail->setText(m_imageError);
    else if (m_summary)
        m_imageDetail->setText(imageText());
    else
        m_imageDetail->setText(
            m_path.isEmpty() ? tr("Open an Intel HEX file, or drop it here") : tr("select a device to check it"));
    setTone(*m_imageDetail, m_imageError.isEmpty() ? Tone::Dim : Tone::Danger);
    m_map->setParts(
        m_summary ? m_summary->parts : std::vector<int>{}, m_summary ? m_summary->criticalPart : std::nullopt);
    QStringList notes;
    for (const Message &note : m_summary ? m_summary->notes : std::vector<Message>{})
        notes += messageText(note);
    m_notes->setText(notes.join(QLatin1Char('\n')));
    follow();
}

/// Notes say what there is to say of a file without a version.
QString FirmwarePage::imageText() const
{
    if (m_summary->version.empty() && !m_summary->notes.empty())
        return messageText(m_summary->notes.front());
    return tr("version %1 · pages: %2").arg(QString::fromStdString(m_summary->version)).arg(m_summary->parts.size());
}

/// nullptr where it is updated over its own link.
const UpdateRoute *FirmwarePage::routeOf(const DeviceView *device)
{
    return device && !device->family->routes.empty() ? &device->family->routes.front() : nullptr;
}

/// Of the device that is being written, or would be.
UpdateWords FirmwarePage::wordsFor(const OperationView *operation) const
{
    const DeviceView *device = m_workbench.snapshot().device(operation ? operation->device : m_selection.device());
    return device ? updateWords(*device->family) : UpdateWords();
}

void FirmwarePage::followRoute(const DeviceView *device, const OperationView *operation)
{
    m_route->show(device ? device->family : nullptr, m_workbench.listings(), device ? device->link : std::string());
    const UpdateRoute *const route = routeOf(device);
    const bool guided = route && !route->steps.empty();
    m_pagesOfFlash->setVisible(!guided);
    m_steps->setSteps(guided ? route->steps : std::span<const GuidedStep>());
    if (guided)
        m_steps->follow(operation ? &operation->status : nullptr);
}

const OperationView *FirmwarePage::updateOf(const DeviceView *device) const
{
    if (!device)
        return nullptr;
    const auto &all = m_workbench.snapshot().operations;
    for (auto operation = all.rbegin(); operation != all.rend(); ++operation) {
        if (operation->device == device->id && (operation->update || !operation->status.parts.empty()))
            return &*operation;
    }
    return nullptr;
}

/// What is being written is shown until it is over, whatever is selected meanwhile: on the link of the selected device first.
const OperationView *FirmwarePage::shownOperation(const DeviceView *device) const
{
    const Snapshot &shot = m_workbench.snapshot();
    const auto running = runningUpdates(shot);
    const auto own = std::find_if(running.begin(), running.end(),
        [device](const OperationView *operation) { return device && operation->device == device->id; });
    if (own != running.end())
        return *own;
    if (const OperationView *beside = device ? updateOn(shot, device->link) : nullptr)
        return beside;
    return running.empty() ? updateOf(device) : running.front();
}

/// Why nothing can be started, in words; empty when it can.
QString FirmwarePage::hindrance() const
{
    const Snapshot &shot = m_workbench.snapshot();
    const DeviceView *device = shot.device(m_selection.device());
    if (const OperationView *other = device ? updateOn(shot, device->link) : nullptr)
        return tr("One update a bus: %1 is being written.").arg(placeOf(shot, *other));
    return m_route->missing();
}

bool FirmwarePage::canStart() const
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    return device && device->family->update && m_image && m_summary && device->busy.empty() && !device->liveness.moving
        && !device->liveness.foreignMaster && device->identity.state != DeviceState::Duplicate && hindrance().isEmpty();
}

void FirmwarePage::startUpdate()
{
    if (m_inspectedFor != m_selection.device())
        inspectImage();
    if (!canStart())
        return;
    m_workbench.send(orders::UpdateFirmware{m_selection.device(), m_image, m_route->options()});
}

void FirmwarePage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    follow();
}

void FirmwarePage::follow()
{
    if (!isVisible())
        return;
    if (m_inspectedFor != m_selection.device()) {
        inspectImage();
        return;
    }
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    const OperationView *operation = shownOperation(device);
    m_deviceName->setText(device ? titleOf(*device) + QLatin1Char(' ') + QString::fromStdString(device->identity.name)
                                 : tr("no device selected"));
    if (device) {
        const QString now
            = device->identity.firmware.empty() ? tr("none") : QString::fromStdString(device->identity.firmware);
        m_versions->setText(m_summary ? tr("%1 → %2").arg(now,
                                m_summary->version.empty() ? tr("unknown") : QString::fromStdString(m_summary->version))
                                      : now);
    } else {
        m_versions->clear();
    }
    followRoute(device, operation);
    followChecks(device, operation);
    followProgress(operation);
    followLog(operation);
    followSafety(operation);
}

void FirmwarePage::setCheck(const Check &check, bool holds, const QString &text)
{
    check.glyph->setState(holds ? GlyphState::Done : GlyphState::Fault);
    check.text->setText(text);
}

void FirmwarePage::followChecks(const DeviceView *device, const OperationView *operation)
{
    const bool image = m_summary.has_value();
    setCheck(m_checks[0], image, image ? tr("image fits this family") : tr("no usable image"));
    setCheck(m_checks[1], device && !device->liveness.moving,
        device && device->liveness.moving ? tr("motor is moving") : tr("motor stopped"));
    const bool alone = device && !device->liveness.foreignMaster && device->identity.state != DeviceState::Duplicate;
    setCheck(m_checks[2], alone,
        alone        ? tr("no other master, number unique")
            : device ? tr("another master, or a number taken twice")
                     : tr("no device"));
    const auto supply = device ? liveValue(*device, "bus_voltage", m_workbench.now()) : std::nullopt;
    const bool strong = !supply || *supply >= device->family->capabilities.lowestSupply;
    m_checks[3].glyph->setState(!supply ? GlyphState::Assumed : strong ? GlyphState::Done : GlyphState::Warning);
    m_checks[3].text->setText(supply ? tr("bus %1 V").arg(formatNumber(*supply, 1)) : tr("bus voltage not known"));
    const bool running = operation && operation->status.state == OperationStatus::State::Running;
    m_start->setEnabled(canStart() && !running);
    m_start->setToolTip(hindrance());
    m_start->setAccessibleDescription(m_start->toolTip());
    const bool boot = device && device->identity.state == DeviceState::Bootloader;
    m_start->setText(boot ? tr("Run the update again") : tr("Update"));
    m_cancel->setEnabled(running && operation->status.mayInterrupt);
    const UpdateWords words = wordsFor(operation);
    m_cancel->setToolTip(tableText(running && !operation->status.mayInterrupt ? words.critical : words.cancel));
}

QString FirmwarePage::remaining(const OperationStatus &status) const
{
    const double elapsed = std::chrono::duration<double>(m_workbench.now() - status.startedAt).count();
    if (status.done < 2 || status.total == 0)
        return {};
    const double perPage = elapsed / status.done;
    return tr("%1 s a page, about %2 s left")
        .arg(formatNumber(perPage, 2), formatNumber(perPage * (status.total - status.done), 0));
}

QString FirmwarePage::result(const UpdateReport &report, const UpdateWords &words)
{
    switch (report.outcome) {
    case UpdateOutcome::Done: return tr("Verified: %1").arg(messageText(report.summary()));
    case UpdateOutcome::UpToDate: return tr("Not needed: %1").arg(messageText(report.summary()));
    case UpdateOutcome::Refused: return tr("Refused: %1").arg(messageText(report.summary()));
    case UpdateOutcome::Failed: return tr("Failed: %1").arg(messageText(report.summary()));
    case UpdateOutcome::Cancelled: return tr("Cancelled. %1.").arg(tableText(words.cancel));
    }
    return {};
}

void FirmwarePage::followProgress(const OperationView *operation)
{
    if (!operation) {
        m_step->setText(tr("Nothing running"));
        m_rate->clear();
        m_progress->setRange(0, 1);
        m_progress->setValue(0);
        setTone(*m_step, Tone::Dim);
        return;
    }
    const OperationStatus &status = operation->status;
    const bool running = status.state == OperationStatus::State::Running;
    const bool waiting = running && status.total == 0; // for hands, or for an answer
    m_progress->setRange(0, waiting ? 0 : std::max(status.total, 1));
    m_progress->setValue(status.done);
    const bool own = operation->device == m_selection.device();
    m_map->setStates(own ? status.parts : std::map<int, PartState>());
    if (running) {
        const QString where = placeOf(m_workbench.snapshot(), *operation) + QStringLiteral(": ");
        m_step->setText(where
            + (waiting ? messageText(status.step)
                       : tr("%1, %2 of %3 written").arg(messageText(status.step)).arg(status.done).arg(status.total)));
        m_rate->setText(remaining(status));
        setTone(*m_step, Tone::Text);
        return;
    }
    const double seconds = std::chrono::duration<double>(status.endedAt - status.startedAt).count();
    const UpdateReport report = operation->update.value_or(UpdateReport{});
    m_step->setText(result(report, wordsFor(operation)));
    m_rate->setText(tr("%1 s, pages sent again: %2").arg(formatNumber(seconds, 1)).arg(report.retries));
    const bool good = report.outcome == UpdateOutcome::Done || report.outcome == UpdateOutcome::UpToDate;
    setTone(*m_step, good ? Tone::Ok : Tone::Danger);
    if (report.outcome == UpdateOutcome::Done)
        m_progress->setValue(m_progress->maximum());
}

QString FirmwarePage::timeOf(Instant time) const
{
    const auto unixTime
        = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch() + m_workbench.unixOffset());
    return QDateTime::fromMSecsSinceEpoch(unixTime.count()).toString(QStringLiteral("HH:mm:ss.zzz"));
}

void FirmwarePage::followLog(const OperationView *operation)
{
    const OperationId id = operation ? operation->id : OperationId{};
    if (id != m_shownOperation) {
        m_shownOperation = id;
        m_shownLines = 0;
        m_log->setRowCount(0);
    }
    if (!operation)
        return;
    const auto &lines = operation->status.log;
    for (; m_shownLines < lines.size(); ++m_shownLines) {
        const LogLine &line = lines[m_shownLines];
        const int row = m_log->rowCount();
        m_log->insertRow(row);
        auto *time = new QTableWidgetItem(timeOf(line.time));
        time->setForeground(m_theme.theme().dim);
        const GlyphState state = line.severity == Severity::Good ? GlyphState::Done
            : line.severity == Severity::Caution                 ? GlyphState::Warning
            : line.severity == Severity::Danger                  ? GlyphState::Fault
                                                                 : GlyphState::Volatile;
        auto *text = new QTableWidgetItem(glyphIcon(state, m_theme.theme()), messageText(line.text));
        m_log->setItem(row, 0, time);
        m_log->setItem(row, 1, text);
        m_log->scrollToBottom();
    }
}

void FirmwarePage::followSafety(const OperationView *operation)
{
    const bool running = operation && operation->status.state == OperationStatus::State::Running;
    const bool critical = running && !operation->status.mayInterrupt;
    const char *kind = critical ? "danger" : "ok";
    setStyleProperty(*m_safety, "banner", QString::fromLatin1(kind));
    m_safetyTitle->setText(critical ? tr("Do not unplug")
            : running               ? tr("Safe to unplug")
                                    : tr("Nothing is written now"));
    setTone(*m_safetyTitle, critical ? Tone::Danger : Tone::Ok);
    if (running)
        m_safetyTitle->setText(
            m_safetyTitle->text() + QStringLiteral(": ") + placeOf(m_workbench.snapshot(), *operation));
    const UpdateWords words = wordsFor(operation);
    m_safetyText->setText(tableText(critical && !words.fatalCut.empty() ? words.fatalCut : words.cut));
}

void FirmwarePage::askImage()
{
    auto *dialog = new QFileDialog(
        this, tr("Open a firmware image"), QFileInfo(m_path).path(), tr("Intel HEX (*.hex *.ihex);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &FirmwarePage::loadImage);
    dialog->open();
}

void FirmwarePage::askSaveLog()
{
    QString text;
    for (int row = 0; row < m_log->rowCount(); ++row)
        text += m_log->item(row, 0)->text() + QLatin1Char('\t') + m_log->item(row, 1)->text() + QLatin1Char('\n');
    auto *dialog = new QFileDialog(
        this, tr("Save the log of the update"), QStringLiteral("update.log"), tr("Text (*.log *.txt)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    connect(dialog, &QFileDialog::fileSelected, this, [this, text](const QString &path) {
        if (const auto saved = saveFile(path.toStdString(), text.toUtf8()); !saved)
            m_workbench.report(Severity::Danger, {}, errorText(saved.error()));
    });
    dialog->open();
}

void FirmwarePage::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void FirmwarePage::dropEvent(QDropEvent *event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.constFirst().isLocalFile())
        loadImage(urls.constFirst().toLocalFile());
}

} // namespace mb
