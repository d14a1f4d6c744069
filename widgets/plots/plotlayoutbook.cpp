// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotlayoutbook.h"

#include "widgets/common/devicetext.h"
#include "widgets/plots/plotdialogs.h"

#include <QMenu>

#include <utility>

namespace mb {
namespace {

constexpr std::chrono::milliseconds rememberAfter{1000};
constexpr double firstWindow = 10.0; ///< seconds

} // namespace

PlotLayoutBook::PlotLayoutBook(Workbench &workbench, Selection &selection, PlotStack &stack, PlotBoard &board)
    : m_workbench(workbench)
    , m_selection(selection)
    , m_stack(stack)
    , m_board(board)
{
    stack.view().setWindow(firstWindow);
    m_remember.setSingleShot(true);
    m_remember.setInterval(rememberAfter);
    connect(&m_remember, &QTimer::timeout, this, &PlotLayoutBook::save);
    connect(&stack.view(), &PlotView::windowChanged, this, &PlotLayoutBook::remember);
}

PlotLayoutBook::~PlotLayoutBook()
{
    finish();
}

void PlotLayoutBook::finish()
{
    if (m_remember.isActive())
        save();
    m_disk.finish();
}

void PlotLayoutBook::setFolder(const QString &folder)
{
    m_layouts = PlotLayouts(folder);
    m_ordered.clear();
    m_defaultsOf = {};
    if (const auto last = load(PlotLayouts::lastName()))
        apply(*last);
}

void PlotLayoutBook::save()
{
    m_remember.stop();
    if (m_layouts.remembers() && m_board.isTouched())
        keep(PlotLayouts::lastName(), current());
}

Result<PlotLayout> PlotLayoutBook::load(const QString &name) const
{
    const auto ordered = m_ordered.find(name);
    if (ordered == m_ordered.end())
        return m_layouts.load(name);
    return ordered->second ? Result<PlotLayout>(*ordered->second) : PlotLayouts().load(name);
}

void PlotLayoutBook::keep(const QString &name, const std::optional<PlotLayout> &layout)
{
    m_ordered[name] = layout;
    m_disk.order(
        name,
        [layouts = m_layouts, name, layout] {
            if (layout)
                return layouts.save(name, *layout);
            layouts.remove(name);
            return Result<void>();
        },
        [this, name, layout](const Result<void> &saved) {
            if (const auto ordered = m_ordered.find(name); ordered != m_ordered.end() && ordered->second == layout)
                m_ordered.erase(ordered); // else something newer waits
            const bool told = layout && name == PlotLayouts::lastName() && std::exchange(m_unsaved, !saved);
            if (!saved && !told)
                m_workbench.report(Severity::Danger, {}, errorText(saved.error()));
        });
}

void PlotLayoutBook::follow()
{
    if (!m_board.isTouched())
        takeDefaults();
}

/// The recordings go on whether or not they are shown, so a change of selection loses nothing.
void PlotLayoutBook::takeDefaults()
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    const int axis = m_selection.axis();
    const bool same = device && device->id == m_defaultsOf && axis == m_defaultsOfAxis;
    if (!device || same || device->identity->state == DeviceState::Bootloader)
        return;
    m_defaultsOf = device->id;
    m_defaultsOfAxis = axis;
    if (const auto own = load(PlotLayouts::familyName(qt(device->family->key))); own && axis == 0) {
        m_stack.view().setWindow(own->window);
        return m_board.setTraces(tracesOf(*own, device->id), false);
    }
    std::vector<PlotBoard::Trace> traces;
    for (const Signal &signal : usualSignals(*device, axis))
        traces.push_back({signal, {}});
    m_board.setTraces(std::move(traces), false);
}

