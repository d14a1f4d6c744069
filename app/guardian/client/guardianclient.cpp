// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/client/guardianclient.h"

#include "app/guardian/client/wirescript.h"
#include "app/guardian/message.h"
#include "app/guardian/watchman.h"
#include "model/devicestop.h"

#include <QSocketNotifier>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <functional>
#include <map>

#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr int mostUnanswered = 10; // renewals, ten a second

} // namespace

/// One guardian process, and the link it can send on. Lives as long as a watch of it.
class GuardianClient::Post : public std::enable_shared_from_this<Post> {
public:
    using Acted = std::function<void(const Post &, const std::string &name, Verdict verdict)>;

    Post(Link &link, const GuardianProcess &process, std::shared_ptr<std::vector<pid_t>> ended, Acted acted)
        : m_link(link)
        , m_form(link.outlet().form)
        , m_process(process)
        , m_ended(std::move(ended))
        , m_acted(std::move(acted))
        , m_readable(std::make_unique<QSocketNotifier>(process.socket, QSocketNotifier::Read))
        , m_state(link.stateChanged().add([this](LinkState) { m_serves = false; })) // another descriptor from now on
    {
        QObject::connect(m_readable.get(), &QSocketNotifier::activated, m_readable.get(), [this] { receive(); });
    }
    Post(const Post &) = delete;
    Post &operator=(const Post &) = delete;
    ~Post()
    {
        m_readable->setEnabled(false);
        m_readable.release()->deleteLater(); // it may be what called us
        ::close(m_process.socket);
        m_ended->push_back(m_process.pid);
    }
    [[nodiscard]] bool serves(const Link &link) const { return m_serves && &m_link == &link; }
    [[nodiscard]] Outlet::Form form() const { return m_form; }
    [[nodiscard]] pid_t pid() const { return m_process.pid; }
    void add(std::uint32_t id, Watch &watch) { m_watches[id] = &watch; }
    void remove(std::uint32_t id) { m_watches.erase(id); }
    /// The guardian stops this device now, and will say how that went.
    void await(std::uint32_t id, const std::string &name) { m_awaited[id] = name; }
    [[nodiscard]] bool isAwaiting() const { return !m_awaited.empty(); }
    /// Nobody else is put under its guard.
    void distrust() { m_serves = false; }
    void say(const guardian::Order &order) const
    {
        const guardian::Bytes packet = guardian::encode(order);
        (void)::send(m_process.socket, packet.data(), packet.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    }

private:
    void receive();
    void hear(const guardian::Report &report);
    void mourn();

    Link &m_link;
    Outlet::Form m_form;
    GuardianProcess m_process;
    std::shared_ptr<std::vector<pid_t>> m_ended;
    bool m_serves = true;
    std::map<std::uint32_t, Watch *> m_watches;
    std::map<std::uint32_t, std::string> m_awaited;
    Acted m_acted;
    std::unique_ptr<QSocketNotifier> m_readable;
    Subscription m_state;
};

class GuardianClient::Watch final : public GuardWatch {
public:
    Watch(GuardianClient &client, std::shared_ptr<Post> post, std::uint32_t id, std::string name)
        : m_client(client)
        , m_post(std::move(post))
        , m_id(id)
        , m_name(std::move(name))
    {
        m_post->add(id, *this);
    }
    ~Watch() override
    {
        m_post->remove(m_id);
        m_post->say({m_released ? guardian::Order::Kind::Forget : guardian::Order::Kind::Stop, m_id, {}, {}});
        if (m_released || state() != State::Standing)
            return;
        m_post->await(m_id, m_name);
        m_client.m_acting.push_back(m_post);
    }
    void renew() override
    {
        if (++m_unanswered <= mostUnanswered) {
            m_post->say({guardian::Order::Kind::Renew, m_id, {}, {}});
        } else if (state() == State::Standing) {
            m_post->distrust();
            enter(State::Gone, say("the guardian does not answer"));
        }
    }
    void release() override { m_released = true; }

