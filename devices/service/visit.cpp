// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/visit.h"

#include "model/unit.h"

#include <algorithm>
#include <array>

namespace mb::service {
namespace {

constexpr std::array<std::string_view, 8> steps{MB_LABEL("preflight"), MB_LABEL("backup"), MB_LABEL("firmware"),
    MB_LABEL("parameters"), MB_LABEL("self-test"), MB_LABEL("number"), MB_LABEL("proof"), MB_LABEL("done")};
constexpr std::array<std::string_view, 4> outcomes{"open", "passed", "failed", "refused"};
constexpr std::array<std::string_view, 3> endings{"", "stop-unconfirmed", "numbers-used-up"};

template <std::size_t N> std::size_t placeOf(const std::array<std::string_view, N> &words, std::string_view text)
{
    const auto found = std::ranges::find(words, text);
    return found == words.end() ? 0 : static_cast<std::size_t>(found - words.begin());
}

} // namespace

std::string_view toString(Step step)
{
    return steps[static_cast<std::size_t>(step)];
}

Step stepFromString(std::string_view text)
{
    return static_cast<Step>(placeOf(steps, text));
}

std::string_view toString(Outcome outcome)
{
    return outcomes[static_cast<std::size_t>(outcome)];
}

Outcome outcomeFromString(std::string_view text)
{
    return static_cast<Outcome>(placeOf(outcomes, text));
}

std::string_view toString(Ending ending)
{
    return endings[static_cast<std::size_t>(ending)];
}

Ending endingFromString(std::string_view text)
{
    return static_cast<Ending>(placeOf(endings, text));
}

std::string numberScopeOf(const Visit &visit)
{
    return (visit.simulated ? "simulated " : "") + visit.family + ' ' + visit.recipe;
}

std::string numberOwnerOf(const Visit &visit)
{
    return unitByOf(visit.unit) == UnitBy::Place ? visit.id : visit.unit;
}

} // namespace mb::service
