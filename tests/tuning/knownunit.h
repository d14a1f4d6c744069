// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "tests/tuning/matrix/matrixunit.h"

#include <string>
#include <utility>
#include <vector>

namespace mb::test {

/// A cell of any family, which has one motor everywhere.
[[nodiscard]] inline Cell cellOfLoop(const std::string &family, Mode loop)
{
    Cell cell;
    cell.family = family;
    cell.motor = "25d";
    cell.loop = loop;
    cell.dialect = family == "supermodified" ? "D1" : "";
    return cell;
}

/// A unit whose gains are known: those of a board are written once.
struct KnownUnit : MatrixUnit {
    explicit KnownUnit(const Cell &cell)
        : MatrixUnit(cell)
    {
        for (const auto &[name, raw] : {std::pair("velocity.p", 100), std::pair("velocity.i", 200),
                 std::pair("position.p", 100), std::pair("position.d", 500)}) {
            if (cell.family == "quadquad2drv") {
                EXPECT_TRUE(test::run(clock(), device().write(index(std::string("ch1.") + name), raw))) << name;
            }
        }
        before = gainsInUnit();
    }
    [[nodiscard]] ParameterIndex index(const std::string &key)
    {
        return findParameter(device().parameters().table(), key).value_or(ParameterIndex{});
    }
    void expectStandsAsBefore()
    {
        EXPECT_TRUE(device().isSeenStopped());
        EXPECT_FALSE(simulator().isOutputOn());
        EXPECT_EQ(gainsInUnit(), before);
        EXPECT_TRUE(journal().owed.empty());
    }

    std::vector<std::pair<std::string, std::optional<std::int64_t>>> before;
};

} // namespace mb::test