    // Each may be the end of this object.
    void hear(const guardian::Report &report)
    {
        using Kind = guardian::Report::Kind;
        m_unanswered = 0;
        if (report.kind == Kind::Standing && state() == State::Called)
            enter(State::Standing);
        else if (report.kind == Kind::Acted)
            enter(State::Acted,
                report.proved ? say("the guardian stopped the motor because this program was held up")
                    : report.confirmed
                    ? say("the guardian sent the stop because this program was held up, not confirmed")
                    : say("the guardian tried to stop the motor because this program was held up, without an answer"));
        else if (report.kind == Kind::Refused)
            enter(State::Gone, say("the guardian is of another version"));
    }
    void mourn() { enter(State::Gone, say("the guardian ended unexpectedly")); }

private:
    GuardianClient &m_client;
    std::shared_ptr<Post> m_post;
    std::uint32_t m_id;
    std::string m_name;
    int m_unanswered = 0;
    bool m_released = false;
};

void GuardianClient::Post::receive()
{
    const auto self = shared_from_this();
    std::array<std::uint8_t, guardian::largestMessage> packet{};
    for (;;) {
        const ssize_t got = ::recv(m_process.socket, packet.data(), packet.size(), MSG_DONTWAIT);
        if (got < 0 && (errno == EAGAIN || errno == EINTR))
            return;
        if (got <= 0) {
            mourn();
            return;
        }
        if (const auto report = guardian::decodeReport({packet.data(), static_cast<std::size_t>(got)}))
            hear(*report);
    }
}

void GuardianClient::Post::hear(const guardian::Report &report)
{
    if (const auto watch = m_watches.find(report.id); watch != m_watches.end()) {
        watch->second->hear(report);
        return;
    }
    const auto awaited = m_awaited.find(report.id);
    if (awaited == m_awaited.end() || report.kind != guardian::Report::Kind::Acted)
        return;
    const std::string name = awaited->second;
    m_awaited.erase(awaited);
    m_acted(*this, name, report.proved ? Verdict::Confirmed : report.confirmed ? Verdict::Sent : Verdict::Failed);
}

void GuardianClient::Post::mourn()
{
    m_serves = false;
    m_readable->setEnabled(false);
    for (const auto &[id, name] : std::exchange(m_awaited, {}))
        m_acted(*this, name, Verdict::Failed);
    while (!m_watches.empty()) {
        Watch *const watch = m_watches.begin()->second;
        m_watches.erase(m_watches.begin());
        watch->mourn();
    }
}

GuardianClient::GuardianClient(std::string program, std::string folder)
    : m_program(std::move(program))
    , m_folder(std::move(folder))
    , m_ended(std::make_shared<std::vector<pid_t>>())
{
}

GuardianClient::~GuardianClient()
{
    m_acting.clear(); // their guardians act all the same
    reap(*m_ended);
}

Result<std::unique_ptr<GuardWatch>> GuardianClient::watch(Link &link, const StopScript &script, const std::string &name)
{
    MB_TRY(const auto post, postAt(link));
    guardian::Order order{guardian::Order::Kind::Watch, ++m_lastId, name, {}};
    order.script = wireScript(script, post->form());
    const guardian::Bytes packet = guardian::encode(order);
    if (packet.size() > guardian::largestMessage || guardian::decodeOrder(packet) != order)
        return fail(Fault::Unsafe, say("the stop script of this device is not one that a guardian can carry out"));
    auto watch = std::make_unique<Watch>(*this, post, order.id, name);
    post->say(order);
    return watch;
}

Result<std::shared_ptr<GuardianClient::Post>> GuardianClient::postAt(Link &link)
{
    reap(*m_ended);
    std::erase_if(m_posts, [](const std::weak_ptr<Post> &post) { return post.expired(); });
    for (const std::weak_ptr<Post> &known : m_posts) {
        if (auto post = known.lock(); post && post->serves(link))
            return post;
    }
    const std::string &line = link.line();
    MB_TRY_VOID(bookIsUsable(line));
    // a terminal or socket by its whole path: the guardian has another working directory
    const std::string name = line.starts_with('/') ? link.address().path : line.substr(line.find(':') + 1);
    MB_TRY(const auto process, startGuardian(m_program, {link.outlet(), m_folder, line, name}));
    auto post = std::make_shared<Post>(link, process, m_ended,
        [this](const Post &from, const std::string &device, Verdict verdict) { acted(from, device, verdict); });
    m_posts.push_back(post);
    return post;
}

/// Takes it as well: a guardian may have been about to pay when the link was opened.
Result<void> GuardianClient::bookIsUsable(const std::string &line)
{
    const auto account = m_accounts.find(line);
    if (account == m_accounts.end() || account->second.book.claim() != guardian::DebtBook::Claim::Unusable)
        return {};
    return fail(Fault::Unsafe,
        say("a stop that is owed cannot be written down: %1 cannot be used", account->second.book.folder()),
        say("it must be a folder of yours that nobody else may write to"));
}

void GuardianClient::acted(const Post &post, const std::string &name, Verdict verdict)
{
    tellActed(name, verdict);
    std::erase_if(
        m_acting, [&post](const std::shared_ptr<Post> &one) { return one.get() == &post && !one->isAwaiting(); });
}

bool GuardianClient::own(Link &link)
{
    const Outlet outlet = link.outlet();
    if (!outlet.isInheritable())
        return true;
    Account &account = m_accounts.try_emplace(link.line(), m_folder, link.line()).first->second;
    account.form = outlet.form;
    return account.book.claim() != guardian::DebtBook::Claim::Others;
}

void GuardianClient::leave(const std::string &line)
{
    if (const auto account = m_accounts.find(line); account != m_accounts.end())
        account->second.book.disown();
}

std::vector<OwedStop> GuardianClient::owed(Instant now) const
{
    std::vector<OwedStop> all;
    for (auto &[line, account] : m_accounts) {
        if (account.book.exists() || account.book.isSettled())
            account.known = account.book.read();
        for (const guardian::Debt &debt : account.known) {
            const auto age = guardian::runTime() - debt.since;
            const Instant since = now - (age.count() < 0 ? DeviceStop::debtLimit : Duration(age));
            all.push_back({line, debt.name, scriptFromWire(debt.script, account.form), since});
        }
    }
    return all;
}

bool GuardianClient::owe(const OwedStop &stop, Instant now)
{
    const auto account = m_accounts.find(stop.line);
    const auto age = std::chrono::duration_cast<std::chrono::milliseconds>(now - stop.since);
    return account != m_accounts.end()
        && account->second.book.add(
            {stop.device, wireScript(stop.script, account->second.form), guardian::runTime() - age});
}

void GuardianClient::settle(const std::string &line, const std::string &device)
{
    guardian::DebtBook(m_folder, line).remove(device);
    if (const auto account = m_accounts.find(line); account != m_accounts.end())
        std::erase_if(account->second.known,
            [&device](const guardian::Debt &debt) { return guardian::unitOf(debt.name) == guardian::unitOf(device); });
}

std::vector<pid_t> GuardianClient::processes() const
{
    std::vector<pid_t> all;
    for (const std::weak_ptr<Post> &known : m_posts) {
        if (const auto post = known.lock())
            all.push_back(post->pid());
    }
    return all;
}

} // namespace mb
