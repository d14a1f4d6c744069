// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/bootsettings.h"

#include "wire/number.h"

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <utility>

namespace mb::quadquad2drv {
namespace {

constexpr std::array<std::string_view, 3> endings{"cr", "lf", "crlf"};
constexpr std::array<std::string_view, 4> formats{"8N1", "8E1", "8O1", "8N2"};
constexpr std::array<UpdateSetting, 7> unknowns{{
    {"baud", QT_TRANSLATE_NOOP("table", "baud rate"), QT_TRANSLATE_NOOP("table", "From the data sheet."), "115200"},
    {"format", QT_TRANSLATE_NOOP("table", "format"),
        QT_TRANSLATE_NOOP("table", "Data bits, parity, stop bits. Not told."), "8N1", formats},
    {"ending", QT_TRANSLATE_NOOP("table", "line ending"),
        QT_TRANSLATE_NOOP("table", "Not told; the terminal program that the data sheet names sends cr."), "cr",
        endings},
    {"banner", QT_TRANSLATE_NOOP("table", "greeting holds"),
        QT_TRANSLATE_NOOP("table", "The data sheet tells this word, and not the whole greeting."), "bootloader"},
    {"failure", QT_TRANSLATE_NOOP("table", "refusal holds"),
        QT_TRANSLATE_NOOP("table", "Not told. Words with | between them, in whatever case."), "err|fail|bad|invalid"},
    {"pause", QT_TRANSLATE_NOOP("table", "pause"),
        QT_TRANSLATE_NOOP("table", "Least time from one line to the next in milliseconds, from the data sheet."), "50"},
    {"farewell", QT_TRANSLATE_NOOP("table", "leaves with"),
        QT_TRANSLATE_NOOP("table", "Typed at the end. \"none\" leaves it to jumper and reset."), "reset"},
}};
constexpr int slowestPause = 1000;

std::vector<std::string> words(const std::string &text)
{
    std::vector<std::string> found;
    std::string word;
    for (const char c : text + '|') {
        if (c != '|')
            word += static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
        else if (!word.empty())
            found.push_back(std::exchange(word, {}));
    }
    return found;
}

Result<void> apply(BootSettings &settings, const std::string &key, const std::string &value)
{
    if (key == "banner") {
        settings.banner = value;
    } else if (key == "farewell") {
        settings.farewell = value == "none" ? std::string() : value;
    } else if (key == "failure") {
        settings.failures = words(value);
    } else if (key == "ending") {
        if (std::ranges::find(endings, value) == endings.end())
            return fail(Fault::OutOfRange, say("ending=%1: legal are cr, lf and crlf", value));
        settings.ending = value == "cr" ? "\r" : value == "lf" ? "\n" : "\r\n";
    } else { // pause
        int milliseconds = 0;
        if (!takeNumber(value, milliseconds) || milliseconds < 0 || milliseconds > slowestPause)
            return fail(Fault::OutOfRange, say("pause=%1: legal are 0 to 1000 milliseconds", value));
        settings.lineTime = std::chrono::milliseconds(milliseconds);
    }
    return {};
}

} // namespace

Result<BootSettings> BootSettings::take(LinkAddress &via)
{
    constexpr std::array<std::string_view, 5> ours{"ending", "banner", "failure", "pause", "farewell"};
    BootSettings taken;
    std::vector<std::pair<std::string, std::string>> rest;
    for (const auto &[key, value] : via.options) {
        if (std::ranges::find(ours, key) == ours.end()) {
            rest.emplace_back(key, value);
            continue;
        }
        MB_TRY_VOID(apply(taken, key, value));
    }
    via.options = std::move(rest);
    return taken;
}

std::span<const UpdateSetting> bootUnknowns()
{
    return unknowns;
}

} // namespace mb::quadquad2drv
