// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/columnwidths.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QFontMetricsF>
#include <QtMath>

#include <algorithm>
#include <numeric>

namespace mb {
namespace {

constexpr int air = 48; ///< units that a name and a unit get of what is left: eyes go along the row

constexpr std::size_t at(int column)
{
    return static_cast<std::size_t>(column);
}

/// Rounded up: a text that is a part of a pixel too long is cut by a whole letter.
int textWidth(const QFont &font, const QString &text)
{
    return qCeil(QFontMetricsF(font).horizontalAdvance(text));
}

/// What every column would like to have.
ColumnWidths naturalWidths(
    const ParameterModel &model, const ParameterDelegate &delegate, const Theme &theme, const QFont &body)
{
    ColumnWidths widths{};
    const auto widen = [&](int column, const QString &text) {
        const int needed = textWidth(delegate.cellFont(column, body), text) + 2 * delegate.padding();
        widths[at(column)] = std::max(widths[at(column)], needed);
    };
    widen(ParameterModel::ValueColumn, QStringLiteral("−2147483648"));
    widen(ParameterModel::State, ParameterModel::tr("edited, was %1").arg(QStringLiteral("−32768")));
    widen(ParameterModel::Raw, QStringLiteral("0xFFFFFFFF"));
    for (int column = 0; column < ParameterModel::ColumnCount; ++column)
        widen(column, model.headerData(column, Qt::Horizontal).toString());
    for (std::uint16_t i = 0; model.family() && i < model.family()->parameters.size(); ++i) {
        for (const int column :
            {ParameterModel::Label, ParameterModel::Key, ParameterModel::Unit, ParameterModel::Reference})
            widen(column, model.indexOf({i}, column).data().toString());
        if (model.family()->parameters[i].access == Access::WriteOnly)
            widen(ParameterModel::State, ParameterModel::tr("unknown until written"));
        widen(ParameterModel::State, glyphWord(GlyphState::InRam));
    }
    widths[at(ParameterModel::Label)] += delegate.labelIndent() - delegate.padding();
    widths[at(ParameterModel::State)] += theme.u(12);
    widths[at(ParameterModel::ValueColumn)] += theme.u(4);
    return widths;
}

ColumnWidths leastWidths(const ColumnWidths &natural, const Theme &theme)
{
    ColumnWidths least = natural;
    least[at(ParameterModel::Label)] = std::min(natural[at(ParameterModel::Label)], theme.u(150));
    least[at(ParameterModel::Key)] = std::min(natural[at(ParameterModel::Key)], theme.u(110));
    least[at(ParameterModel::Unit)] = std::min(natural[at(ParameterModel::Unit)], theme.u(84));
    least[at(ParameterModel::Reference)] = std::min(natural[at(ParameterModel::Reference)], theme.u(110)); // words only
    return least;
}

/// For what a row says that nobody edits; what it was before an edit stands in the panel beside, too.
int leastState(const ParameterModel &model, const ParameterDelegate &delegate, const Theme &theme, const QFont &body)
{
    const QFont font = delegate.cellFont(ParameterModel::State, body);
    int widest = textWidth(font, model.headerData(ParameterModel::State, Qt::Horizontal).toString());
    const auto widen = [&](const QString &word) { widest = std::max(widest, textWidth(font, word)); };
    for (const GlyphState state :
        {GlyphState::Stored, GlyphState::Edited, GlyphState::Assumed, GlyphState::Volatile, GlyphState::OutOfRange})
        widen(glyphWord(state));
    for (std::uint16_t i = 0; model.family() && i < model.family()->parameters.size(); ++i) {
        if (model.family()->parameters[i].access == Access::WriteOnly)
            widen(ParameterModel::tr("unknown until written"));
    }
    return widest + 2 * delegate.padding() + theme.u(12);
}

int sum(const ColumnWidths &widths)
{
    return std::accumulate(widths.begin(), widths.end(), 0);
}

struct Give {
    int column = 0;
    int least = 0; ///< units
};

/// Who gives room where even the least is too much, in this order: how a value stands must not be scrolled for, long units are cut before.
/// Names come before numbers where keys stand beside them, else last: they begin alike.
std::array<Give, 3> givers(const ColumnWidths &widths)
{
    const Give unit{ParameterModel::Unit, 44};
    const Give value{ParameterModel::ValueColumn, 80};
    const Give label{ParameterModel::Label, 110};
    return widths[at(ParameterModel::Key)] > 0 ? std::array{unit, label, value} : std::array{unit, value, label};
}

void squeeze(ColumnWidths &widths, int room, const Theme &theme)
{
    for (const Give &give : givers(widths)) {
        const int over = std::max(0, sum(widths) - room);
        int &width = widths[at(give.column)];
        width -= std::clamp(width - theme.u(give.least), 0, over);
    }
}

/// What units and names can give, so that no number is cut.
int squeezable(const ColumnWidths &widths, const Theme &theme)
{
    return std::max(0, widths[at(ParameterModel::Unit)] - theme.u(44))
        + std::max(0, widths[at(ParameterModel::Label)] - theme.u(110));
}

} // namespace

ColumnWidths columnWidthsFor(
    const ParameterModel &model, const ParameterDelegate &delegate, const Theme &theme, const QFont &body, int room)
{
    ColumnWidths natural = naturalWidths(model, delegate, theme, body);
    ColumnWidths widths = leastWidths(natural, theme);
    widths[at(ParameterModel::State)]
        = std::min(widths[at(ParameterModel::State)], leastState(model, delegate, theme, body));
    const int wholeKeys = natural[at(ParameterModel::Key)] - widths[at(ParameterModel::Key)];
    const int wholeNames = natural[at(ParameterModel::Label)] - widths[at(ParameterModel::Label)];
    for (const int column : {ParameterModel::Raw, ParameterModel::Key, ParameterModel::Reference}) {
        // Keys are copied, raw numbers stand in the tooltip; a key goes only where no other column has anything left to give.
        const int more = column == ParameterModel::Raw ? wholeKeys + wholeNames : -squeezable(widths, theme);
        if (sum(widths) + more > room)
            widths[at(column)] = natural[at(column)] = 0;
    }
    squeeze(widths, room, theme);
    int spare = room - sum(widths);
    const auto widen = [&](int column, int wish) {
        const int more = std::clamp(std::min(wish, natural[at(column)]) - widths[at(column)], 0, std::max(0, spare));
        widths[at(column)] += more;
        spare -= more;
    };
    widen(ParameterModel::Key, widths[at(ParameterModel::Raw)] > 0 ? natural[at(ParameterModel::Key)] : theme.u(140));
    widen(ParameterModel::Label, theme.u(190));
    widen(ParameterModel::Key, natural[at(ParameterModel::Key)]);
    for (const int column : {ParameterModel::Label, ParameterModel::Key, ParameterModel::Unit, ParameterModel::State,
             ParameterModel::Reference})
        widen(column, natural[at(column)]);
    if (spare <= 0)
        return widths;
    const int each = std::min(spare / 3, theme.u(air));
    for (const int column : {ParameterModel::Label, ParameterModel::Unit})
        widths[at(column)] += each;
    const int last = widths[at(ParameterModel::Raw)] > 0 ? ParameterModel::Raw : ParameterModel::State;
    widths[at(last)] += spare - 2 * each;
    return widths;
}

} // namespace mb
