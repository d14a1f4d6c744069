// SPDX-License-Identifier: GPL-3.0-or-later
// Which order is carried out by what.
#include "app/enginework.h"

namespace mb {
namespace {

/// One order on its way to its handler.
struct Clerk {
    EngineCore &core;
    const Reply &reply;

    [[nodiscard]] EngineCore::Finished finished() const { return reply.as<void>(); }
    void done() const { reply.give(Answer()); }

    void operator()(const orders::OpenLink &o) const { core.openLink(o.address, finished()); }
    void operator()(const orders::CloseLink &o) const { core.closeLink(o.link), done(); }
    void operator()(const orders::ScanLinks &) const { core.scanAll(), done(); }
    void operator()(const orders::ScanEverything &o) const { core.scanEverything(o.link), done(); }
    void operator()(const orders::CancelScan &o) const { core.cancelScan(o.link), done(); }
    void operator()(const orders::SendFrame &o) const { core.sendFrame(o.link, o.frame, finished()); }
    void operator()(const orders::ReadParameters &o) const { core.readParameters(o.device), done(); }
    void operator()(const orders::WriteParameters &o) const { core.writeParameters(o.device, o.changes, finished()); }
    void operator()(const orders::StoreParameters &o) const { core.storeParameters(o.device, finished()); }
    void operator()(const orders::RewriteSettings &o) const { core.rewriteSettings(o.device, finished()); }
    void operator()(const orders::RestoreParameters &o) const
    {
        core.restoreParameters(o.device, o.changes, finished());
    }
    void operator()(const orders::UndoWrite &o) const { core.undoWrite(o.device, o.again, finished()); }
    void operator()(const orders::KeepChange &o) const { core.provisional().keep(o.device, o.change, finished()); }
    void operator()(const orders::PutBackChange &o) const
    {
        core.provisional().putBack(o.device, o.change, finished());
    }
    void operator()(const orders::TakeSnapshot &o) const { core.takeSnapshot(o.device, o.name, finished()); }
    void operator()(const orders::Identify &o) const { core.identify(o.device, finished()); }
    void operator()(const orders::Rename &o) const { core.rename(o.device, o.name, finished()); }
    void operator()(const orders::Renumber &o) const { core.renumber(o.device, o.address, finished()); }
    void operator()(const orders::ClearFaults &o) const { core.clearFaults(o.device, finished()); }
    void operator()(const orders::Calibrate &o) const { core.calibrate(o.device, o.key, o.value, finished()); }
    void operator()(const orders::SetDialect &o) const { core.setDialect(o.device, o.key, finished()); }
    void operator()(const orders::SetRate &o) const { core.setRate(o.device, o.channel, o.hertz), done(); }
    void operator()(const orders::StartMotion &o) const
    {
        core.startMotion(o.device, o.setPoint, o.lease, finished(), o.glide);
    }
    void operator()(const orders::UpdateMotion &o) const
    {
        core.updateMotion(o.device, o.setPoint, finished(), o.glide);
    }
    void operator()(const orders::RenewMotion &o) const { core.renewMotion(o.device), done(); }
    void operator()(const orders::StopMotion &o) const { core.stopMotion(o.device), done(); }
    void operator()(const orders::ReleaseMoves &o) const { core.releaseMoves(o.device, finished()); }
    void operator()(const orders::ZeroPosition &o) const { core.zeroPosition(o.device, finished()); }
    void operator()(const orders::DismissStops &) const { core.dismissStops(), done(); }
    void operator()(const orders::RunExperiment &o) const { core.experiment(o.device, o.key, o.options, finished()); }
    void operator()(const orders::RunTrial &o) const
    {
        core.runTrial(o.device, o.plan, o.measured, reply.as<tuning::Trial>());
    }
    void operator()(const orders::RunTuning &o) const
    {
        core.runTuning(o.device, o.plan, reply.as<tuning::TuneReport>());
    }
    void operator()(const orders::RunSweep &o) const
    {
        core.runSweep(o.device, o.plan, o.plant, reply.as<tuning::FrequencyResponse>());
    }
    void operator()(const orders::PayGains &o) const { core.payGains(o.device, o.trial, finished()); }
    void operator()(const orders::DismissGains &o) const { core.dismissGains(o.device, o.trial, finished()); }
    void operator()(const orders::UpdateFirmware &o) const { core.update(o.device, o.image, o.options), done(); }
    void operator()(const orders::CancelOperation &o) const { core.cancel(o.operation), done(); }
    void operator()(const orders::StartRecording &o) const { core.startRecording(o.link, o.path, finished()); }
    void operator()(const orders::StopRecording &o) const { core.stopRecording(o.link), done(); }
    void operator()(const orders::SteerReplay &o) const { core.steerReplay(o.link, o.order), done(); }
};

} // namespace

void EngineCore::carryOut(const Order &order, const Reply &reply)
{
    std::visit(Clerk{*this, reply}, order);
}

} // namespace mb
