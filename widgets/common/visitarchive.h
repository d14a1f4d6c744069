// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "service/recipematter.h"
#include "service/servicejournal.h"

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

namespace mb {

/// A run that was cut off, as the journal has it. A value.
struct CutRun {
    std::string run; ///< empty: there is none
    int ended = 0;   ///< units that have their verdict
    int open = 0;    ///< units that were being served
    bool simulated = false;
};

/// The journal of service as the window sees it: nothing waits, answers come later, never from inside the call. Everything on the
/// GUI thread. A change that cannot be made is answered with its cause (a full disk, a file of a newer version).
class VisitArchive : public QObject {
    Q_OBJECT
public:
    using Finished = std::function<void(Result<void>)>;
    using Listed = std::function<void(Result<std::vector<service::Visit>>)>;
    using CutFound = std::function<void(Result<CutRun>)>;

    using QObject::QObject;

    /// What the journal has, oldest first.
    virtual void list(const service::VisitFilter &filter, Listed listed) = 0;
    /// The last run of this recipe, where units of it were cut off and nobody has gone on since; of real units before that of
    /// simulated ones.
    virtual void findCut(const service::RecipeMatter &matter, CutFound found) = 0;
    /// A note of the operator on an entry.
    virtual void setNote(const std::string &visit, const QString &note, Finished finished) = 0;
    /// A table of them with everything the journal knows.
    virtual void exportTo(const QString &path, std::vector<service::Visit> visits, Finished finished) = 0;
};

} // namespace mb
