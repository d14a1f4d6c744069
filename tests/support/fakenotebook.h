// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/trialnotebook.h"

#include <QTimer>

#include <algorithm>
#include <map>

namespace mb::test {

/// A notebook in memory. Answers come with the next turn of the event loop.
class FakeNotebook final : public TrialNotebook {
public:
    using TrialNotebook::TrialNotebook;

    std::vector<KeptTrial> kept;
    std::map<std::int64_t, std::vector<tuning::Signal>> recorded;
    QString exported;
    std::size_t exportedRows = 0;
    std::vector<ReportWish> wishes;
    Result<std::vector<ReportUnit>> matter; ///< of every report

    void list(const std::string &unit, Listed listed) override
    {
        std::vector<KeptTrial> all;
        std::copy_if(kept.begin(), kept.end(), std::back_inserter(all),
            [&unit](const KeptTrial &row) { return row.trial.unit == unit; });
        later([listed, all] { listed(all); });
    }
    void fetch(std::int64_t number, Fetched fetched) override
    {
        later([fetched, found = recorded[number]] { fetched(found); });
    }
    void setStar(std::int64_t number, bool star, Finished finished) override
    {
        find(number).star = star;
        later([finished] { finished({}); });
    }
    void setNote(std::int64_t number, const QString &note, Finished finished) override
    {
        find(number).note = note.toStdString();
        later([finished] { finished({}); });
    }
    void remove(std::int64_t number, Finished finished) override
    {
        std::erase_if(kept, [number](const KeptTrial &row) { return row.number == number; });
        later([finished] { finished({}); });
    }
    void gather(const ReportWish &wish, Gathered gathered) override
    {
        wishes.push_back(wish);
        later([this, gathered] { gathered(matter); });
    }
    void exportTo(const QString &path, std::vector<KeptTrial> trials, Finished finished) override
    {
        exported = path;
        exportedRows = trials.size();
        later([finished] { finished({}); });
    }
    [[nodiscard]] KeptTrial &find(std::int64_t number)
    {
        return *std::find_if(kept.begin(), kept.end(), [number](const KeptTrial &row) { return row.number == number; });
    }

private:
    void later(std::function<void()> work) { QTimer::singleShot(0, this, std::move(work)); }
};

} // namespace mb::test
