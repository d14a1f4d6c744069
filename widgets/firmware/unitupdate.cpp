// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/unitupdate.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/livetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/turningsplitter.h"
#include "widgets/common/updates.h"
#include "widgets/common/wraplayout.h"
#include "widgets/firmware/pagemap.h"
#include "widgets/firmware/queuechecks.h"
#include "widgets/firmware/routepanel.h"
#include "widgets/firmware/stepspanel.h"
#include "widgets/firmware/updatelog.h"
#include "widgets/firmware/updateside.h"

#include <QFileInfo>
#include <QProgressBar>

namespace mb {
namespace {

constexpr int updateBesideFrom = 660; ///< units
constexpr int leastDetail = 120;
constexpr int leastProgress = 220;

enum Check { ImageCheck, StandCheck, AloneCheck, SupplyCheck, Checks };

/// nullptr where it is updated over its own link.
const UpdateRoute *routeOf(const DeviceView *device)
{
    return device && !device->family->routes.empty() ? &device->family->routes.front() : nullptr;
}

std::optional<OperationView> updateOf(const Snapshot &shot, const DeviceView *device)
{
    const auto found = std::find_if(shot.operations.rbegin(), shot.operations.rend(), [&](const OperationView &one) {
        return device && one.device == device->id && (one.update || !one.status.parts.empty());
    });
    return found == shot.operations.rend() ? std::nullopt : std::optional(*found);
}

/// What the unit is left as, as far as it is known.
QString cancelledText(const UpdateReport &report, const UpdateWords &words, bool touched)
{
    if (!report.remedy.empty())
        return UnitUpdate::tr("Cancelled: %1").arg(messageText(report.summary()));
    return touched ? UnitUpdate::tr("Cancelled. %1.").arg(leftAfter(report.pages, words))
                   : UnitUpdate::tr("Cancelled: nothing was written.");
}

/// What came of an update, and how good that is.
std::pair<QString, Tone> endingOf(const UpdateReport &report, const UpdateWords &words, bool touched)
{
    const QString summary = messageText(report.summary());
    switch (report.outcome) {
    case UpdateOutcome::Done:
        return report.verified ? std::pair(UnitUpdate::tr("Verified: %1").arg(summary), Tone::Ok)
                               : std::pair(UnitUpdate::tr("Written, not proved: %1").arg(summary), Tone::Caution);
    case UpdateOutcome::UpToDate: return {UnitUpdate::tr("Not needed: %1").arg(summary), Tone::Ok};
    case UpdateOutcome::Refused: return {UnitUpdate::tr("Refused: %1").arg(summary), Tone::Danger};
    case UpdateOutcome::Failed: return {UnitUpdate::tr("Failed: %1").arg(summary), Tone::Danger};
    case UpdateOutcome::Cancelled: return {cancelledText(report, words, touched), Tone::Danger};
    }
    return {};
}

bool isRunning(const OperationView *operation)
{
    return operation && operation->status.state == OperationStatus::State::Running;
}

/// Its estimate and its cancel are beside the queue.
bool isOfQueue(const OperationView &operation)
{
    return operation.id == OperationId{};
}

} // namespace

UnitUpdate::UnitUpdate(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : LeastHeight(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    buildImage(*column);
    column->addWidget(m_route = new RoutePanel(theme, this));
    column->addWidget(m_checks = new CheckRow(theme, tr("Before start"), Checks, this));
    buildProgress(*column);
    buildBody(*column);
    connect(m_route, &RoutePanel::changed, this, &UnitUpdate::follow);
    connect(&workbench, &Workbench::changed, this, &UnitUpdate::follow);
    connect(&theme, &ThemeSource::changed, this, [this] {
        m_shownOperation = {}; // the lines of the log have colours of their own
        follow();
    });
    connect(&selection, &Selection::changed, this, &UnitUpdate::follow);
    inspectImage();
}

void UnitUpdate::buildImage(QVBoxLayout &column)
{
    const Theme &theme = m_theme.theme();
    auto *row = new WrapLayout;
    row->setContentsMargins(theme.u(16), theme.u(10), theme.u(16), theme.u(10));
    row->setSpacing(theme.u(24));
    row->setLineSpacing(theme.u(4));
    const auto pair = [&](const QString &caption, QLabel *&value) {
        auto *box = new QWidget(this);
        auto *lines = layoutIn<QVBoxLayout>(box, 0);
        lines->addWidget(textLabel(caption, TextRole::Caption, Tone::Dim, box));
        value = textLabel({}, TextRole::Emphasis, Tone::Text, box);
        lines->addWidget(value);
        row->addWidget(box);
    };
    pair(tr("device"), m_deviceName);
    pair(tr("firmware"), m_versions);
    pair(tr("image"), m_imageName);
    m_imageDetail = new ElidedLabel({}, this);
    m_imageDetail->setMinimumWidth(theme.u(leastDetail));
    row->setStretched(m_imageDetail);
    row->addWidget(m_imageDetail);
    row->addSpring();
    auto *open = new CommandButton(m_theme, Symbol::Folder, tr("Open image…"), this);
    row->addWidget(open);
    column.addLayout(row);
    column.addWidget(separatorLine(Qt::Horizontal, this));
    connect(open, &QPushButton::clicked, this, &UnitUpdate::askImage);
}

void UnitUpdate::buildProgress(QVBoxLayout &column)
{
    const Theme &theme = m_theme.theme();
    auto *orders = new QWidget(this);
    auto *part = layoutIn<QVBoxLayout>(orders, 0);
    m_step = textLabel({}, TextRole::Body, Tone::Text, orders);
    m_step->setAccessibleName(tr("Step"));
    m_step->setWordWrap(true); // it may be a cause
    m_step->setContentsMargins(theme.u(16), theme.u(8), theme.u(16), 0);
    part->addWidget(m_step);
    auto *row = new WrapLayout;
    row->setContentsMargins(theme.u(16), theme.u(4), theme.u(16), theme.u(10));
    row->setSpacing(theme.u(12));
    auto *box = new QWidget(orders);
    box->setMinimumWidth(theme.u(leastProgress));
    auto *lines = layoutIn<QVBoxLayout>(box);
    m_rate = textLabel({}, TextRole::Body, Tone::Dim, box);
    m_progress = new QProgressBar(box);
    m_progress->setAccessibleName(tr("Progress of the update"));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(theme.u(8));
    lines->addWidget(m_rate);
    lines->addWidget(m_progress);
    row->setStretched(box);
    row->addWidget(box);
    m_cancel = new CommandButton(m_theme, Symbol::Close, tr("Cancel"), orders);
    m_start = new CommandButton(m_theme, Symbol::Play, tr("Update"), orders);
    m_start->setTextVariants({tr("Update"), tr("Run the update again")});
    m_start->setKeyHint(QStringLiteral("F5"));
    m_start->setPrimary(true);
    row->addWidget(m_cancel);
    row->addWidget(m_start);
    part->addLayout(row);
    part->addWidget(separatorLine(Qt::Horizontal, orders));
    column.addWidget(orders);
    connect(m_start, &QPushButton::clicked, this, &UnitUpdate::start);
    connect(
        m_cancel, &QPushButton::clicked, this, [this] { m_workbench.send(orders::CancelOperation{m_shownOperation}); });
}

/// Where little is in sight at once, what starts the update comes before what it starts with.
void UnitUpdate::resizeEvent(QResizeEvent *event)
{
    LeastHeight::resizeEvent(event);
    auto *column = static_cast<QVBoxLayout *>(layout());
    QWidget *const orders = m_start->parentWidget();
    const bool first = width() < m_theme.theme().u(updateBesideFrom);
    if ((column->indexOf(orders) == 0) == first)
        return;
    column->removeWidget(orders);
    column->insertWidget(first ? 0 : column->indexOf(m_checks) + 1, orders);
    m_side->placeSafety(first ? static_cast<QVBoxLayout *>(orders->layout()) : nullptr);
}

void UnitUpdate::buildBody(QVBoxLayout &column)
{
    auto *split = new TurningSplitter(m_theme, updateBesideFrom, this);
    split->addWidget(m_log = new UpdateLog(m_workbench, m_theme, split));
    split->addWidget(m_side = new UpdateSide(m_theme, split));
    split->setStretchFactor(0, 1);
    split->setSizes({m_theme.theme().u(800), m_theme.theme().u(340)});
    column.addWidget(split, 1);
}

void UnitUpdate::loadImage(const QString &path)
{
    m_image.load(path);
    if (const auto &known = m_workbench.snapshot().operations; !known.empty())
        m_lastOfOthers = known.back().id;
    inspectImage();
}

void UnitUpdate::inspectImage()
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    if (m_inspectedFor != m_selection.device())
        m_route->keepSettings();
    m_inspectedFor = m_selection.device();
    m_image.check(device ? device->family : nullptr);
    m_imageName->setText(m_image.name());
    m_imageDetail->setText(m_image.detail());
    setTone(*m_imageDetail, m_image.isBad() ? Tone::Danger : Tone::Dim);
    const auto &summary = m_image.summary();
    m_side->map().setParts(
        summary ? summary->parts : std::vector<int>{}, summary ? summary->criticalPart : std::nullopt);
    m_side->setNotes(m_image.notes());
    follow();
}

/// Of the device that is being written, or would be.
UpdateWords UnitUpdate::wordsFor(const OperationView *operation) const
{
    const DeviceView *device = m_workbench.snapshot().device(operation ? operation->device : m_selection.device());
    return device ? updateWords(*device->family) : UpdateWords();
}

void UnitUpdate::followRoute(const DeviceView *device, const OperationView *operation)
{
    m_route->show(device ? device->family : nullptr, m_workbench.listings(), device ? device->link : std::string());
    const UpdateRoute *const route = routeOf(device);
    const bool guided = route && !route->steps.empty();
    m_side->setGuided(guided);
    m_side->steps().setSteps(guided ? route->steps : std::span<const GuidedStep>());
    if (guided) // parts of another unit's update are no steps
        m_side->steps().follow(operation && operation->device == m_selection.device() ? &operation->status : nullptr);
}

/// What is being written is shown until it is over, whatever is selected meanwhile: on the link of the selected device first.
std::optional<OperationView> UnitUpdate::shownOperation(const DeviceView *device) const
{
    const Snapshot &shot = m_workbench.snapshot();
    const auto running = runningUpdates(m_workbench);
    if (running.empty())
        return updateOf(shot, device);
    return *std::ranges::min_element(running, {}, [&](const OperationView &update) {
        const DeviceView *unit = shot.device(update.device);
        return !device || !unit ? 2 : unit == device ? 0 : unit->link == device->link ? 1 : 2;
    });
}

/// Why nothing can be started, in words; empty when it can.
QString UnitUpdate::hindrance() const
{
    const Snapshot &shot = m_workbench.snapshot();
    const DeviceView *device = shot.device(m_selection.device());
    if (const auto other = device ? updateOn(m_workbench, device->link) : std::nullopt)
        return tr("One update a bus: %1 is being written.").arg(placeOf(shot, *other));
    if (device && isServed(m_workbench, device->link))
        return tr("Units are served on this link.");
    return m_route->missing();
}

bool UnitUpdate::canStart() const
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    return device && device->family->update && m_image.image() && m_image.summary() && device->busy.empty()
        && !device->liveness.moving && !device->liveness.foreignMaster
        && device->identity->state != DeviceState::Duplicate && hindrance().isEmpty();
}

