// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "report/report.h"

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

namespace mb {

/// The notebook of trials as the window sees it: nothing waits, answers come later, never from inside the call. Everything on
/// the GUI thread. A change that cannot be made is answered with its cause (a full disk, a file of a newer version).
class TrialNotebook : public QObject {
    Q_OBJECT
public:
    using Finished = std::function<void(Result<void>)>;
    using Listed = std::function<void(Result<std::vector<KeptTrial>>)>;
    using Fetched = std::function<void(Result<std::vector<tuning::Signal>>)>;

    using Gathered = std::function<void(Result<std::vector<ReportUnit>>)>;

    using QObject::QObject;

    /// Every trial of a unit (Trial::unit), in order of their beginning, without signals.
    virtual void list(const std::string &unit, Listed listed) = 0;
    /// What was recorded in one.
    virtual void fetch(std::int64_t number, Fetched fetched) = 0;
    virtual void setStar(std::int64_t number, bool star, Finished finished) = 0;
    virtual void setNote(std::int64_t number, const QString &note, Finished finished) = 0;
    virtual void remove(std::int64_t number, Finished finished) = 0;
    /// What a report tells of units and trials.
    virtual void gather(const ReportWish &wish, Gathered gathered) = 0;
    /// Into a file: a table where its name ends with .csv, JSON otherwise.
    virtual void exportTo(const QString &path, std::vector<KeptTrial> trials, Finished finished) = 0;
};

} // namespace mb
