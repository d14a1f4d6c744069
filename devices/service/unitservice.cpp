// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/unitservice.h"

#include "service/unitrun.h"

namespace mb::service {
namespace {

bool isSilence(Fault fault)
{
    return fault == Fault::Timeout || fault == Fault::LinkLost || fault == Fault::BadReply;
}

} // namespace

Task<Visit> serveUnit(
    Device &device, SetPointStream &stream, Visit visit, ServiceSurroundings surroundings, Progress &progress)
{
    UnitRun run(device, stream, std::move(visit), std::move(surroundings), progress);
    const Result<void> served = co_await run.serve().attempt();
    if (!served && served.error().fault == Fault::Cancelled)
        co_return fail(served.error());
    if (run.journalError())
        co_return fail(*run.journalError());
    if (served) {
        auto concluding = run.conclude(Outcome::Passed, {});
        co_return co_await std::move(concluding).attempt();
    }
    const bool isRefused = run.visit().step == Step::Preflight && !isSilence(served.error().fault);
    auto concluding = run.conclude(isRefused ? outcomeOfRefusal(run.visit()) : Outcome::Failed, served.error());
    co_return co_await std::move(concluding).attempt();
}

} // namespace mb::service
