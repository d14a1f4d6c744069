// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QLockFile>

#include <map>
#include <memory>
#include <set>

namespace mb {

/// Lets two windows share the bench politely: this one puts its name to each link that it has open, and says who has one already.
/// A CAN interface can be used by both; whoever drives is told. GUI thread.
class LinkOwners : public QObject {
    Q_OBJECT
public:
    /// `folder`: of the names, the same for every program of this user.
    LinkOwners(Workbench &workbench, const QString &folder, QObject *parent);

    /// Who else has this link, "MotorBench, process 4711"; empty: nobody, as far as is known.
    [[nodiscard]] QString otherOwner(const std::string &address) const;

Q_SIGNALS:
    /// A link that is open here is open there too.
    void shared(const QString &link, const QString &owner);

private:
    void follow();
    void take(const LinkView &link);
    void explain(const FailedLink &link);
    [[nodiscard]] QString fileOf(const std::string &address) const;

    Workbench &m_workbench;
    QString m_folder;
    std::map<std::string, std::unique_ptr<QLockFile>> m_locks;
    std::set<std::string> m_told;
};

/// Which process has this file open, "ModemManager, process 812", as far as this user may look; empty: none that can be seen.
[[nodiscard]] QString holderOf(const QString &file, const QString &processes = QStringLiteral("/proc"));

} // namespace mb
