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

} // namespace mb::console
