// SPDX-License-Identifier: GPL-3.0-or-later
// An hour of the whole simulated bench in virtual time, with things done by lot: what is shown is what was done.
#include "hourbench.h"

#include "fuzz/soak.h"

#include <cstdio>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr int minutes = 60; ///< scripts/soak makes twenty hours of it

class Hour : public testing::TestWithParam<std::uint64_t> { };

TEST_P(Hour, WhatIsShownIsWhatWasDone)
{
    test::HourBench bench(GetParam());
    bench.check();
    const Instant start = bench.now();
    int orders = 0;
    while (bench.now() - start < test::rounds(minutes) * 1min && !HasFailure()) {
        SCOPED_TRACE("order " + std::to_string(++orders));
        bench.act();
        if (!HasFailure())
            bench.check();
    }
    const auto took = std::chrono::duration_cast<std::chrono::minutes>(bench.now() - start).count();
    std::printf("seed %d: %lld minutes, %d orders, %llu samples, none lost:", static_cast<int>(GetParam()),
        static_cast<long long>(took), orders, static_cast<unsigned long long>(bench.samples()));
    for (const auto &[name, count] : bench.orders())
        std::printf(" %s %d", name.c_str(), count);
    std::printf("\n");
}

INSTANTIATE_TEST_SUITE_P(Seeds, Hour, testing::Values(20260713));

} // namespace
} // namespace mb
