// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/codereports.h"

#include "families/supermodified/codec.h"

#include <algorithm>

namespace mb::supermodified {

namespace {

bool isNamed(std::uint8_t code)
{
    const auto names = codeNames();
    return std::ranges::any_of(names, [code](const CodeName &name) { return name.code == code; });
}

std::string keyOf(std::uint8_t code)
{
    constexpr std::string_view digits = "0123456789abcdef";
    return std::string("code_") + digits[code >> 4U] + digits[code & 0xFU];
}

} // namespace

bool CodeReports::take(std::uint8_t code)
{
    Reported &reported = m_codes[code];
    ++reported.count;
    const bool endsMotion = code >= code::motorStalled && code <= code::encoderUnderflow;
    reported.active = reported.active || endsMotion;
    return endsMotion;
}

void CodeReports::started()
{
    for (auto &[code, reported] : m_codes)
        reported.active = false;
}

std::vector<FaultRecord> CodeReports::records() const
{
    std::vector<FaultRecord> records;
    for (const CodeName &name : codeNames()) {
        const auto reported = m_codes.find(name.code);
        const bool any = reported != m_codes.end();
        records.push_back(
            {std::string(name.key), any && reported->second.active, any, any ? reported->second.count : 0});
    }
    for (const auto &[code, reported] : m_codes) {
        if (!isNamed(code))
            records.push_back({keyOf(code), false, true, reported.count});
    }
    return records;
}

std::vector<std::string> CodeReports::active() const
{
    std::vector<std::string> keys;
    for (const CodeName &name : codeNames()) {
        const auto reported = m_codes.find(name.code);
        if (reported != m_codes.end() && reported->second.active)
            keys.emplace_back(name.key);
    }
    return keys;
}

} // namespace mb::supermodified
