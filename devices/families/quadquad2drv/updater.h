// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/bootconsole.h"
#include "families/quadquad2drv/bootsettings.h"
#include "model/device.h"
#include "model/family.h"

namespace mb::quadquad2drv {

/// One update over the bootloader's serial line (README.md#firmware). Everything outlives the task of run().
class Updater {
public:
    Updater(
        Device &device, SerialLink &link, const FirmwareImage &image, Progress &progress, BootSettings settings = {});

    [[nodiscard]] Task<UpdateReport> run(bool dryRun);

private:
    /// Those of Family::routes.
    enum class Step { CloseJumper, Reset, Greeting, Sending, OpenJumper, Compare };

    [[nodiscard]] Task<void> openLine();
    [[nodiscard]] Task<void> awaitBanner();
    [[nodiscard]] Task<void> sendAll();
    [[nodiscard]] Task<void> sendLine(std::size_t index);
    [[nodiscard]] Result<void> checkAnswer(std::size_t index, const std::string &answer);
    [[nodiscard]] Task<void> leave();
    [[nodiscard]] Task<void> verify();
    void tell(const std::string &text) { m_progress.log(Severity::Info, Message::verbatim("> " + text)); }
    void heard(const std::string &text);
    void resetBoard();
    void enter(Step step) { m_progress.part(static_cast<int>(step), PartState::Active); }
    void leaveStep(Step step) { m_progress.part(static_cast<int>(step), PartState::Done); }
    void hearBoot();
    [[nodiscard]] bool isFailure(const std::string &text) const;
    [[nodiscard]] bool isBanner(const std::string &text) const;
    [[nodiscard]] UpdateReport failed(const Error &error) const;

    Device &m_device;
    SerialLink &m_link;
    Clock &m_clock;
    const FirmwareImage &m_image;
    Progress &m_progress;
    BootSettings m_settings;
    BootConsole m_console;
    UpdateReport m_report;
    std::size_t m_sent = 0;
};

} // namespace mb::quadquad2drv
