// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/visitarchive.h"

namespace mb::test {

/// A journal of service without a file: the test sets what is in it, and reads what was taken out. It answers at once.
class FakeVisits final : public VisitArchive {
public:
    void list(const service::VisitFilter &, Listed listed) override { listed(entries); }
    void findCut(const service::RecipeMatter &, CutFound found) override { found(cut); }
    void setNote(const std::string &visit, const QString &note, Finished finished) override
    {
        for (service::Visit &entry : entries) {
            if (entry.id == visit)
                entry.note = note.toStdString();
        }
        finished({});
    }
    void exportTo(const QString &, std::vector<service::Visit> visits, Finished finished) override
    {
        exported = std::move(visits);
        finished({});
    }

    std::vector<service::Visit> entries; ///< oldest first
    CutRun cut;
    std::vector<service::Visit> exported;
};

} // namespace mb::test
