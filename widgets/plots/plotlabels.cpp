// SPDX-License-Identifier: GPL-3.0-or-later
// Where words stand in a strip, so that none covers another.
#include "widgets/common/numberformat.h"
#include "widgets/plots/plotdecor.h"

#include <QCoreApplication>

#include <algorithm>

namespace mb {
namespace {

struct GapText {
    Q_DECLARE_TR_FUNCTIONS(GapText)
};

/// Gaps that share one label.
struct Cluster {
    double left = 0.0; ///< pixels
    double right = 0.0;
    double seconds = 0.0;
    int count = 0;
};

QString textOf(const Cluster &cluster)
{
    const QString length = formatDuration(cluster.seconds);
    return cluster.count == 1 ? GapText::tr("gap %1").arg(length)
                              : GapText::tr("%1 gaps, %2").arg(cluster.count).arg(length);
}

} // namespace

std::vector<GapLabel> gapLabels(
    const StripDecor &decor, const QCPAxis &keys, const QRectF &box, const QFontMetrics &metrics, const Theme &theme)
{
    const double air = theme.u(6);
    const double high = metrics.height() + theme.u(4);
    std::vector<GapLabel> labels;
    if (box.height() < metrics.height() * 2)
        return labels;
    std::vector<Cluster> clusters;
    for (const auto &[from, to] : decor.gaps) {
        const double left = std::max(keys.coordToPixel(from), box.left());
        const double right = std::min(keys.coordToPixel(to), box.right());
        if (right > left)
            clusters.push_back({left, right, to - from, 1});
    }
    std::sort(clusters.begin(), clusters.end(), [](const Cluster &a, const Cluster &b) { return a.left < b.left; });
    const auto placed = [&](const Cluster &cluster) {
        const double wide = metrics.horizontalAdvance(textOf(cluster)) + theme.u(10);
        const bool inside = cluster.right - cluster.left >= wide;
        const double x = inside ? (cluster.left + cluster.right - wide) / 2 : cluster.right + air;
        return QRectF(x, box.bottom() - high - theme.u(8), wide, high);
    };
    std::vector<Cluster> merged;
    for (const Cluster &next : clusters) {
        if (!merged.empty() && placed(merged.back()).right() + air > placed(next).left()) {
            merged.back().right = std::max(merged.back().right, next.right);
            merged.back().seconds += next.seconds;
            ++merged.back().count;
        } else {
            merged.push_back(next);
        }
    }
    for (const Cluster &cluster : merged) {
        const QRectF place = placed(cluster);
        const bool inside = place.left() >= cluster.left && place.right() <= cluster.right;
        const bool clear = labels.empty() || place.left() > labels.back().place.right();
        if (clear && place.right() < box.right() && (inside || decor.first))
            labels.push_back({place, textOf(cluster)});
    }
    return labels;
}

std::optional<QRectF> freePlace(const QRectF &wanted, const QRectF &box, const std::vector<QRectF> &taken)
{
    const auto isFree = [&](const QRectF &place) {
        return place.top() >= box.top() && place.bottom() <= box.bottom()
            && std::none_of(taken.begin(), taken.end(), [&](const QRectF &other) { return other.intersects(place); });
    };
    for (const double lines : {0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0}) {
        const QRectF place = wanted.translated(0, lines * wanted.height());
        if (isFree(place))
            return place;
    }
    return std::nullopt;
}

} // namespace mb
