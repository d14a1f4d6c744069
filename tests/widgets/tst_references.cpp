// SPDX-License-Identifier: GPL-3.0-or-later
// Points that are kept without the source that drew them.
#include "support/windowtests.h"
#include "widgets/plots/columnpath.h"
#include "widgets/plots/fixedtrace.h"
#include "widgets/plots/plotreadings.h"

using namespace mb;

class TestReferences : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsKeptWithoutItsSourceHasGapsOnlyWhereSamplesAreLost();
};

void TestReferences::whatIsKeptWithoutItsSourceHasGapsOnlyWhereSamplesAreLost()
{
    struct Source : FixedTrace {
        using FixedTrace::FixedTrace;
        std::optional<Statistics> statistics(double from, double to) const override
        {
            Statistics found;
            found.lost = from < 3.0 && to > 3.0 ? 2 : 0; // at 3 s only
            return found;
        }
    };
    std::vector<PlotPoint> points{{1.0, 1}, PlotPoint::gap(1.01), {1.02, 2}, {3.0, 2}, PlotPoint::gap(3.0), {3.02, 2},
        PlotPoint::gap(3.1), {4.0, 1}};
    const Source source(points);
    joinUnlost(points, source);
    QCOMPARE(gapsOf(points, 4.0).size(), std::size_t(2)); // a loss, and a silence
    QCOMPARE(gapsOf(points, 4.0).front().first, 3.0);
    QCOMPARE(points.size(), std::size_t(7));
}

MB_WINDOW_TEST(TestReferences);
#include "tst_references.moc"
