// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/client/guardianclient.h"

#include "app/guardian/message.h"

#include <QSocketNotifier>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>

#include <linux/can.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr int mostUnanswered = 10; // renewals, ten a second

guardian::Bytes rawFrame(const CanFrame &frame)
{
    can_frame raw{};
    raw.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) | (frame.remote ? CAN_RTR_FLAG : 0U);
    raw.can_dlc = frame.size;
    std::memcpy(raw.data, frame.data.data(), frame.size);
    guardian::Bytes bytes(sizeof raw);
    std::memcpy(bytes.data(), &raw, sizeof raw);
    return bytes;
}

/// As it is written to the descriptor.
guardian::Step stepOf(const StopStep &step, Outlet::Form form)
{
    guardian::Step made{step.bytes, step.reply, step.replyMask, step.wait, step.attempts};
    if (made.mask.empty())
        made.mask.assign(made.reply.size(), 0xFF);
    if (form == Outlet::Form::CanSocket && step.frame)
        made.bytes = rawFrame(*step.frame);
    if (form == Outlet::Form::SpiSocket) { // product.md, `unix:`: as many bytes and the ready line come back
        const std::size_t size = step.bytes.size();
        made.bytes.insert(
            made.bytes.begin(), {static_cast<std::uint8_t>(size & 0xFFU), static_cast<std::uint8_t>(size >> 8U)});
        made.reply.assign(size + 1, 0);
        made.mask.assign(size + 1, 0);
    }
    return made;
}

} // namespace

/// One guardian process, and the link it can send on. Lives as long as a watch of it.
class GuardianClient::Post : public std::enable_shared_from_this<Post> {
public:
    Post(Link &link, const GuardianProcess &process, std::shared_ptr<std::vector<pid_t>> ended)
        : m_link(link)
        , m_form(link.outlet().form)
        , m_process(process)
        , m_ended(std::move(ended))
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
    std::unique_ptr<QSocketNotifier> m_readable;
    Subscription m_state;
};

class GuardianClient::Watch final : public GuardWatch {
public:
    Watch(std::shared_ptr<Post> post, std::uint32_t id)
        : m_post(std::move(post))
        , m_id(id)
    {
        m_post->add(id, *this);
    }
    ~Watch() override
    {
        m_post->remove(m_id);
        m_post->say({m_released ? guardian::Order::Kind::Forget : guardian::Order::Kind::Stop, m_id, {}, {}});
    }
    void renew() override
    {
        if (++m_unanswered <= mostUnanswered) {
            m_post->say({guardian::Order::Kind::Renew, m_id, {}, {}});
        } else if (state() == State::Standing) {
            m_post->distrust();
            enter(State::Gone, "the guardian does not answer");
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
                report.confirmed
                    ? "the guardian stopped the motor because this program was held up"
                    : "the guardian tried to stop the motor because this program was held up, without an answer");
        else if (report.kind == Kind::Refused)
            enter(State::Gone, "the guardian is of another version");
    }
    void mourn() { enter(State::Gone, "the guardian ended unexpectedly"); }

private:
    std::shared_ptr<Post> m_post;
    std::uint32_t m_id;
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
    if (const auto watch = m_watches.find(report.id); watch != m_watches.end())
        watch->second->hear(report);
}

void GuardianClient::Post::mourn()
{
    m_serves = false;
    m_readable->setEnabled(false);
    while (!m_watches.empty()) {
        Watch *const watch = m_watches.begin()->second;
        m_watches.erase(m_watches.begin());
        watch->mourn();
    }
}

GuardianClient::GuardianClient(std::string program)
    : m_program(std::move(program))
    , m_ended(std::make_shared<std::vector<pid_t>>())
{
}

GuardianClient::~GuardianClient()
{
    reap(*m_ended);
}

Result<std::unique_ptr<GuardWatch>> GuardianClient::watch(Link &link, const StopScript &script, const std::string &name)
{
    const auto post = postAt(link);
    if (!post)
        return fail(post.error());
    guardian::Order order{guardian::Order::Kind::Watch, ++m_lastId, name, {}};
    for (const StopStep &step : script.steps)
        order.script.push_back(stepOf(step, (*post)->form()));
    const guardian::Bytes packet = guardian::encode(order);
    if (packet.size() > guardian::largestMessage || guardian::decodeOrder(packet) != order)
        return fail(Fault::Unsafe, "the stop script of this device is not one that a guardian can carry out");
    auto watch = std::make_unique<Watch>(*post, order.id);
    (*post)->say(order);
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
    const auto process = startGuardian(m_program, link.outlet());
    if (!process)
        return fail(process.error());
    auto post = std::make_shared<Post>(link, *process, m_ended);
    m_posts.push_back(post);
    return post;
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
