// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/tuneverdict.h"

#include "app/console/failure.h"

#include <utility>

namespace mb::console {

using namespace tuning;

Result<int> verdictOfTuning(const TuneReport &report)
{
    if (report.stopReason == EndReason::Link)
        return fail(Fault::LinkLost, say("the tuning ended because the link was lost: %1", report.evidence),
            report.stopped ? say("the motor was seen stopped") : say("see that the motor stands before anything else"));
    if (!report.stopped)
        return fail(Fault::Unsafe, say("the stop was not confirmed by %1", report.device),
            say("cut its power if the motor still turns"));
    if (report.result == TuneResult::Stopped && report.stopReason != EndReason::Interrupted)
        return fail(Fault::Unsafe, say("stopped by the guard '%1': %2", toString(report.stopReason), report.evidence),
            say("remove the cause before it is run again"));
    const auto remedy = [&report](Message usual) {
        return report.notPutBack.empty() ? std::move(usual)
            : replacesUnknown(report)    ? say("run it again, or write gains that hold")
                                         : say("run it again with --yes, which puts them back first");
    };
    if (report.result == TuneResult::Stopped)
        return fail(Fault::Unsafe,
            report.notPutBack.empty() ? say("the tuning was interrupted; the gains are as before")
                                      : say("the tuning was interrupted: %1", report.evidence),
            remedy(say("run it again")));
    if (report.result == TuneResult::RolledBack)
        return fail(Fault::Refused, say("no gains were kept: %1", report.evidence),
            remedy(say("look at its trials, try another --aim, or tune by hand with 'motorbenchctl step'")));
    if (report.result == TuneResult::Refused)
        return fail(Fault::Refused, say("refused: %1", report.evidence),
            remedy(say("remove the cause, or tune by hand with 'motorbenchctl step'")));
    return exitDone;
}

} // namespace mb::console