void UnitUpdate::start()
{
    if (m_inspectedFor != m_selection.device())
        inspectImage();
    if (!canStart())
        return;
    if (m_image.isReplaced()) { // nobody has looked at what would be written
        loadImage(m_image.path());
        m_workbench.report(Severity::Caution, {},
            tr("%1 has changed since it was opened and is read again; start the update once more").arg(m_image.name()));
        return;
    }
    m_workbench.send(orders::UpdateFirmware{m_selection.device(), m_image.image(), m_route->options()});
    m_route->keepSettings();
}

void UnitUpdate::showEvent(QShowEvent *event)
{
    LeastHeight::showEvent(event);
    follow();
}

void UnitUpdate::follow()
{
    if (!isVisible())
        return;
    if (m_inspectedFor != m_selection.device()) {
        inspectImage();
        return;
    }
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    const auto shown = shownOperation(device);
    const OperationView *const operation = shown ? &*shown : nullptr;
    followDevice(device);
    followRoute(device, operation);
    followChecks(device);
    followOrders(device, operation);
    followProgress(operation);
    followLog(operation);
    followSafety(operation);
}

void UnitUpdate::followDevice(const DeviceView *device)
{
    m_deviceName->setText(
        device ? (titleOf(*device) + QLatin1Char(' ') + givenName(*device)).trimmed() : tr("no device selected"));
    if (!device)
        return m_versions->clear();
    const QString now
        = device->identity->firmware.empty() ? tr("none") : QString::fromStdString(device->identity->firmware);
    const bool asInImage = m_image.summary() && m_image.version() == now;
    m_versions->setText(!m_image.summary() ? now
            : asInImage                    ? tr("%1, as in the image").arg(now)
                                           : tr("%1 → %2").arg(now, m_image.version()));
    m_start->setPrimary(!asInImage); // what is done needs no hand
}

