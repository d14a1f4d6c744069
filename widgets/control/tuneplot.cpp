// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tuneplot.h"

#include "model/axis.h"
#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/segmented.h"
#include "widgets/common/signal.h"
#include "widgets/common/workbench.h"
#include "widgets/common/wraplayout.h"

#include <QComboBox>
#include <QLineEdit>
#include <QMenu>

#include <array>
#include <cmath>

namespace mb {
namespace {

constexpr std::chrono::milliseconds tickTime{16};
/// A silent device still scrolls away, slowly.
constexpr double idleTime = 0.25;
constexpr std::array windows{5.0, 10.0, 30.0, 60.0};
constexpr int usualWindow = 1;
constexpr double mostCounts = 1e7;
constexpr int leastStack = 240; ///< units, for three strips with their names and the time below them

/// Channels from the top: what is commanded, then what explains it. Boards measure what turns, not what drives it.
std::array<std::string_view, 3> channelsFor(Mode mode, bool ofAxis)
{
    if (ofAxis && (mode == Mode::Position || mode == Mode::RampPosition))
        return {"position", "velocity", "current"};
    if (ofAxis)
        return {"velocity", "position", "current"};
    switch (mode) {
    case Mode::Position:
    case Mode::RampPosition: return {"position", "duty", "current"};
    case Mode::Current: return {"current", "duty", "velocity"};
    case Mode::Duty: return {"duty", "velocity", "current"};
    default: return {"velocity", "duty", "current"};
    }
}

bool hasSetPoint(Mode mode)
{
    return quantityOf(mode) != Quantity::Other && mode != Mode::Voltage;
}

} // namespace

TunePlot::TunePlot(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    m_stack = new PlotStack(theme, this);
    m_stack->setObjectName(QStringLiteral("tuneStack"));
    column->addWidget(buildBar());
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(m_stack, 1);
    m_stack->setMinimumHeight(theme.theme().u(leastStack));
    m_stack->view().setWindow(windows.at(usualWindow));
    m_tick.setTimerType(Qt::PreciseTimer);
    m_tick.setInterval(tickTime);
    connect(&m_tick, &QTimer::timeout, this, &TunePlot::tick);
}

QWidget *TunePlot::buildBar()
{
    const Theme &theme = m_theme.theme();
    auto *bar = new QWidget(this);
    auto *row = new WrapLayout(bar);
    row->setContentsMargins(theme.u(12), theme.u(6), theme.u(12), theme.u(6));
    row->setSpacing(theme.u(8));
    buildUnits(*row);
    row->addSpring();
    buildView(*row);
    return bar;
}

void TunePlot::buildUnits(QLayout &row)
{
    m_unitChoice = new Segmented(tr("Units"), {tr("counts"), tr("rpm")}, this);
    m_counts = new NumberField(this);
    m_counts->setFixedWidth(m_theme.theme().u(72));
    m_counts->setAccessibleName(tr("Counts per revolution"));
    m_counts->setToolTip(tr("Encoder counts of one turn of the shaft, four for each line. Used for rpm, degrees and "
                            "gains in physical units."));
    row.addWidget(m_unitChoice);
    row.addWidget(m_counts);
    row.addWidget(textLabel(tr("counts/rev"), TextRole::Caption, Tone::Dim, this));
    connect(m_unitChoice, &Segmented::currentChanged, this, [this](int choice) {
        m_units.revolutions = choice == 1;
        setUnits(m_units);
        Q_EMIT unitsChanged(m_units);
    });
    connect(m_counts, &QLineEdit::textEdited, this, &TunePlot::countsTyped);
    connect(m_counts, &QLineEdit::editingFinished, this, [this] { setUnits(m_units); });
    setUnits(m_units);
}

void TunePlot::buildView(QLayout &row)
{
    m_window = new QComboBox(this);
    for (const double seconds : windows)
        m_window->addItem(tr("last %1 s").arg(formatNumber(seconds)), seconds);
    m_window->setCurrentIndex(usualWindow);
    m_window->setAccessibleName(tr("Length of the time axis"));
    m_pause = new IconButton(m_theme, Symbol::Pause, tr("Pause the view"), this);
    m_pause->setCheckable(true);
    auto *cursors = new IconButton(m_theme, Symbol::Cursors, tr("Cursors A and B"), this);
    cursors->setCheckable(true);
    cursors->setKeyHint(QStringLiteral("L"));
    auto *fit = new IconButton(m_theme, Symbol::Fit, tr("Fit time and value"), this);
    fit->setKeyHint(QStringLiteral("0"));
    for (QWidget *widget : {static_cast<QWidget *>(m_window), static_cast<QWidget *>(m_pause),
             static_cast<QWidget *>(cursors), static_cast<QWidget *>(fit)})
        row.addWidget(widget);
    connect(m_window, qOverload<int>(&QComboBox::activated), this, [this](int place) {
        m_stack->view().setWindow(windows.at(static_cast<std::size_t>(place)));
        m_stack->view().setLive(true);
    });
    connect(&m_stack->view(), &PlotView::windowChanged, this,
        [this](double seconds) { m_window->setCurrentIndex(m_window->findData(seconds)); });
    connect(m_pause, &QToolButton::toggled, this, [this](bool paused) { m_stack->view().setLive(!paused); });
    connect(&m_stack->view(), &PlotView::liveChanged, m_pause, [this](bool live) { m_pause->setChecked(!live); });
    connect(cursors, &QToolButton::toggled, this, [this](bool shown) { m_stack->setCursorsShown(shown); });
    connect(m_stack, &PlotStack::cursorsChanged, cursors,
        [this, cursors] { cursors->setChecked(m_stack->cursorsShown()); });
    connect(fit, &QToolButton::clicked, m_stack, &PlotStack::fit);
    connect(&m_stack->exporter(), &PlotExport::exported, this,
        [this](const QString &path) { m_workbench.report(Severity::Good, {}, tr("plot written to %1").arg(path)); });
    connect(&m_stack->exporter(), &PlotExport::exportFailed, this,
        [this](const QString &cause) { m_workbench.report(Severity::Danger, {}, cause); });
}

void TunePlot::countsTyped()
{
    const auto counts = parseNumber(m_counts->text());
    const bool legal = counts && *counts > 0.0 && *counts <= mostCounts;
    setStyleProperty(*m_counts, "state", legal ? QString() : QStringLiteral("error"));
    if (!legal)
        return;
    m_units.countsPerRevolution = *counts;
    if (const DeviceView *device = m_workbench.snapshot().device(m_device))
        rebuild(*device);
    Q_EMIT unitsChanged(m_units);
}

void TunePlot::setUnits(const DisplayUnits &units)
{
    m_units = units;
    const QSignalBlocker quiet(m_unitChoice);
    m_unitChoice->setCurrent(units.revolutions ? 1 : 0);
    setStyleProperty(*m_counts, "state", QString());
    m_counts->setText(editText(units.countsPerRevolution));
    if (const DeviceView *device = m_workbench.snapshot().device(m_device))
        rebuild(*device);
}

void TunePlot::choose(const DeviceView &device, Mode mode, int axis, const std::vector<int> &beside)
{
    const Channel *const table = device.telemetry->channels().data();
    if (device.id == m_device && axis == m_axis && mode == m_mode && beside == m_beside
        && device.telemetry == m_telemetry && table == m_table)
        return;
    const auto told = m_told.try_emplace({device.id, axis}, Told{mode, {}}).first;
    if (told->second.mode != mode)
        told->second = {mode, m_workbench.presentOf(device.link)};
    m_since = told->second.since;
    m_device = device.id;
    m_axis = axis;
    m_beside = beside;
    m_mode = mode;
    m_telemetry = device.telemetry;
    m_table = table;
    rebuild(device);
}

QString TunePlot::nameOf(const Channel &row, int axis) const
{
    return m_beside.empty() ? tableText(row.label) : QStringLiteral("ch%1 %2").arg(axis).arg(channelName(row));
}

bool TunePlot::addTrace(const DeviceView &device, std::string_view channel, int strip, bool main, int axis)
{
    const auto index = device.telemetry->find(axisKey(axis, channel));
    if (!index)
        return false;
    const Channel &row = device.telemetry->channels()[index->value]; // whose units may depend on the device
    const ShownUnit unit = shownUnit(row, m_units);
    auto source = std::make_shared<TelemetrySource>(
        device.telemetry, *index, main ? TelemetrySource::Foot::Always : TelemetrySource::Foot::WhenLossy);
    source->setScale(unit.scale);
    m_sources.push_back(source);
    TraceStyle style;
    style.name = nameOf(row, axis);
    style.unit = unit.text;
    style.role = roleOf(row.quantity);
    style.mostDecimals = mostDecimals(row.quantity, unit);
    if (!m_beside.empty())
        style.colour = axisColour(axis);
    style.strip = strip;
    m_stack->strips().addTrace(style, source);
    if (row.quantity == quantityOf(m_mode))
        addSetPoint(device, strip, unit, axis);
    return true;
}

void TunePlot::addSetPoint(const DeviceView &device, int strip, const ShownUnit &unit, int axis)
{
    const auto setPoint = device.telemetry->find(axisKey(axis, "setpoint"));
    if (!setPoint || !hasSetPoint(m_mode))
        return;
    auto wished = std::make_shared<TelemetrySource>(device.telemetry, *setPoint, TelemetrySource::Foot::Never);
    wished->setScale(unit.scale);
    wished->setSince(m_since);
    m_sources.push_back(wished);
    TraceStyle style;
    style.unit = unit.text;
    style.strip = strip;
    style.name = m_beside.empty() ? tr("Set-point") : tr("ch%1 set-point").arg(axis);
    style.role = TraceRole::Setpoint;
    m_stack->strips().addTrace(style, wished);
}

void TunePlot::rebuild(const DeviceView &device)
{
    m_stack->strips().clear();
    m_sources.clear();
    int strip = 0;
    for (const std::string_view channel : channelsFor(m_mode, m_axis > 0)) {
        const bool there = addTrace(device, channel, strip, strip == 0, m_axis);
        for (const int axis : there ? m_beside : std::vector<int>())
            addTrace(device, channel, strip, false, axis);
        strip += there ? 1 : 0; // no empty pane for what this device cannot tell
    }
    if (m_axis > 0 && m_mode == Mode::Duty) // which is not measured
        addSetPoint(device, strip++, shownUnit(Mode::Duty, m_units), m_axis);
    for (int i = 0; i < strip; ++i) {
        StripStyle style;
        style.stretch = i == 0 ? 2.4 : 1.0;
        m_stack->strips().setStrip(i, style);
    }
    const LinkView *link = m_workbench.snapshot().link(device.link);
    m_stack->strips().setWatermark(link && link->simulated ? tr("DEMO") : QString());
    follow(device);
    m_drawn = 0;
    m_drawnAt = 0.0;
    draw();
}

void TunePlot::follow(const DeviceView &device)
{
    m_stack->strips().times().setClock(m_workbench.wallClock(device.link));
    for (const auto &source : m_sources) {
        const std::size_t place = source->channel().value;
        source->follow(place < device.rates.size() ? device.rates[place] : 0.0, m_workbench.presentOf(device.link));
    }
}

void TunePlot::tick()
{
    if (m_stack->budget().isDue())
        draw();
}

void TunePlot::draw()
{
    if (!m_telemetry)
        return;
    const DeviceView *device = m_workbench.snapshot().device(m_device);
    const double now = plotKey(device ? m_workbench.presentOf(device->link) : m_workbench.now());
    const std::uint64_t revision = m_telemetry->revision();
    if (revision == m_drawn && std::abs(now - m_drawnAt) < idleTime)
        return;
    m_drawn = revision;
    m_drawnAt = now;
    m_stack->refresh(now);
}

void TunePlot::hideEvent(QHideEvent *event)
{
    m_tick.stop();
    QWidget::hideEvent(event);
}

} // namespace mb
