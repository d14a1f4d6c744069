// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulatorflash.h"

#include <algorithm>

namespace mb::abstractdc::simulation {

bool SettingsFlash::isBlank(std::size_t at) const
{
    return std::all_of(m_words.begin() + static_cast<std::ptrdiff_t>(at),
        m_words.begin() + static_cast<std::ptrdiff_t>(at + recordWords), [](std::int32_t word) { return word == -1; });
}

std::size_t SettingsFlash::end(int page) const
{
    std::size_t at = static_cast<std::size_t>(page) * pageWords;
    while (at + recordWords < m_words.size() && !isBlank(at))
        at += recordWords;
    return at;
}

Record SettingsFlash::load(int page) const
{
    const std::size_t behind = end(page);
    if (behind == static_cast<std::size_t>(page) * pageWords)
        return {};
    const auto *word = &m_words.at(behind - recordWords);
    return {word[0], word[1], word[2], word[3], word[4] & 0xFFFF};
}

void SettingsFlash::save(int page, const Record &record)
{
    const std::size_t at = end(page);
    if (at + recordWords > m_words.size() || !isBlank(at))
        return;
    const std::array words{record.p, record.i, record.d, record.divisor, record.averaging};
    std::copy(words.begin(), words.end(), m_words.begin() + static_cast<std::ptrdiff_t>(at));
}

} // namespace mb::abstractdc::simulation