void UnitUpdate::followChecks(const DeviceView *device)
{
    const bool image = m_image.summary().has_value();
    m_checks->set(ImageCheck, image, image ? tr("image fits this family") : tr("no usable image"));
    if (device)
        m_checks->set(StandCheck, !device->liveness.moving,
            device->liveness.moving ? tr("motor is moving") : tr("motor stopped"));
    else
        m_checks->set(StandCheck, GlyphState::Assumed, tr("motor not known"));
    const bool alone = device && !device->liveness.foreignMaster && device->identity->state != DeviceState::Duplicate;
    m_checks->set(AloneCheck, alone,
        alone        ? tr("no other master, number unique")
            : device ? tr("another master, or a number taken twice")
                     : tr("no device"));
    const auto supply = device ? liveValue(*device, "bus_voltage", m_workbench.now()) : std::nullopt;
    setSupply(*m_checks, SupplyCheck, supply, supply && *supply >= device->family->capabilities.lowestSupply);
}

void UnitUpdate::followOrders(const DeviceView *device, const OperationView *operation)
{
    const bool running = isRunning(operation);
    const bool queued = running && isOfQueue(*operation); // which does not tell how much it has written
    m_start->setEnabled(canStart());
    m_start->setToolTip(hindrance());
    m_start->setAccessibleDescription(m_start->toolTip());
    const bool boot = device && device->identity->state == DeviceState::Bootloader;
    m_start->setText(boot ? tr("Run the update again") : tr("Update"));
    m_cancel->setEnabled(running && operation->status.mayInterrupt && !queued);
    const UpdateWords words = wordsFor(operation);
    m_cancel->setToolTip(running && !operation->status.mayInterrupt ? tableText(words.critical)
            : queued                                                ? QString()
                     : leftAfter(running ? operation->status.update.pages : 0, words));
}

