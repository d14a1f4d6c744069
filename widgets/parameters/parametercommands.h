// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

namespace mb {

class BannerStack;

/// What is ordered of devices for their parameters. A notice says what was refused, and of which device, also after another
/// one was chosen.
class ParameterCommands : public QObject {
    Q_OBJECT
public:
    ParameterCommands(Workbench &workbench, BannerStack &banners, QObject *parent);

    void read(DeviceId device);
    /// What was written is no edit any more (EditDesk).
    void write(DeviceId device, const std::vector<ParameterChange> &changes);
    void store(DeviceId device);
    void takeSnapshot(DeviceId device);
    /// A write of its own, of values that were there before; also of another day.
    void undoWrite(DeviceId device, bool again);
    void restore(DeviceId device, const std::vector<ParameterChange> &changes);

Q_SIGNALS:
    /// Or refused.
    void written();
    /// The history of a unit has something new.
    void kept();

private:
    void refuse(const char *key, DeviceId device, const Error &error, const QString &remedy);
    void settle(DeviceId device, const std::vector<ParameterChange> &sent, const Result<void> &result);
    [[nodiscard]] std::function<void(const Result<void> &)> keeping(DeviceId device, const QString &remedy);

    Workbench &m_workbench;
    BannerStack &m_banners;
};

} // namespace mb
