// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatorparameters.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// What keeps its content without supply: configuration and application (README.md#updates).
namespace mb::dmc60c::simulation {

/// Pages 31 to 34. One write of all of it is one step of the sequence number.
struct ConfigImage {
    std::uint32_t sequence = 0;
    int number = 0;
    ParameterBank parameters;
    bool brake = true;                ///< setting of the button
    std::array<std::string, 6> texts; ///< by Descriptor − 1

    [[nodiscard]] std::string &text(Descriptor which) { return texts[static_cast<std::size_t>(which) - 1]; }
    /// The stream of GetDescriptors: id, count, characters; empty texts are left out.
    [[nodiscard]] std::vector<std::uint8_t> descriptors() const;
};

/// How the bootloader computes the check of a page (README.md#page-check).
enum class CrcVariant { A, B, C };
[[nodiscard]] std::uint32_t pageCrc(CrcVariant variant, std::span<const std::uint8_t> bytes);

/// Pages 0 to 30, and what the bootloader's RAM knows of an update. The caller does one step after the other with the
/// time each takes, so that a loss of supply in between leaves what a real device would be left with.
class ApplicationFlash {
public:
    explicit ApplicationFlash(std::uint16_t version)
        : m_version(version)
        , m_bytes(static_cast<std::size_t>(lastPage + 1) * pageSize)
    {
        std::ranges::fill(m_bytes, blank);
    }
    [[nodiscard]] std::uint16_t version() const { return m_version; }
    /// The bootloader starts after a reset.
    [[nodiscard]] bool isBootable() const { return m_resetVector; }
    /// Jumped to, it would run: its pages were not left half written, and its version did not come from empty RAM.
    [[nodiscard]] bool isRunnable() const;

    void erase(int page);
    /// The content of `page` but for what its successors in the sequence write; false when it does not verify.
    [[nodiscard]] bool program(int page, std::span<const std::uint8_t> bytes);
    /// After page 0: what page 30 brought becomes the version, zero when this RAM never saw page 30.
    void writeVersion();
    /// After any reset.
    void forgetRam() { m_savedVersion.reset(); }
    /// The next program() of `page` fails.
    void spoil(int page) { m_spoiled = page; }
    /// As it would be read out: what no page brought is blank, every fourth byte 0.
    [[nodiscard]] std::vector<std::uint8_t> bytes() const;

private:
    static constexpr std::uint8_t blank = 0xFF;

    std::uint16_t m_version;
    std::vector<std::uint8_t> m_bytes;
    bool m_resetVector = true;
    std::array<bool, lastPage + 1> m_broken{};
    std::optional<std::uint32_t> m_savedVersion; ///< the whole word
    bool m_versionFromNowhere = false;
    int m_spoiled = -1;
};

/// Flash of the microcontroller: the processor waits for it.
constexpr auto eraseTime = std::chrono::microseconds(23100);
constexpr auto writeTime = std::chrono::milliseconds(54);
constexpr auto versionWriteTime = std::chrono::microseconds(100);

} // namespace mb::dmc60c::simulation
