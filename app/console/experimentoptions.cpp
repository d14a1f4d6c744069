// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/experimentoptions.h"

#include "app/console/target.h"
#include "async/outputfile.h"
#include "experiment/envelope.h"

#include <CLI/CLI.hpp>

#include <array>
#include <limits>

namespace mb::console {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double lowest = -largest;

} // namespace

void ExperimentOptions::declare(CLI::App &arguments, const std::string &slotHelp)
{
    arguments.add_option("--axis", axis, "1…, on boards with several");
    arguments.add_option("--slot", slot, slotHelp);
    arguments.add_option("--travel", travel, "Most counts either side of where it stands");
    arguments.add_option("--speed", speed, "Most counts/s");
    arguments.add_option("--current", current, "Most A");
    arguments.add_option("--duty", duty, "Most duty, 0…1");
}

Result<ExperimentOptions::Values> ExperimentOptions::parse(const Family &family) const
{
    Values values;
    const std::array<const std::string *, envelopeBounds.size()> given{&travel, &speed, &current, &duty};
    for (std::size_t i = 0; i < given.size(); ++i) {
        const EnvelopeBound &bound = envelopeBounds[i];
        if (given[i]->empty())
            continue;
        MB_TRY(const auto number, parseNumber(std::string("--") + bound.key, *given[i], lowest, largest));
        if (auto bounds = tuning::checkBound(bound, number); !bounds)
            return fail(bounds.error().about(std::string("--") + bound.key));
        values.limits.*bound.value = number;
    }
    MB_TRY(values.axis, integerOr(1, "--axis", axis, 1, family.capabilities.axes));
    MB_TRY(values.slot, integerOr(0, "--slot", slot, 0, family.capabilities.gainSlots - 1));
    return values;
}

Result<void> checkSave(const std::string &path)
{
    return path.empty() ? Result<void>() : checkWritable(path);
}

Result<int> afterSaving(const Console &console, Result<int> verdict, const Result<void> &saved)
{
    if (saved)
        return verdict;
    Error why = saved.error();
    why.fault = Fault::NotKept; // the motor has turned: it is no wrong usage
    if (verdict)
        return fail(why);
    console.note(why.text());
    return verdict;
}

} // namespace mb::console
