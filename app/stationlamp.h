// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/lamp.h"
#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"

namespace mb {

class Arming;
class Closing;
class HeaderBar;

namespace service {
struct QueueRow;
} // namespace service

/// The lamp of the header: what it says, and what holding it arms. That is the selected device; while units are served, the
/// self-tests of the queue: armed is armed, whoever lets a motor turn. Nothing is armed in a window that is about to go. GUI thread.
class StationLamp : public QObject {
    Q_OBJECT
public:
    StationLamp(Workbench &workbench, Arming &arming, const Closing &closing, Selection &selection, HeaderBar &header);
    void follow();

private:
    void arm();
    void disarm();
    [[nodiscard]] LampStatus over(LampStatus status) const;
    [[nodiscard]] const service::QueueRow *tested() const;

    Workbench &m_workbench;
    Arming &m_arming;
    const Closing &m_closing;
    Selection &m_selection;
    HeaderBar &m_header;
};

} // namespace mb
