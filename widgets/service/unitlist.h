// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QListWidget>

namespace mb {

struct ServiceView;

/// The last units of a bench, newest first: serial number, device number, how it went and why, seconds, time of day. Not to be
/// operated, so it takes no focus. GUI thread.
class UnitList : public QListWidget {
    Q_OBJECT
public:
    UnitList(const ThemeSource &theme, QWidget *parent);

    void follow(const ServiceView &view);

    static constexpr int shown = 10;

private:
    class Row;

    const ThemeSource &m_theme;
};

} // namespace mb
