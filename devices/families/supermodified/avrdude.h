// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "transport/externalprogram.h"

#include <string>
#include <string_view>

/// avrdude as the programmer of the controller's ATmega328P: what it is asked for, and what its lines mean
/// (README.md#firmware). Pure functions. Only flash is ever written: no fuse, no lock bit.
namespace mb::supermodified::avrdude {

constexpr std::string_view scheme = "avrdude";
constexpr std::uint32_t flashSize = 0x8000;
constexpr std::uint32_t bootloaderStart = 0x7800;
/// The rate of the bootloader, and the real one of its clock.
constexpr int bootloaderRates[]{57600, 59524};

struct Job {
    std::string programmer; ///< of `avrdude -c`: arduino, stk500v1, usbasp, avrispmkii …
    std::string port;       ///< of `avrdude -P`: a device, or usb
    std::string file;       ///< Intel HEX
    int rate = 0;           ///< of the bootloader; 0: not asked for

    /// Through the serial bootloader rather than the programming pins.
    [[nodiscard]] bool isBootloader() const { return programmer == "arduino" || programmer == "stk500v1"; }
};

/// `--via avrdude:PROGRAMMER:PORT`. OutOfRange with what is legal.
[[nodiscard]] Result<Job> jobOf(std::string_view via);
[[nodiscard]] ExternalProgram::Command commandOf(const Job &job);

enum class Stage { Connecting, Erasing, Writing, Verifying };
[[nodiscard]] Message titleOf(Stage stage);

/// Reads the output, line by line, growing bars included.
class Reading {
public:
    /// `complete`: the line has ended.
    void take(std::string_view line, bool complete);
    [[nodiscard]] Stage stage() const { return m_stage; }
    /// Of the stage, 0…100.
    [[nodiscard]] int percent() const { return m_percent; }
    [[nodiscard]] bool isVerified() const { return m_verified; }
    /// Nothing was written yet: another attempt does no harm.
    [[nodiscard]] bool hasBegun() const { return m_stage > Stage::Connecting; }
    /// What went wrong, as one line for people with its remedy, once the program has ended without success.
    [[nodiscard]] Error failure(const Job &job) const;

private:
    Stage m_stage = Stage::Connecting;
    int m_percent = 0;
    bool m_verified = false;
    std::string m_lastError;
    std::string m_all; ///< lower case, for what is looked for
};

} // namespace mb::supermodified::avrdude
