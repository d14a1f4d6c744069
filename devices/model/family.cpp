// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"

#include "model/registry.h"

namespace mb {

std::string_view toString(UpdateOutcome outcome)
{
    switch (outcome) {
    case UpdateOutcome::Done: return "done";
    case UpdateOutcome::UpToDate: return "up-to-date";
    case UpdateOutcome::Refused: return "refused";
    case UpdateOutcome::Failed: return "failed";
    case UpdateOutcome::Cancelled: return "cancelled";
    }
    return "";
}

const Family *findFamily(std::span<const Family *const> families, std::string_view key)
{
    for (const Family *family : families) {
        if (family->key == key)
            return family;
    }
    return nullptr;
}

} // namespace mb
