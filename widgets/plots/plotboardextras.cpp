// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/devicetext.h"
#include "widgets/plots/plotboard.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::size_t advanceMost = 20'000; ///< samples of derived signals in one tick: about 3 ms
constexpr double referenceSpan = 1.0;       ///< windows beside what is seen that are kept, too
constexpr std::size_t mostNotes = 1000;

QString variableName(const DeviceView &device, ChannelIndex channel)
{
    QString key = qt(device.family->channels[channel.value].key);
    key.replace(QLatin1Char('.'), QLatin1Char('_'));
    return QStringLiteral("d%1_%2").arg(device.identity.address).arg(key);
}

} // namespace

std::vector<PlotBoard::Variable> PlotBoard::variables() const
{
    std::vector<Variable> all;
    const auto isTaken = [&all](const QString &name) {
        return std::any_of(all.begin(), all.end(), [&](const Variable &variable) { return variable.name == name; });
    };
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        if (device.identity.state == DeviceState::Bootloader)
            continue;
        for (std::uint16_t i = 0; i < device.family->channels.size(); ++i) {
            QString name = variableName(device, {i});
            if (isTaken(name)) // the same number on another link
                name += QStringLiteral("_%1").arg(device.id.value);
            all.push_back({name, {device.id, {i}}});
        }
    }
    return all;
}

void PlotBoard::compile(Derived &derived)
{
    const auto all = variables();
    std::vector<std::string> names;
    for (const Variable &variable : all)
        names.push_back(variable.name.toStdString());
    auto expression = Expression::parse(derived.formula.toStdString(), names);
    if (!expression)
        return;
    std::vector<DerivedSignal::Input> inputs;
    derived.inputs.clear();
    for (const std::size_t used : expression->used()) {
        inputs.push_back({telemetryOf(all[used].signal), all[used].signal.channel});
        derived.inputs.push_back(all[used].signal);
    }
    derived.signal = std::make_shared<DerivedSignal>(
        derived.name.toStdString(), derived.unit.toStdString(), std::move(*expression), inputs);
}

std::vector<Signal> PlotBoard::ingredients() const
{
    std::vector<Signal> all;
    for (const Trace &trace : m_traces) {
        if (trace.signal.device != derivedDevice || trace.signal.channel.value >= m_derived.size())
            continue;
        const auto &inputs = m_derived[trace.signal.channel.value].inputs;
        all.insert(all.end(), inputs.begin(), inputs.end());
    }
    return all;
}

QString PlotBoard::whatIsWrong(const QString &name, const QString &formula) const
{
    const QString wanted = name.trimmed();
    if (wanted.isEmpty())
        return tr("The signal needs a name.");
    for (const Derived &derived : m_derived) {
        if (derived.name == wanted)
            return tr("There is a derived signal of this name.");
    }
    std::vector<std::string> names;
    for (const Variable &variable : variables())
        names.push_back(variable.name.toStdString());
    const auto expression = Expression::parse(formula.toStdString(), names);
    return expression ? QString() : qt(expression.error().text());
}

void PlotBoard::ensureDerived(const QString &name, const QString &unit, const QString &formula)
{
    const bool known
        = std::any_of(m_derived.begin(), m_derived.end(), [&](const Derived &derived) { return derived.name == name; });
    if (known || name.isEmpty())
        return;
    m_derived.push_back({name, unit, formula});
    compile(m_derived.back());
}

Result<void> PlotBoard::addDerived(const QString &name, const QString &unit, const QString &formula)
{
    if (const QString wrong = whatIsWrong(name, formula); !wrong.isEmpty())
        return fail(Fault::OutOfRange, Message::verbatim(wrong.toStdString()));
    m_derived.push_back({name.trimmed(), unit.trimmed(), formula.trimmed()});
    compile(m_derived.back());
    choose({derivedDevice, {static_cast<std::uint16_t>(m_derived.size() - 1)}}, true);
    return {};
}

/// Places of the others stay, so that traces keep their signal.
void PlotBoard::removeDerived(int place)
{
    if (place < 0 || static_cast<std::size_t>(place) >= m_derived.size())
        return;
    choose({derivedDevice, {static_cast<std::uint16_t>(place)}}, false);
    m_derived[static_cast<std::size_t>(place)] = {};
    Q_EMIT changed();
}

void PlotBoard::advance()
{
    for (const Derived &derived : m_derived) {
        if (derived.signal)
            derived.signal->advance(advanceMost);
    }
}

void PlotBoard::keepReferences()
{
    const auto [from, to] = m_stack.view().range();
    const double origin = m_stack.view().heldKey().value_or(from);
    const double beside = (to - from) * referenceSpan;
    for (const Trace &trace : m_traces) {
        if (trace.style.role == TraceRole::Setpoint)
            continue;
        std::vector<PlotPoint> points;
        trace.source->columns(from - beside, to + beside, 30'000, points);
        for (PlotPoint &point : points)
            point.key -= origin;
        Reference reference;
        reference.style = trace.style;
        reference.style.name = tr("ref %1").arg(trace.style.name);
        reference.style.dash = TraceDash::Long;
        reference.style.marker = TraceMarker::HollowSquare;
        reference.style.valueTag = false;
        reference.style.aligned = true;
        reference.pane = trace.pane;
        reference.trace = std::make_shared<FixedTrace>(std::move(points));
        m_references.push_back(std::move(reference));
    }
    rebuild();
}

void PlotBoard::clearReferences()
{
    m_references.clear();
    rebuild();
}

void PlotBoard::addNote(double key, const QString &text)
{
    if (text.trimmed().isEmpty() || m_notes.size() >= mostNotes)
        return;
    const Instant time(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(key)));
    m_notes.push_back({time, text.trimmed().toStdString()});
    std::vector<PlotMark> marks;
    for (const TimedNote &note : m_notes)
        marks.push_back({plotKey(note.time), QString::fromStdString(note.text)});
    m_stack.strips().setMarks(std::move(marks));
}

std::vector<ExportChannel> PlotBoard::exportChannels(bool everything) const
{
    std::vector<ExportChannel> channels;
    const auto isSimulated = [this](const DeviceView &device) {
        const LinkView *link = m_workbench.snapshot().link(device.link);
        return link && link->simulated;
    };
    const auto addDerivedOne = [&](const Derived &derived) {
        channels.push_back({derived.signal->telemetry(), {0}, {}, {}, derived.name.toStdString(),
            derived.unit.toStdString(), derived.formula.toStdString(), false});
    };
    if (everything) {
        for (const DeviceView &device : m_workbench.snapshot().devices) {
            const auto all = channelsOf(device, isSimulated(device));
            channels.insert(channels.end(), all.begin(), all.end());
        }
        for (const Derived &derived : m_derived) {
            if (derived.signal)
                addDerivedOne(derived);
        }
        return channels;
    }
    for (const Trace &trace : m_traces) {
        const DeviceView *device = m_workbench.snapshot().device(trace.signal.device);
        if (device)
            channels.push_back(channelsOf(*device, isSimulated(*device)).at(trace.signal.channel.value));
        else
            addDerivedOne(m_derived[trace.signal.channel.value]);
    }
    return channels;
}

std::vector<std::pair<std::string, mcap::Map>> PlotBoard::about() const
{
    std::vector<std::pair<std::string, mcap::Map>> facts;
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        auto described = describe(device);
        std::move(described.begin(), described.end(), std::back_inserter(facts));
    }
    return facts;
}

} // namespace mb
