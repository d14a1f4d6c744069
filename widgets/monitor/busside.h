// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/linkload.h"
#include "widgets/common/theme.h"

#include <QScrollArea>

#include <string>

class QLabel;

namespace mb {

class BusLoadView;
class FrameDetail;
class IdModel;

/// Beside the tables of the bus: the frame that is selected, and how loaded the link was during the last minute.
class BusSide : public QScrollArea {
    Q_OBJECT
public:
    BusSide(const ThemeSource &theme, QWidget *parent);

    [[nodiscard]] FrameDetail &detail() { return *m_detail; }
    /// With what each snapshot tells, shown or not.
    [[nodiscard]] LinkLoads &loads() { return m_loads; }
    void showLoads(const std::string &link);
    void showFacts(const LinkView &link, const IdModel &ids);

private:
    void build(QWidget &content);

    const ThemeSource &m_theme;
    FrameDetail *m_detail = nullptr;
    BusLoadView *m_load = nullptr;
    QLabel *m_caption = nullptr;
    QLabel *m_facts = nullptr;
    LinkLoads m_loads;
};

} // namespace mb
