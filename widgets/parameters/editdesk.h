// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"
#include "widgets/parameters/stagededits.h"

#include <map>
#include <memory>
#include <set>

namespace mb {

/// What is staged for each device: one thing, whichever page shows it. One per workbench, shared by the pages.
class EditDesk : public QObject {
    Q_OBJECT
public:
    /// The one of this workbench, made when first needed; it lives as long.
    [[nodiscard]] static EditDesk &of(Workbench &workbench);

    /// Knows what the device has by its snapshot.
    [[nodiscard]] StagedEdits &editsOf(const DeviceView &device);
    /// nullptr where nobody ever asked for them.
    [[nodiscard]] StagedEdits *find(DeviceId device);
    /// Asks a device for its values when nothing is known of it and nothing is being done with it; once, whichever page shows it.
    void readOnce(const DeviceView &device);

private:
    explicit EditDesk(Workbench &workbench);
    void follow();

    struct Desk {
        std::unique_ptr<StagedEdits> edits;
        std::optional<std::uint64_t> revision; ///< of the values that the edits know
    };
    Workbench &m_workbench;
    std::map<DeviceId, Desk> m_desks;
    std::set<DeviceId> m_read;
};

} // namespace mb
