// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "model/registry.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace mb::test {

/// The whole simulated bench behind the window's own engine, in virtual time, and a person who does things by lot. Every order
/// says which lines the log must have for it; check() compares what is shown with what was done.
class HourBench {
public:
    explicit HourBench(std::uint64_t seed);

    /// One order, and what must pass until its effects are over.
    void act();
    /// List of devices, counters, losses, parameters and log are what was done up to now.
    void check();
    [[nodiscard]] Instant now() const { return m_clock.now(); }
    /// How often each order was given, by name.
    [[nodiscard]] const std::map<std::string, int> &orders() const { return m_orders; }
    [[nodiscard]] std::uint64_t samples();

private:
    void drive();
    void write();
    void read();
    void chooseRate();
    void scan();
    void reopen();
    void stopEverything();
    void rest();

    void open(const std::string &link);
    void pass(Duration time) { m_clock.advance(time); }
    void expect(const DeviceView &device, const std::string &line);
    void checkLog();
    void checkLinks(const Snapshot &shot);
    static void checkDevice(const DeviceView &device);
    [[nodiscard]] std::set<std::string> rows();
    [[nodiscard]] int number(std::int64_t least, std::int64_t most);
    /// A device by lot, among those that fit; the bench always has one.
    template <class Fits> DeviceView drawn(Fits fits);

    VirtualClock m_clock;
    EngineCore m_core{m_clock, families(), false};
    std::mt19937_64 m_random;
    std::set<std::string> m_rows;
    std::map<std::pair<std::string, std::string>, std::int64_t> m_written; ///< raw by selector and key
    std::map<std::string, int> m_orders;
    std::map<const Link *, std::pair<std::uint64_t, std::uint64_t>> m_passed; ///< received and sent, by the tap
    std::map<const Link *, Subscription> m_taps;
    std::multiset<std::string> m_due; ///< lines of the log
    std::multiset<std::string> m_lines;
    std::uint64_t m_samplesBefore = 0; ///< of links that were closed
    Subscription m_listening;
};

} // namespace mb::test