QString UnitUpdate::remaining(const OperationStatus &status) const
{
    const double elapsed = std::chrono::duration<double>(m_workbench.now() - status.startedAt).count();
    if (status.done < 2 || status.total == 0)
        return {};
    const double perPage = elapsed / status.done;
    return tr("%1 s a page, about %2 s left")
        .arg(formatNumber(perPage, 2), formatNumber(perPage * (status.total - status.done), 0));
}

void UnitUpdate::followProgress(const OperationView *operation)
{
    if (!operation) {
        m_step->setText(tr("Nothing running"));
        m_rate->clear();
        m_progress->setRange(0, 1);
        m_progress->setValue(0);
        setTone(*m_progress, Tone::Text);
        setTone(*m_step, Tone::Dim);
        return;
    }
    const OperationStatus &status = operation->status;
    const bool running = isRunning(operation);
    const bool waiting = running && status.total == 0; // for hands, or for an answer
    m_progress->setRange(0, waiting ? 0 : std::max(status.total, 1));
    m_progress->setValue(status.done);
    const bool own = operation->device == m_selection.device();
    const bool isOfImage = own && operation->id > m_lastOfOthers;
    m_side->map().setStates(isOfImage ? status.parts : std::map<int, PartState>());
    if (!running)
        return showEnd(*operation);
    const QString where = placeOf(m_workbench.snapshot(), *operation) + QStringLiteral(": ");
    m_step->setText(where
        + (waiting ? messageText(status.step)
                   : tr("%1, %2 of %3 written").arg(messageText(status.step)).arg(status.done).arg(status.total)));
    m_rate->setText(isOfQueue(*operation) ? QString() : remaining(status));
    setTone(*m_progress, Tone::Text);
    setTone(*m_step, Tone::Text);
}

