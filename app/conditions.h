// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/banner.h"
#include "widgets/common/workbench.h"

#include <map>
#include <set>

namespace mb {

class Arming;
struct DeviceView;

/// Keeps the banners above the pages in step with links and devices: what is lost, locked, stopped, or forgotten by a board
/// that was reset, which a click writes again.
class Conditions : public QObject {
    Q_OBJECT
public:
    Conditions(Workbench &workbench, Arming &arming, BannerStack &banners, QObject *parent);

    void follow();

private:
    void followLink(const LinkView &link);
    void followDevice(const DeviceView &device);
    void followUpdates();
    void followReset(const DeviceView &device);
    [[nodiscard]] QString resetTitle(const DeviceView &device, int lost) const;
    void followOwed();
    /// It stands until a look at everything does not post it. The key has the cause in it, since what is dismissed is silent: all but
    /// the numbers that go on by themselves. Causes of one thing that pass from one to the other begin with the same line, and are silent
    /// until none of them stands.
    void post(const QString &key, BannerKind kind, const QString &cause, const QString &remedy,
        const QString &action = {}, const QString &other = {});
    void act(const QString &key);
    void settleOwed(const QString &key, bool keep);
    void written(DeviceId device, const Result<void> &result);

    Workbench &m_workbench;
    Arming &m_arming;
    BannerStack &m_banners;
    std::set<QString> m_standing;           ///< with a banner, or of a thing that has one
    std::map<DeviceId, QString> m_failures; ///< of writing again, by device
};

} // namespace mb
