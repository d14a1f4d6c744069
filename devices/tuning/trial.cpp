// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/trial.h"

#include <algorithm>

namespace mb::tuning {

bool Trial::has(std::string_view flag) const
{
    return std::find(flags.begin(), flags.end(), flag) != flags.end();
}

const Signal *Trial::signal(std::string_view key) const
{
    const auto found = std::find_if(signals.begin(), signals.end(), [key](const Signal &signal) {
        return signal.channel == key || (signal.channel.ends_with(key) && signal.channel.starts_with("ch"));
    });
    return found == signals.end() ? nullptr : &*found;
}

} // namespace mb::tuning
