// SPDX-License-Identifier: GPL-3.0-or-later
// Tunes every motor on every family by itself and compares what is kept with the best there is (scripts/soak tuning):
//   tuningsoak [part=K/N] [seeds=4|seed=2] [compare=0|1|2] [families=A,B] [motors=A,B] [loops=A,B] [rates=0,50]
//              [dialects=D1,D2] [gains=tuned] [notes=1]
// compare=2: with what was there before only; gains: that are stored before. One line a tuning as soon as it is done, parted by tabs;
// scripts/tuning-table makes the tables of docs/tuning-results.md of them.
#include "tests/tuning/matrix/matrixrow.h"

#include <cstdio>
#include <map>
#include <sstream>

namespace {

using namespace mb;
using namespace mb::test;

using Notes = std::vector<std::pair<double, std::string>>;

struct LoopOfFamily {
    const char *family;
    Mode loop;
    std::vector<double> rates;             ///< samples per second that its wire reaches; 0: what it asks for by itself
    std::vector<std::string> dialects{""}; ///< of its firmware; "": the usual one
};

/// What the bench has and autotune() can do.
const std::vector<LoopOfFamily> &loops()
{
    static const std::vector<LoopOfFamily> all{
        {"dmc60c", Mode::Velocity, {0.0, 100.0, 50.0}},
        {"dmc60c", Mode::Position, {0.0, 100.0, 50.0}},
        {"abstractdc", Mode::Velocity, {0.0, 50.0}},
        {"abstractdc", Mode::Position, {0.0, 50.0}},
        {"quadquad2drv", Mode::Velocity, {0.0, 50.0}},
        {"quadquad2drv", Mode::Position, {0.0, 50.0}},
        {"dmc60c", Mode::Current, {0.0}},
        {"supermodified", Mode::Position, {0.0}, {"D1", "D2", "D3"}},
    };
    return all;
}

struct Options {
    std::map<std::string, std::string> given;

    Options(int count, char **arguments)
    {
        for (int i = 1; i < count; ++i) {
            const std::string text = arguments[i];
            const auto at = text.find('=');
            given[text.substr(0, at)] = at == std::string::npos ? "1" : text.substr(at + 1);
        }
    }
    [[nodiscard]] std::string text(const std::string &key, const std::string &otherwise) const
    {
        const auto found = given.find(key);
        return found == given.end() ? otherwise : found->second;
    }
    [[nodiscard]] std::vector<std::string> list(const std::string &key, const std::string &otherwise) const
    {
        std::vector<std::string> parts;
        std::stringstream stream(text(key, otherwise));
        for (std::string part; std::getline(stream, part, ',');)
            parts.push_back(part);
        return parts;
    }
    [[nodiscard]] bool has(const std::string &key, const std::string &value) const
    {
        if (!given.contains(key))
            return true;
        const auto all = list(key, "");
        return std::find(all.begin(), all.end(), value) != all.end();
    }
};

std::vector<Cell> cellsOf(const Options &options)
{
    std::vector<Cell> cells;
    const std::uint64_t seeds = std::stoul(options.text("seeds", "4"));
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        if (!options.has("seed", std::to_string(seed)))
            continue;
        for (const LoopOfFamily &row : loops()) {
            if (!options.has("families", row.family) || !options.has("loops", std::string(toString(row.loop))))
                continue;
            for (const std::string &motor : options.list("motors", "cim,775pro,rs775,25d,25dlp,n20")) {
                for (const double rate : row.rates) {
                    for (const std::string &dialect : row.dialects) {
                        if (options.has("rates", std::to_string(static_cast<int>(rate)))
                            && (dialect.empty() || options.has("dialects", dialect)))
                            cells.push_back(cellOf(row.family, motor, row.loop, seed, rate, dialect));
                    }
                }
            }
        }
    }
    return cells;
}

} // namespace

int main(int count, char **arguments)
{
    const Options options(count, arguments);
    unsigned part = 1;
    unsigned parts = 1;
    if (std::sscanf(options.text("part", "1/1").c_str(), "%u/%u", &part, &parts) != 2 || part < 1 || part > parts)
        return 2;
    const std::string compare = options.text("compare", "1");
    if (part == 1)
        std::printf("%s\n", matrixHead().c_str());
    std::size_t at = 0;
    for (Cell cell : cellsOf(options)) {
        if (at++ % parts != part - 1)
            continue;
        cell.stored = options.text("gains", cell.stored);
        const MatrixRow row = tuneCell(cell,
            compare == "2"       ? Compare::Kept
                : compare == "1" ? Compare::All
                                 : Compare::Nothing);
        std::printf("%s\n", textOf(row).c_str());
        std::fflush(stdout);
        for (const auto &[seconds, text] : options.text("notes", "0") == "1" ? row.notes : Notes())
            std::fprintf(stderr, "  %6.2f %s\n", seconds, text.c_str());
    }
    return 0;
}
