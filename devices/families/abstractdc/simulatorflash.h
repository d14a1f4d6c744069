// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace mb::abstractdc::simulation {

/// What one save writes, five words.
struct Record {
    std::int32_t p = 0;
    std::int32_t i = 0;
    std::int32_t d = 0;
    std::int32_t divisor = 0;
    std::int32_t averaging = 1;

    friend bool operator==(const Record &, const Record &) = default;
};

/// The three settings pages, 1 KiB each, for velocity, current, position, as one piece of flash: a save is written behind the
/// last record of its page, and nothing ends that at the end of the page (README.md#saves).
class SettingsFlash {
public:
    SettingsFlash() { erase(); }
    void erase() { m_words.fill(-1); }
    /// The last record before the first blank one; what blank flash means when there is none.
    [[nodiscard]] Record load(int page) const;
    void save(int page, const Record &record);

private:
    static constexpr std::size_t recordWords = 5;
    static constexpr std::size_t pageWords = 256;

    [[nodiscard]] bool isBlank(std::size_t at) const;
    [[nodiscard]] std::size_t end(int page) const;

    std::array<std::int32_t, 5 * pageWords> m_words{}; ///< with what lies behind the third page
};

} // namespace mb::abstractdc::simulation
