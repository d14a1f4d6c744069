// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/parameterjobs.h"
#include "app/engine/scans.h"
#include "model/transcript.h"

namespace mb {

/// Firmware that is written, one update a bus, and the transcript of each. Engine thread.
class FirmwareUpdates {
public:
    FirmwareUpdates(const EngineContext &context, const ParameterJobs &parameters, Scans &scans);

    /// From now on the log of each update is kept in this folder, one file an update.
    void keepTranscripts(std::string folder) { m_folder = std::move(folder); }
    /// From now on they are written there. Outlives this.
    void setBackground(Background *background) { m_background = background; }

    void carryOut(const orders::UpdateFirmware &order, const Finished &finished);

private:
    [[nodiscard]] Task<UpdateReport> update(
        Device &device, std::shared_ptr<const FirmwareImage> image, UpdateOptions options, Progress &progress);
    void ended(Operations::Job &job, const Result<UpdateReport> &report, const Finished &finished);
    [[nodiscard]] const Device *updatedBeside(const Device &device) const;
    void saveTranscript(const Operations::Job &job, const Device &device);
    [[nodiscard]] Task<std::string> keep(Transcript transcript);

    EngineContext m_context;
    const ParameterJobs &m_parameters;
    Scans &m_scans;
    std::string m_folder; ///< of transcripts; empty: none are kept
    Background *m_background = nullptr;
    Scope m_files; ///< that are being written; last: its tasks use everything above
};

} // namespace mb
