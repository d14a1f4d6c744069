// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/client/guardianprocess.h"
#include "app/guardian/debts.h"
#include "model/motionguard.h"

#include <map>
#include <memory>
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
    [[nodiscard]] bool own(Link &link) override;
    void leave(const std::string &line) override;
    [[nodiscard]] std::vector<OwedStop> owed(Instant now) const override;
    bool owe(const OwedStop &stop, Instant now) override;
    void settle(const std::string &line, const std::string &device) override;

    /// Processes that serve a link now. For tests.
    [[nodiscard]] std::vector<pid_t> processes() const;

private:
    class Post;
    class Watch;
    struct Account {
        Account(const std::string &folder, const std::string &line)
            : book(folder, line)
        {
        }
        guardian::DebtBook book; ///< with the lock while the line is open here
        Outlet::Form form = Outlet::Form::None;
        std::vector<guardian::Debt> known; ///< as read last: a book may be taken away
    };

    [[nodiscard]] Result<std::shared_ptr<Post>> postAt(Link &link);
    [[nodiscard]] Result<void> bookIsUsable(const std::string &line);
    void acted(const Post &post, const std::string &name, Verdict verdict);

    std::string m_program;
    std::string m_folder;
    mutable std::map<std::string, Account> m_accounts; ///< by line
    std::vector<std::shared_ptr<Post>> m_acting; ///< kept until they have said what became of a watch that was given up
    std::vector<std::weak_ptr<Post>> m_posts;
    std::shared_ptr<std::vector<pid_t>> m_ended; ///< to be reaped
    std::uint32_t m_lastId = 0;
};

} // namespace mb
