// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

#include <vector>

namespace mb {

struct ServiceView;

/// How a shift goes, in figures that are read from where one stands: passed, failed, refused, mean time, units an hour. GUI thread.
class CountTiles : public QWidget {
    Q_OBJECT
public:
    CountTiles(const ThemeSource &theme, QWidget *parent);

    void follow(const ServiceView &view);
    /// "27 passed", …, as they stand there.
    [[nodiscard]] QStringList texts() const;

private:
    class Tile;

    std::vector<Tile *> m_tiles;
};

} // namespace mb
