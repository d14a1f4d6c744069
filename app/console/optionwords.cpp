// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/optionwords.h"

#include "experiment/stimulus.h"
#include "tuning/gainrules.h"

namespace mb::console {

std::vector<std::string_view> tunableLoops()
{
    return {toString(Mode::Velocity), toString(Mode::Position), toString(Mode::Current)};
}

std::vector<std::string_view> aimWords()
{
    using tuning::Aim;
    return {toString(Aim::Calm), toString(Aim::Normal), toString(Aim::Brisk)};
}

std::vector<std::string_view> profileWords()
{
    using tuning::Profile;
    return {toString(Profile::Step), toString(Profile::Square), toString(Profile::Ramp), toString(Profile::Sine),
        toString(Profile::Chirp), toString(Profile::Prbs)};
}

std::vector<std::string_view> dialectWords(std::span<const Family *const> families)
{
    std::vector<std::string_view> words;
    for (const Family *family : families) {
        if (!family->decodeCan)
            continue;
        for (const DialectChoice &row : family->dialects)
            words.push_back(row.key);
    }
    return words;
}

std::vector<std::string_view> targetWords(std::span<const Family *const> families)
{
    std::vector<std::string_view> words;
    for (const Family *family : families) {
        for (const UpdateRoute &route : family->routes)
            words.insert(words.end(), route.targets.begin(), route.targets.end());
    }
    return words;
}

std::string waysOf(std::span<const UpdateRoute> routes, std::string_view between)
{
    std::string ways;
    for (const UpdateRoute &route : routes)
        ways += (ways.empty() ? "" : std::string(between)) + std::string(route.example);
    return ways;
}

} // namespace mb::console
