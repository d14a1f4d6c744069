// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/assignments.h"

#include "app/console/parameterrows.h"

#include <algorithm>

namespace mb::console {
namespace {

Result<ParameterChange> parseAssignment(const Family &family, const std::string &text)
{
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        return fail(Fault::Usage, say("'%1' is not KEY=VALUE", text), say("write it like slot0.p=1.5"));
    MB_TRY(const auto index, parseKey(family, text.substr(0, equals)));
    const Parameter &parameter = family.parameters[index.value];
    if (parameter.access == Access::ReadOnly)
        return fail(Fault::OutOfRange, say("%1 is read-only", parameter.key), say("leave it out"));
    const std::string value = text.substr(equals + 1);
    if (value.find_first_of("xX") != std::string::npos && parameter.choices.empty())
        return fail(Fault::OutOfRange, say("%1: '%2' is not a decimal number", parameter.key, value),
            say("write it with digits and a dot, like 2.5"));
    MB_TRY(const auto raw, parseRaw(parameter, value));
    return ParameterChange{index, raw};
}

} // namespace

Result<std::vector<ParameterChange>> parseAssignments(const Family &family, const std::vector<std::string> &texts)
{
    std::vector<ParameterChange> changes;
    for (const std::string &text : texts) {
        MB_TRY(const auto change, parseAssignment(family, text));
        const auto same = [&](const ParameterChange &other) { return other.index == change.index; };
        if (std::ranges::any_of(changes, same))
            return fail(
                Fault::Usage, say("%1 is given twice", family.parameters[change.index.value].key), say("give it once"));
        changes.push_back(change);
    }
    return changes;
}

} // namespace mb::console
