// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotdecor.h"

namespace mb {

/// Words at a gap, where they have room.
struct GapLabel {
    QRectF place;
    QString text;
};
/// The labels of all gaps of a strip, at its foot. What would overlap becomes one label with the count and the sum.
[[nodiscard]] std::vector<GapLabel> gapLabels(
    const StripDecor &decor, const QCPAxis &keys, const QRectF &box, const QFontMetrics &metrics, const Theme &theme);
/// A place for words of this size near where they are wanted, inside `box` and clear of `taken`: there, or lines above or below.
/// Nothing where there is none: the words give way.
[[nodiscard]] std::optional<QRectF> freePlace(
    const QRectF &wanted, const QRectF &box, const std::vector<QRectF> &taken);

/// Words in a strip: those of `limits`, `bands` and so on, by their place in the list.
struct StripWord {
    enum class Kind { Mark, Limit, Trigger, Note, Band, Span };
    Kind kind = Kind::Limit;
    std::size_t index = 0;
    QRectF place;
};
/// Where each of them stands, so that none covers another or a gap's label: near what it names, else on another side of it or some
/// lines away. Those that have no place give way, the last kinds first.
[[nodiscard]] std::vector<StripWord> stripWords(
    const StripDecor &decor, const QCPAxisRect &rect, const QFont &caption, const Theme &theme);

} // namespace mb
