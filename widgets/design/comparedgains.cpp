// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/comparedgains.h"

#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

struct ComparedText {
    Q_DECLARE_TR_FUNCTIONS(mb::ComparedText)
};

/// Whether a device that has these has the proposal.
bool isInForce(const tuning::Proposal &proposal, const tuning::KnownGains &now)
{
    return std::ranges::all_of(proposal.gains.rows, [&now](const auto &row) {
        return std::ranges::any_of(
            now, [&row](const auto &known) { return known.first == row.key && known.second == row.number; });
    });
}

/// What a tuning replaced, in the midst of what it left alone.
tuning::KnownGains replacedBy(const tuning::KnownGains &before, tuning::KnownGains now)
{
    for (auto &[key, number] : now) {
        for (const auto &[old, value] : before) {
            if (old == key)
                number = value;
        }
    }
    return now;
}

} // namespace

const std::optional<ComparedGains> &GainComparison::with(const DeviceView &view, const tuning::ProposalBasis &basis,
    const tuning::TuneReport &report, const tuning::Proposal &proposal)
{
    tuning::KnownGains numbers = tuning::knownGains(basis.family, basis.loop, basis.axis, basis.slot, *view.parameters);
    QString name = ComparedText::tr("in force");
    if (isInForce(proposal, numbers)) {
        numbers = report.slot == basis.slot ? replacedBy(report.before, std::move(numbers)) : tuning::KnownGains();
        name = ComparedText::tr("before");
    }
    if (numbers == m_numbers && proposal.step == m_step && name == m_name)
        return m_compared;
    m_compared.reset();
    if (isInForce(proposal, numbers))
        numbers.clear(); // it has replaced itself
    if (auto former = tuning::formerProposal(basis, numbers, proposal.step))
        m_compared = {std::move(former->proposal), name};
    m_numbers = std::move(numbers);
    m_step = proposal.step;
    m_name = name;
    return m_compared;
}

QString comparedText(const ComparedGains &compared)
{
    const tuning::Proposal &proposal = compared.proposal;
    if (!proposal.margins.isStable())
        return ComparedText::tr("%1: unstable on this model").arg(compared.name);
    return ComparedText::tr("%1: over %2 %, Ms %3")
        .arg(compared.name, formatNumber(proposal.predicted.metrics.overshoot.value_or(0.0) * 100.0, 1),
            formatNumber(proposal.margins.ms, 2));
}

} // namespace mb
