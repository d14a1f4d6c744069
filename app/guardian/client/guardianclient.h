// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/client/guardianprocess.h"
#include "app/guardian/debts.h"
#include "model/motionguard.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace mb {

/// Starts motorbench-guardian, one process for each link that is under guard, and speaks with it. Window and console hand it to
/// their session. Needs the event loop of the thread that uses it.
class GuardianClient final : public MotionGuard {
public:
    /// `folder` is where guardians leave what they owe.
    explicit GuardianClient(
        std::string program = guardianBesideThisProgram(), std::string folder = guardian::debtFolder());
    ~GuardianClient() override;

    [[nodiscard]] Result<std::unique_ptr<GuardWatch>> watch(
        Link &link, const StopScript &script, const std::string &name) override;
    [[nodiscard]] std::optional<std::vector<OwedStop>> takeOver(Link &link, Instant now) override;
    void leave(const std::string &line) override { m_books.erase(line); }
    void settle(const std::string &line, const std::string &device) override;
    [[nodiscard]] bool isOwed(const std::string &line, const std::string &device) const override;

    /// Processes that serve a link now. For tests.
    [[nodiscard]] std::vector<pid_t> processes() const;

private:
    class Post;
    class Watch;

    [[nodiscard]] Result<std::shared_ptr<Post>> postAt(Link &link);
    void acted(const Post &post, const std::string &name, Verdict verdict);

    std::string m_program;
    std::string m_folder;
    std::map<std::string, std::unique_ptr<guardian::DebtBook>> m_books; ///< with the locks of lines that are open
    std::vector<std::shared_ptr<Post>> m_acting; ///< kept until they have said what became of a watch that was given up
    std::vector<std::weak_ptr<Post>> m_posts;
    std::shared_ptr<std::vector<pid_t>> m_ended; ///< to be reaped
    std::uint32_t m_lastId = 0;
};

} // namespace mb
