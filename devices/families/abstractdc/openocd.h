// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "transport/externalprogram.h"

#include <string>
#include <string_view>

/// OpenOCD as the programmer of the drive: what it is asked for, and what its lines mean
/// (README.md#firmware). Pure functions.
namespace mb::abstractdc::openocd {

struct Job {
    std::string
        interface;      ///< name of a file below `interface/` of OpenOCD, without its ending: stlink, jlink, cmsis-dap
    std::string target; ///< f1, f4
    std::string file;   ///< Intel HEX
    bool eraseSettings = false;
};

/// `--via openocd:INTERFACE` and `--target`: OutOfRange with what is legal.
[[nodiscard]] Result<Job> jobOf(std::string_view via, std::string_view target);
[[nodiscard]] ExternalProgram::Command commandOf(const Job &job);

/// How far a run has come, in the order of the steps.
enum class Stage { Connecting, Erasing, Writing, Verifying, Resetting, Over };
[[nodiscard]] Message titleOf(Stage stage);

/// Reads the output line by line.
class Reading {
public:
    void take(std::string_view line);
    [[nodiscard]] Stage stage() const { return m_stage; }
    [[nodiscard]] bool isVerified() const { return m_verified; }
    [[nodiscard]] bool isErased() const { return m_erased; }
    /// What went wrong, as one line for people with its remedy, once the program has ended without success.
    [[nodiscard]] Error failure(const Job &job) const;

private:
    Stage m_stage = Stage::Connecting;
    bool m_verified = false;
    bool m_erased = false;
    std::string m_firstError;
    std::string m_all; ///< lower case, for what is looked for
};

} // namespace mb::abstractdc::openocd
