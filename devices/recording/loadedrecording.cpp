// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/loadedrecording.h"

#include <array>

namespace mb {

Quantity quantityOfKey(std::string_view key)
{
    constexpr std::array words{std::pair{std::string_view("velocity"), Quantity::Velocity},
        std::pair{std::string_view("position"), Quantity::Position},
        std::pair{std::string_view("current"), Quantity::Current}, std::pair{std::string_view("duty"), Quantity::Duty},
        std::pair{std::string_view("setpoint"), Quantity::SetPoint},
        std::pair{std::string_view("error"), Quantity::Error},
        std::pair{std::string_view("voltage"), Quantity::Voltage},
        std::pair{std::string_view("temperature"), Quantity::Temperature}};
    for (const auto &[word, quantity] : words) {
        if (key.ends_with(word))
            return quantity;
    }
    return Quantity::Other;
}

void addLoadedChannel(LoadedRecording &loaded, const std::string &title, const std::string &unit)
{
    const std::string &name = loaded.words.emplace_back(title);
    const std::string &shownUnit = loaded.words.emplace_back(unit);
    loaded.table.push_back({name, shownUnit, name, quantityOfKey(name)});
}

} // namespace mb