void UnitUpdate::showEnd(const OperationView &operation)
{
    const OperationStatus &status = operation.status;
    const double seconds = std::chrono::duration<double>(status.endedAt - status.startedAt).count();
    const UpdateReport report = operation.update.value_or(UpdateReport{});
    const DeviceView *const unit = m_workbench.snapshot().device(operation.device);
    const bool touched = report.pages > 0 || !unit
        || unit->identity->state == DeviceState::Bootloader; // it may have entered it for this
    const auto [text, tone] = endingOf(report, wordsFor(&operation), touched);
    m_step->setText(text);
    setTone(*m_step, tone);
    setTone(*m_progress, tone);
    m_rate->setText(tr("%1 s, pages sent again: %2").arg(formatNumber(seconds, 1)).arg(report.retries));
    if (report.outcome == UpdateOutcome::Done)
        m_progress->setValue(m_progress->maximum());
}

void UnitUpdate::followLog(const OperationView *operation)
{
    const OperationId id = operation ? operation->id : OperationId{};
    if (id != m_shownOperation) {
        m_shownOperation = id;
        m_log->clear();
    }
    if (!operation)
        return;
    const auto &lines = operation->status.log;
    for (auto i = static_cast<std::size_t>(m_log->count()); i < lines.size(); ++i)
        m_log->add(lines[i]);
}

void UnitUpdate::followSafety(const OperationView *operation)
{
    using Safety = UpdateSide::Safety;
    const bool running = isRunning(operation);
    const Safety safety = !running       ? Safety::Nothing
        : operation->status.mayInterrupt ? Safety::MayCut
                                         : Safety::MustNotCut;
    const DeviceView *const unit = operation ? m_workbench.snapshot().device(operation->device) : nullptr;
    const bool isWhole = operation && operation->update
        && (operation->update->outcome == UpdateOutcome::Done || operation->update->outcome == UpdateOutcome::UpToDate);
    const bool told = running || (isWhole && unit && !unit->liveness.moving);
    m_side->showSafety(safety, told ? placeOf(m_workbench.snapshot(), *operation) : QString(), wordsFor(operation));
}

void UnitUpdate::askImage()
{
    askForFile(*this, tr("Open a firmware image"), tr("Intel HEX (*.hex *.ihex);;All files (*)"),
        QFileInfo(m_image.path()).path(), [this](const QString &path) { loadImage(path); });
}

} // namespace mb
