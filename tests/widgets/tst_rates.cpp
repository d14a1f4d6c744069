// SPDX-License-Identifier: GPL-3.0-or-later
// What is on screen is wished for faster, and nothing else; who wins is tests/app/test_engineparts.
#include "support/timers.h"
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/plots/plotspage.h"

#include <QTest>

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

namespace {

using Asked = std::map<std::pair<std::uint32_t, std::string>, double>;

/// A family whose telemetry is polled.
const Family &polled()
{
    static const Family family = [] {
        Family made = dmc60c();
        made.capabilities.freeRates = true;
        return made;
    }();
    return family;
}

struct RatesBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{darkTheme()};
    Arming arming{workbench};
    std::unique_ptr<PlotsPage> plots;
    std::unique_ptr<TunePage> tune;

    explicit RatesBench(const Family &family = polled())
    {
        for (const std::uint32_t id : {1U, 2U}) {
            workbench.shot.devices.push_back(
                tunableDrive(std::make_shared<Telemetry>(dmc60c().channels), id, 4 + static_cast<int>(id)));
            workbench.device(id - 1).family = &family;
        }
        selection.select({1});
        plots = std::make_unique<PlotsPage>(workbench, selection, theme, nullptr);
        plots->resize(1208, 760);
        tune = std::make_unique<TunePage>(workbench, selection, arming, theme, nullptr);
        tune->showLive(true);
        tune->resize(1208, 760);
        workbench.publish();
    }
    /// What all pages wish together; the engine decides by the highest (app/engine/rates.h).
    [[nodiscard]] Asked asked() const
    {
        std::map<std::uint64_t, std::vector<RateWish>> last;
        for (const auto &order : workbench.given<orders::WishRates>())
            last[order.wisher] = order.wishes;
        Asked highest;
        for (const auto &[wisher, wishes] : last) {
            for (const RateWish &wish : wishes) {
                double &hertz = highest[{wish.device.value, std::string(dmc60c().channels[wish.channel.value].key)}];
                hertz = std::max(hertz, wish.hertz);
            }
        }
        return highest;
    }
};

} // namespace

class TestRates : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsPlottedIsFastWhileItIsSeen();
    void aShorterWindowAsksForMore();
    void aDerivedSignalNeedsItsIngredients();
    void nothingIsAskedForOfADeviceWhoseRatesAreASetting();
    void theFasterOfTwoPagesCountsAndTheOtherRemains();
};

void TestRates::whatIsPlottedIsFastWhileItIsSeen()
{
    RatesBench bench;
    passTimers(150ms);
    QVERIFY(bench.asked().empty()); // nothing is visible yet
    bench.plots->show();
    const Asked four{{{1, "velocity"}, 100.0}, {{1, "position"}, 100.0}, {{1, "current"}, 100.0}, {{1, "duty"}, 100.0}};
    QTRY_COMPARE(bench.asked(), four);
    bench.plots->addSignal({{2}, *findChannel(dmc60c().channels, "velocity")});
    bench.plots->removeSignal({{1}, *findChannel(dmc60c().channels, "duty")});
    bench.workbench.publish();
    const Asked others{
        {{1, "velocity"}, 100.0}, {{1, "position"}, 100.0}, {{1, "current"}, 100.0}, {{2, "velocity"}, 100.0}};
    QTRY_COMPARE(bench.asked(), others);
    bench.plots->hide();
    QTRY_VERIFY(bench.asked().empty());
    const auto calls = bench.workbench.given<orders::WishRates>().size();
    bench.workbench.publish();
    passTimers(250ms);
    QCOMPARE(bench.workbench.given<orders::WishRates>().size(), calls);
}

void TestRates::aShorterWindowAsksForMore()
{
    RatesBench bench;
    bench.plots->show();
    QTRY_COMPARE(bench.asked().size(), 4U);
    for (const auto &[window, hertz] : std::map<double, double>{{60.0, 20.0}, {10.0, 100.0}, {1.0, 500.0}}) {
        bench.plots->stack().view().setWindow(window);
        bench.workbench.publish();
        QTRY_COMPARE(bench.asked()[std::pair(1U, std::string("velocity"))], hertz);
    }
}

void TestRates::aDerivedSignalNeedsItsIngredients()
{
    RatesBench bench;
    bench.plots->show();
    bench.plots->board().setTraces({}, true);
    bench.workbench.publish();
    QTRY_VERIFY(bench.asked().empty());
    QVERIFY(bench.plots->board().addDerived(
        QStringLiteral("power"), QStringLiteral("W"), QStringLiteral("d6_current * d6_bus_voltage")));
    bench.workbench.publish();
    const Asked both{{{2, "current"}, 100.0}, {{2, "bus_voltage"}, 100.0}};
    QTRY_COMPARE(bench.asked(), both);
}

void TestRates::nothingIsAskedForOfADeviceWhoseRatesAreASetting()
{
    RatesBench bench(dmc60c());
    bench.plots->show();
    bench.workbench.publish();
    passTimers(250ms);
    QVERIFY(bench.asked().empty());
    bench.workbench.device(0).motion.running = true; // who drives it may
    bench.workbench.publish();
    QTRY_COMPARE(bench.asked().size(), 4U);
    bench.workbench.device(0).motion.running = false;
    bench.workbench.publish();
    QTRY_VERIFY(bench.asked().empty());
}

void TestRates::theFasterOfTwoPagesCountsAndTheOtherRemains()
{
    RatesBench bench;
    bench.plots->stack().view().setWindow(60.0);
    bench.plots->show();
    bench.tune->show();
    QTRY_COMPARE(bench.asked()[std::pair(1U, std::string("velocity"))], 100.0);
    QTRY_COMPARE(bench.asked()[std::pair(1U, std::string("duty"))], 20.0);
    bench.tune->hide();
    QTRY_COMPARE(bench.asked()[std::pair(1U, std::string("velocity"))], 20.0);
    bench.plots.reset();
    QTRY_VERIFY(bench.asked().empty());
}

MB_WINDOW_TEST(TestRates);
#include "tst_rates.moc"
