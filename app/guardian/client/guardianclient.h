// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/client/guardianprocess.h"
#include "model/motionguard.h"

#include <memory>
#include <vector>

namespace mb {

/// Starts motorbench-guardian, one process for each link that is under guard, and speaks with it. Window and console hand it to
/// their session. Needs the event loop of the thread that uses it.
class GuardianClient final : public MotionGuard {
public:
    explicit GuardianClient(std::string program = guardianBesideThisProgram());
    ~GuardianClient() override;

    [[nodiscard]] Result<std::unique_ptr<GuardWatch>> watch(
        Link &link, const StopScript &script, const std::string &name) override;

    /// Processes that serve a link now. For tests.
    [[nodiscard]] std::vector<pid_t> processes() const;

private:
    class Post;
    class Watch;

    [[nodiscard]] Result<std::shared_ptr<Post>> postAt(Link &link);

    std::string m_program;
    std::vector<std::weak_ptr<Post>> m_posts;
    std::shared_ptr<std::vector<pid_t>> m_ended; ///< to be reaped
    std::uint32_t m_lastId = 0;
};

} // namespace mb