PlotLayout PlotLayoutBook::current() const
{
    PlotLayout layout;
    layout.window = m_stack.view().window();
    for (const SignalBook::Derived &derived : m_board.book().derived()) {
        if (derived.name.isEmpty())
            continue;
        layout.derived.push_back({derived.name, derived.unit, derived.formula});
        for (const SignalBook::Meaning &meaning : derived.meanings)
            layout.derived.back().meanings.push_back(
                {meaning.name, qt(meaning.address.device), qt(meaning.address.key)});
    }
    for (const PlotBoard::Trace *trace : m_board.wished())
        layout.traces.push_back({qt(trace->address.device), qt(trace->address.key), trace->pane, trace->second});
    return layout;
}

/// `standIn`: the device that "*" means.
std::vector<PlotBoard::Trace> PlotLayoutBook::tracesOf(const PlotLayout &layout, DeviceId standIn) const
{
    const DeviceView *meant = m_workbench.snapshot().device(standIn);
    std::vector<PlotBoard::Trace> traces;
    for (const PlotLayout::Trace &wanted : layout.traces) {
        SignalAddress address{wanted.device.toStdString(), wanted.key.toStdString()};
        if (address.device == "*") {
            if (!meant)
                continue;
            address.device = meant->selector;
        }
        const auto signal = m_board.book().find(address);
        traces.push_back({signal.value_or(Signal{}), wanted.pane, wanted.second, address});
    }
    return traces;
}

void PlotLayoutBook::apply(const PlotLayout &layout)
{
    m_stack.view().setWindow(layout.window);
    for (const PlotLayout::Derived &derived : layout.derived) {
        std::vector<SignalBook::Meaning> meanings;
        for (const PlotLayout::Meaning &meaning : derived.meanings)
            meanings.push_back({meaning.name, {meaning.device.toStdString(), meaning.key.toStdString()}});
        m_board.book().ensure(derived.name, derived.unit, derived.formula, std::move(meanings));
    }
    m_board.setTraces(tracesOf(layout, m_selection.device()), true);
}

void PlotLayoutBook::reset()
{
    m_defaultsOf = {};
    keep(PlotLayouts::lastName(), std::nullopt);
    m_stack.view().setWindow(firstWindow);
    m_stack.view().setLive(true);
    m_board.reset();
    Q_EMIT wasReset();
    m_remember.stop();
}

void PlotLayoutBook::fillMenu(QMenu &menu, QWidget &parent)
{
    const auto saveAs = [this, &parent] {
        askName(parent, tr("Save layout"), {},
            [this](const QString &name) { keep(name.trimmed().remove(QLatin1Char('@')), current()); });
    };
    menu.addAction(tr("Save layout as…"), this, saveAs)->setEnabled(m_layouts.remembers());
    addFamilyEntries(menu);
    menu.addAction(tr("Reset"), this, &PlotLayoutBook::reset);
    QStringList names = m_layouts.names();
    for (const auto &[name, layout] : m_ordered) { // what was saved a moment ago is offered, too
        if (!PlotLayouts::isOwn(name) && !names.contains(name))
            names << name;
    }
    names.sort(Qt::CaseInsensitive);
    if (!names.isEmpty())
        menu.addSeparator();
    for (const QString &name : names)
        menu.addAction(name, this, [this, name] {
            if (const auto layout = load(name); layout)
                apply(*layout);
            else
                m_workbench.report(Severity::Danger, {}, errorText(layout.error()));
        });
}

void PlotLayoutBook::addFamilyEntries(QMenu &menu)
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    if (!device || !m_layouts.remembers())
        return;
    const QString title = qt(device->family->title);
    menu.addAction(tr("Begin like this with every %1").arg(title), this, [this, id = device->id] {
        const DeviceView *selected = m_workbench.snapshot().device(id);
        if (!selected)
            return;
        PlotLayout layout = current();
        for (PlotLayout::Trace &trace : layout.traces) {
            if (trace.device == qt(selected->selector))
                trace.device = QStringLiteral("*");
        }
        keep(PlotLayouts::familyName(qt(selected->family->key)), layout);
    });
    menu.addAction(tr("Begin with the usual for every %1").arg(title), this,
        [this, family = qt(device->family->key)] { keep(PlotLayouts::familyName(family), std::nullopt); });
}

} // namespace mb
