// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/parametertransfer.h"
#include "model/setpointstream.h"
#include "service/selftest.h"
#include "service/servicesurroundings.h"

namespace mb::service {

/// What a visit has come to that is refused by its preflight: once a step before a cut has written to the unit, it has failed.
[[nodiscard]] Outcome outcomeOfRefusal(const Visit &visit);

/// One unit under one recipe: its steps, and what they share. Lives in the frame of serveUnit().
class UnitRun {
public:
    UnitRun(Device &device, SetPointStream &stream, Visit visit, ServiceSurroundings surroundings, Progress &progress);

    /// All steps; fails with the first that did.
    [[nodiscard]] Task<void> serve();
    /// The verdict into the journal.
    [[nodiscard]] Task<Visit> conclude(Outcome outcome, Error error);
    [[nodiscard]] const Visit &visit() const { return m_visit; }
    /// The journal could not be written.
    [[nodiscard]] const std::optional<Error> &journalError() const { return m_journalError; }

private:
    using Work = Task<Message> (UnitRun::*)();
    [[nodiscard]] Task<void> perform(Step step, Work work);
    [[nodiscard]] Task<void> write();
    [[nodiscard]] bool isEnded(Step step) const;
    [[nodiscard]] bool hasImage() const;
    [[nodiscard]] bool storesByItself() const;

    // Each yields what came of it, one clause.
    [[nodiscard]] Task<Message> look();
    [[nodiscard]] Task<Message> backUp();
    [[nodiscard]] Task<Message> update();
    [[nodiscard]] Task<Message> setParameters();
    [[nodiscard]] Task<Message> test();
    [[nodiscard]] Task<Message> giveNumber();
    [[nodiscard]] Task<Message> prove();

    [[nodiscard]] Task<void> meet();
    [[nodiscard]] Task<UpdateReport> runUpdate();
    [[nodiscard]] Result<void> goesOn(Message whatStops) const;
    [[nodiscard]] Task<TestFinding> testOnce();
    [[nodiscard]] Task<int> reserve();
    [[nodiscard]] Task<void> standBy();
    [[nodiscard]] Result<void> isSame() const;
    [[nodiscard]] Task<void> readAll();
    [[nodiscard]] bool isMissing(const ParameterChange &change) const;
    [[nodiscard]] bool isUnreadable(const ParameterChange &change) const;
    [[nodiscard]] Message proofOf(bool stores) const;
    [[nodiscard]] int others() const;

    Device &m_device;
    SetPointStream &m_stream;
    Visit m_visit;
    ServiceSurroundings m_around;
    Progress &m_progress;
    const Instant m_begun;
    const double m_earlier;                      ///< s, of what was cut off
    std::vector<ParameterStore::Entry> m_before; ///< in table order, of the backup
    const std::size_t m_trusted;                 ///< the first of the visit's steps that are known to be of this unit
    std::vector<ParameterIndex> m_later;         ///< written, and neither in force nor told before its next power cycle
    std::optional<double> m_start;               ///< counts, where its self-test began
    bool m_wrote = false;
    std::optional<Error> m_journalError;
};

} // namespace mb::service
