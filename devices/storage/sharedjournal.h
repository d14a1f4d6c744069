// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/background.h"
#include "async/listeners.h"
#include "async/scope.h"
#include "storage/journalserver.h"
#include "storage/servicebook.h"

#include <functional>

namespace mb {

/// The journal of a station that shares it with others: every entry is in the station's own file first, and goes to the server as
/// soon as that answers, once each. Numbers come from the server in blocks of five; without it the station uses up its own.
/// Thread of the book, which outlives it, as the background does.
class SharedJournal final : public service::ServiceJournal {
public:
    /// What waits for the server does it in the background; nullptr: at once, in this thread.
    SharedJournal(ServiceBook &book, JournalServer server, Clock &clock, Background *background);

    [[nodiscard]] Task<service::Visit> open(service::Visit visit) override;
    [[nodiscard]] Task<service::Visit> write(service::Visit visit) override;
    [[nodiscard]] Task<std::vector<service::Visit>> visits(service::VisitFilter filter) override;
    [[nodiscard]] Task<std::optional<int>> number(service::NumberWish wish) override;

    /// Everything that waits, now; fails when the server does not take it. Also by itself after every write, and every 5 s
    /// while something waits.
    [[nodiscard]] Task<void> deliver();
    /// The same without waiting for it: changed() tells what became of it.
    void deliverSoon();
    /// Entries that the server has not got as they are.
    [[nodiscard]] int waiting() const;
    /// Why the server did not take them last; empty detail: it did.
    [[nodiscard]] const Error &trouble() const { return m_trouble; }
    /// The count or the trouble changed.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

private:
    [[nodiscard]] Task<void> deliverBatch(std::vector<KeptVisit> batch);
    template <class Answer>
    [[nodiscard]] Task<Answer> askServer(std::function<Result<Answer>(const JournalServer &)> what);
    [[nodiscard]] Task<std::optional<int>> recalled(service::NumberWish wish, std::string here);
    /// When it was last asked for something.
    [[nodiscard]] bool isSilent() const { return m_trouble.fault == Fault::Timeout && !m_trouble.detail.empty(); }
    /// Where numbers of this server lie in the station's file: those that the file gives by itself are other ones.
    [[nodiscard]] std::string hereOf(const std::string &scope) const { return scope + '@' + m_server.url(); }
    [[nodiscard]] Result<std::string> tokenFor(const std::string &scope);

    ServiceBook &m_book;
    JournalServer m_server;
    Clock &m_clock;
    Background *m_background;
    Error m_trouble;
    int m_batchSize;
    bool m_isDelivering = false;
    bool m_isBehind = false; ///< something was written while it delivered
    Listeners<> m_changed;
    Timer m_again;
    Scope m_scope;
};

} // namespace mb
