// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/plots/signalbook.h"

#include <functional>
#include <optional>
#include <utility>

namespace mb {

/// Two keys of a plot's time.
using Stretch = std::pair<double, double>;

/// What an export shall have.
struct ExportChoice {
    std::optional<Stretch> stretch{}; ///< nothing: the whole session
    bool everything = false;          ///< all signals of all devices, not only what is plotted
    QString path{};                   ///< the kind follows from the suffix: csv or mcap
};

/// These open a dialog that belongs to `parent` and call back when it is accepted.
void askNote(QWidget &parent, std::function<void(const QString &)> done);
/// A formula: says while it is typed what is wrong with it. `check` yields nothing when it is right.
void askDerived(QWidget &parent, const ThemeSource &theme, const std::vector<SignalBook::Variable> &variables,
    std::function<QString(const QString &name, const QString &formula)> check,
    std::function<void(const QString &name, const QString &unit, const QString &formula)> done);
/// Offers these: what is seen, and A … B where there are cursors, when it is asked. Time goes on while somebody chooses.
void askExport(
    QWidget &parent, Stretch seen, std::optional<Stretch> selection, std::function<void(const ExportChoice &)> done);
/// Name of a layout.
void askName(QWidget &parent, const QString &title, const QString &proposal, std::function<void(const QString &)> done);

} // namespace mb
