// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designcourse.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/design/adviserlist.h"
#include "widgets/design/scrollcolumn.h"
#include "widgets/design/tuningsteps.h"
#include "widgets/parameters/editdesk.h"

#include <algorithm>

namespace mb {
namespace {

enum CourseRow { AdvisersRow, AdvisersEnd, StepsRow, StepsEnd };

std::vector<ParameterChange> changesOf(const Family &family, const tuning::SetAdvice &advice)
{
    std::vector<ParameterChange> changes;
    for (const auto &[key, number] : advice.changes) {
        const auto index = findParameter(family.parameters, key);
        const auto raw = index ? toRaw(family.parameters[index->value], number) : Result<std::int64_t>(0);
        if (index && raw)
            changes.push_back({*index, *raw});
    }
    return changes;
}

bool isStaged(StagedEdits &edits, const std::vector<ParameterChange> &changes)
{
    const std::vector<StagedChange> staged = edits.ordered();
    return !changes.empty() && std::ranges::all_of(changes, [&staged](const ParameterChange &wanted) {
        return std::ranges::any_of(
            staged, [&wanted](const StagedChange &one) { return one.index == wanted.index && one.to == wanted.raw; });
    });
}

} // namespace

DesignCourse::DesignCourse(Workbench &workbench, DesignBook &book, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_book(book)
{
    const Theme &look = theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    m_area = new ScrollColumn(look, this);
    m_advisers = new AdviserList(theme, m_area->content());
    m_steps = new TuningSteps(theme, m_area->content());
    m_area->rows().addWidget(m_advisers);
    m_area->rows().addStretch(1);
    m_area->rows().addWidget(m_steps);
    m_area->rows().addStretch(0);
    column->addWidget(m_area, 1);
    m_foot = new QWidget(this);
    (void)layoutIn<QHBoxLayout>(m_foot, 0, {look.u(12), look.u(4), look.u(12), look.u(10)});
    column->addWidget(m_foot);
    connect(m_advisers, &AdviserList::stageRequested, this, &DesignCourse::stage);
    connect(m_advisers, &AdviserList::rebuilt, this, &DesignCourse::fit, Qt::QueuedConnection); // once they are shown
    connect(m_steps, &TuningSteps::rebuilt, this, &DesignCourse::fit, Qt::QueuedConnection);
}

void DesignCourse::setOrder(QWidget *order)
{
    if (order)
        m_foot->layout()->addWidget(order);
    m_foot->setVisible(order != nullptr);
}

/// One after the other, until all is in sight: what an adviser finds in order takes one line, what is said of every set stands in tooltips,
/// all that is in order takes one line, and why a result is good stands last, where it scrolls.
void DesignCourse::fit()
{
    using Density = AdviserList::Density;
    const struct {
        Density advisers;
        bool briefSteps;
        bool evidenceLast;
    } ways[] = {{Density::Comfortable, false, false}, {Density::Compact, false, false}, {Density::Compact, true, false},
        {Density::Dense, true, false}, {Density::Dense, true, true}};
    for (const auto &way : ways) {
        m_advisers->setDensity(way.advisers);
        m_steps->setBrief(way.briefSteps);
        m_steps->setEvidenceLast(way.evidenceLast);
        if (m_area->isInSight({m_advisers, m_steps}))
            break;
    }
    const bool alone = m_advisers->isHidden(); // then the steps stand at the top
    m_area->rows().setStretch(AdvisersEnd, alone ? 0 : 1);
    m_area->rows().setStretch(StepsEnd, alone ? 1 : 0);
}

void DesignCourse::follow(const DeviceView &view, const OperationView *running, const Chosen &chosen)
{
    if (!chosen.proposal || !m_book.report()) {
        m_advisers->clear();
        m_steps->show(running, m_book.report(), nullptr, chosen.inForce);
        return;
    }
    advise(view, chosen);
    const TuningSteps::Ahead ahead{*view.family, *chosen.proposal,
        tuning::courseOf(m_book.basisOf(view, chosen.inForce), *chosen.proposal), m_book.choice().slot,
        view.family->capabilities.gainSlots, m_book.loop(), chosen.isFoundAnew};
    m_steps->show(running, m_book.report(), &ahead, chosen.inForce);
}

void DesignCourse::advise(const DeviceView &view, const Chosen &chosen)
{
    const tuning::ProposalBasis basis = m_book.basisOf(view, chosen.inForce);
    const tuning::KnownGains now
        = tuning::knownGains(basis.family, basis.loop, basis.axis, basis.slot, *view.parameters);
    StagedEdits &edits = EditDesk::of(m_workbench).editsOf(view);
    m_advisers->show(basis, *chosen.proposal, chosen.name, tuning::adviseOnSet(basis, *chosen.proposal, now),
        [&](const tuning::SetAdvice &advice) { return isStaged(edits, changesOf(basis.family, advice)); });
}

void DesignCourse::stage(const tuning::SetAdvice &advice, bool staged)
{
    const DeviceView *const view = m_book.device();
    if (!view)
        return;
    StagedEdits &edits = EditDesk::of(m_workbench).editsOf(*view);
    const std::vector<ParameterChange> changes = changesOf(*view->family, advice);
    if (staged)
        edits.stageAll(changes, tr("What the adviser proposes"));
    for (std::size_t i = 0; !staged && i < changes.size(); ++i)
        edits.revert(changes[i].index);
    Q_EMIT m_workbench.changed();
}

} // namespace mb
