// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of an update around answers that come late: none may be taken for the answer to a later order. And its pages, with a
// bootloader that answers each as a script says.
#include "dmc60ccontrollerfixture.h"
#include "families/dmc60c/pagewriter.h"
#include "families/dmc60c/updatecontact.h"
#include "support/hextext.h"
#include "support/simulatedsession.h"

#include <string>
#include <utility>

namespace mb::dmc60c {
namespace {

class Dmc60cContact : public Dmc60cController {
protected:
    Dmc60cContact()
        : m_tap(host.traffic().add([this](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent && toText(*traffic.can).starts_with("0206FC05"))
                lastSent = clock.now();
        }))
    {
    }
    /// How long an order waits before it is sent; its answer is `status`, or none.
    Duration waits(Command command)
    {
        const Instant begin = clock.now();
        lastSent = {};
        Task<VendorReply> task = contact.order(command);
        task.start();
        EXPECT_TRUE(clock.runUntil([this] { return lastSent != Instant{}; }, 10s));
        const Duration waited = lastSent - begin;
        EXPECT_TRUE(clock.runUntil([&task] { return task.isFinished(); }, 10s));
        answered = task.result().has_value();
        return waited;
    }
    UpdateContact contact{*device};
    Instant lastSent{};
    bool answered = false;

private:
    Subscription m_tap;
};

TEST_F(Dmc60cContact, AfterAnOrderWithoutAnswerTheNextOneWaitsUntilNoneCanComeAnyMore)
{
    unit.answer(getVersions, {versionsReply});
    EXPECT_LT(waits(Command::FlashLEDs), 1ms);
    EXPECT_FALSE(answered);
    EXPECT_LT(waits(Command::GetFwver), 1ms) << "a question has an answer of its own kind";
    EXPECT_TRUE(answered);
    Timer late(clock);
    late.startIn(400ms, [this] { unit.send("0206FCC5#00000000"); });
    const Duration waited = waits(Command::FlashLEDs);
    EXPECT_GE(waited, 900ms) << "half a second after the last late answer";
    EXPECT_LT(waited, 910ms);
}

TEST_F(Dmc60cContact, AnswersOfAnotherUnitAreNotWaitedFor)
{
    EXPECT_LT(waits(Command::FlashLEDs), 1ms);
    Timer late(clock);
    late.startIn(400ms, [this] { unit.send("0206FCC6#00000000"); });
    const Duration waited = waits(Command::FlashLEDs);
    EXPECT_GE(waited, 500ms);
    EXPECT_LT(waited, 510ms);
}

TEST_F(Dmc60cContact, AUnitIsNotFoundAgainBeforeItsProductIsKnown)
{
    const std::string product = "0206F005#341203012060";
    const std::string versions = "0206F005#3412000017010901";
    unit.answer(enumeration, {{versions}, {product, versions}}, 5ms);
    Task<UpdateContact::Unit> task = contact.findAgain(1s);
    task.start();
    ASSERT_TRUE(clock.runUntil([&task] { return task.isFinished(); }, 2s));
    const auto found = task.result();
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ(found->productId.value_or(0) >> 20U, productDmc60c)
        << "a lost frame does not skip the check of the image";
}

TEST_F(Dmc60cContact, WhatOtherHostsAreAnsweredDoesNotKeepAnOrderWaiting)
{
    Timer others(clock);
    std::function<void()> chatter = [&] {
        unit.send("0206FCC5#00000000"); // no versions follow
        others.startIn(100ms, chatter);
    };
    chatter();
    const Instant begin = clock.now();
    Task<VendorReply> task = contact.order(Command::GetFwver);
    task.start();
    ASSERT_TRUE(clock.runUntil([&task] { return task.isFinished(); }, 5s)) << "for ever";
    EXPECT_FALSE(task.result());
    EXPECT_LT(clock.now() - begin, 1s) << "three times a quarter of a second";
}

TEST_F(Dmc60cContact, WhereEveryOrderWasAnsweredNoneWaits)
{
    unit.answer(getVersions, {versionsReply});
    for (int i = 0; i < 3; ++i)
        EXPECT_LT(waits(Command::GetFwver), 1ms);
    contact.noteAnswerOwed();
    EXPECT_LT(waits(Command::GetFwver), 1ms);
    EXPECT_GE(waits(Command::FlashLEDs), 500ms) << "somebody else has noticed that one is owed";
}

/// What the bootloader says to one order of a page, and how long after it; an empty text is silence.
struct PageAnswer {
    std::string status;
    Duration after = 100ms;
};
const PageAnswer pageIsIn{"0206FCC5#00000000"};
const PageAnswer pageIsDamaged{"0206FCC5#05000000"};
const PageAnswer pageIsUnproved{"0206FCC5#06000000"};
const PageAnswer pageIsOutOfStep{"0206FCC5#03000000"};
const PageAnswer noPageAnswer{""};

struct PageLog final : Progress {
    void step(const Message &, int, int) override { }
    void part(int, PartState) override { }
    void log(Severity, const Message &) override { }
    void accepted(int pages, int retries) override { counts.emplace_back(pages, retries); }
    std::vector<std::pair<int, int>> counts;
};

/// Pages 30, 1 and 0.
class Dmc60cPageOrders : public Dmc60cContact {
protected:
    Dmc60cPageOrders()
        : m_reply(clock)
        , m_orders(host.traffic().add([this](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent && toText(*traffic.can).starts_with("0206FC05#3412F200"))
                answerPage(traffic.can->data[6]);
        }))
    {
        application.version = 0x0119;
        for (const int number : {30, 1, 0}) {
            Page page;
            page.number = number;
            application.pages.push_back(page);
        }
    }
    Result<PageWriter::End> write(std::vector<PageAnswer> answers)
    {
        m_answers = std::move(answers);
        PageWriter writer(contact, application, log);
        return run(writer.writeAll());
    }
    void runs(const std::string &versions)
    {
        unit.answer(getVersions, {{"0206FCC5#00000600", "0206FC85#" + versions}});
    }

    Application application;
    PageLog log;
    std::vector<int> sent;

private:
    void answerPage(int page)
    {
        sent.push_back(page);
        const PageAnswer answer = sent.size() <= m_answers.size() ? m_answers[sent.size() - 1] : pageIsIn;
        if (!answer.status.empty())
            m_reply.startIn(answer.after, [this, status = answer.status] { unit.send(status); });
    }
    std::vector<PageAnswer> m_answers;
    Timer m_reply;
    Subscription m_orders;
};

TEST_F(Dmc60cPageOrders, TellAfterEveryPageHowManyAreInAndHowManyWereSentAgain)
{
    EXPECT_EQ(write({pageIsIn, pageIsDamaged}), Result<PageWriter::End>(PageWriter::End::Written));
    EXPECT_EQ(sent, (std::vector<int>{30, 1, 1, 0}));
    EXPECT_EQ(log.counts, (std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {3, 1}}));
}

TEST_F(Dmc60cPageOrders, KeepTheCrcThatTheBootloaderHasTakenOnce)
{
    (void)write({pageIsIn, pageIsDamaged, pageIsDamaged, pageIsDamaged, pageIsDamaged});
    EXPECT_EQ(sent, (std::vector<int>{30, 1, 1, 1, 1})) << "the page and three times again, whatever damages it";
}

TEST_F(Dmc60cPageOrders, OfAFlashThatFailsItsOwnCheckAreThreeForEachPage)
{
    EXPECT_EQ(write({pageIsUnproved, pageIsUnproved, pageIsIn, pageIsUnproved, pageIsUnproved, pageIsIn}),
        Result<PageWriter::End>(PageWriter::End::Written));
    EXPECT_EQ(sent, (std::vector<int>{30, 30, 30, 1, 1, 1, 0}));
    sent.clear();
    const auto end = write({pageIsUnproved, pageIsUnproved, pageIsUnproved});
    ASSERT_FALSE(end);
    EXPECT_EQ(end.error().fault, Fault::Refused);
    EXPECT_EQ(sent, (std::vector<int>{30, 30, 30})) << "a worn flash is not erased a fourth time";
}

TEST_F(Dmc60cPageOrders, OfABootloaderThatWasLeftOrResetMeanwhileStartAnew)
{
    for (const char *status : {"01", "04", "07"}) { // the application runs; it has been entered; it has been reset
        sent.clear();
        EXPECT_EQ(write({pageIsIn, {"0206FCC5#" + std::string(status) + "000000"}}),
            Result<PageWriter::End>(PageWriter::End::Restart))
            << status;
        EXPECT_EQ(sent, (std::vector<int>{30, 1})) << status << ": page 0 would have it start half a program";
    }
}

TEST_F(Dmc60cPageOrders, WhoseBytesAreOutOfStepAreSentFourTimesAtMost)
{
    EXPECT_EQ(write({pageIsIn, pageIsOutOfStep}), Result<PageWriter::End>(PageWriter::End::Written));
    EXPECT_EQ(sent, (std::vector<int>{30, 1, 1, 0}));
    EXPECT_EQ(log.counts, (std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {3, 1}}));
    sent.clear();
    const auto end = write({pageIsIn, pageIsOutOfStep, pageIsOutOfStep, pageIsOutOfStep, pageIsOutOfStep});
    ASSERT_FALSE(end);
    EXPECT_EQ(end.error().fault, Fault::Timeout);
    EXPECT_EQ(sent, (std::vector<int>{30, 1, 1, 1, 1}));
}

/// Its wire takes no time worth speaking of, so that an answer comes when it is sent.
class SaysOneMegabit final : public CanLink {
public:
    explicit SaysOneMegabit(VirtualCanBus &bus)
        : CanLink(*LinkAddress::parse("sim:can"), bus.clock())
        , m_port(*LinkAddress::parse("sim:can"), bus)
        , m_received(m_port.received().add([this](const CanFrame &frame) { deliver(frame); }))
    {
        EXPECT_TRUE(m_port.open());
    }
    ~SaysOneMegabit() override { close(); }

private:
    Result<void> doOpen() override { return {}; }
    void doClose() override { }
    Result<void> doSend(const CanFrame &frame, Priority priority) override { return m_port.send(frame, priority); }
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    [[nodiscard]] int doBitrate() const override { return 1'000'000; }

    VirtualCanLink m_port;
    Subscription m_received;
};

TEST_F(Dmc60cPageOrders, ThatAreSaidToBeWrittenBeforeTheirBytesCanHaveArrivedAreNot)
{
    constexpr Duration needed = 513 * 128us; // without any stuff bit
    for (const auto &[after, end] :
        {std::pair{needed - 300us, PageWriter::End::Restart}, {needed + 1us, PageWriter::End::Written}}) {
        VirtualCanBus fast(clock, 2'000'000'000, 1);
        SaysOneMegabit link(fast);
        ASSERT_TRUE(link.open());
        FakeUnit bootloader(fast, clock);
        const std::unique_ptr<Device> other = family.open(link, clock, identityOf5());
        UpdateContact talk(*other);
        Timer reply(clock);
        Instant ordered{};
        const Subscription orders = link.traffic().add([&, wait = after](const Traffic &traffic) {
            const std::string text = toText(*traffic.can);
            if (traffic.direction == Direction::Sent && text.starts_with("0206FC05#3412F200"))
                reply.startIn(wait, [&] { bootloader.send("0206FCC5#00000000"); });
            if (traffic.direction == Direction::Sent && text.starts_with("0206FC05#3412")
                && !text.starts_with("0206FC05#3412F200") && ordered == Instant{})
                ordered = clock.now();
        });
        application.pages.resize(1);
        PageWriter writer(talk, application, log);
        EXPECT_EQ(run(writer.writeAll()), Result<PageWriter::End>(end));
        const Instant begin = clock.now();
        (void)run(talk.order(Command::FlashLEDs));
        EXPECT_EQ(ordered - begin >= 500ms, end == PageWriter::End::Restart)
            << "the answer to the page itself is still to come";
    }
}

TEST_F(Dmc60cPageOrders, WithoutAnswerStartAnewWhereTheApplicationAnswersOrNobody)
{
    runs("000017010901"); // the application, version 1.23
    EXPECT_EQ(write({noPageAnswer}), Result<PageWriter::End>(PageWriter::End::Restart));
    unit.answer(getVersions, {{}});
    sent.clear();
    EXPECT_EQ(write({noPageAnswer}), Result<PageWriter::End>(PageWriter::End::Restart));
    EXPECT_EQ(sent, std::vector<int>{30});
}

TEST_F(Dmc60cPageOrders, OnlyPage0IsTakenForWrittenBecauseTheVersionIsThere)
{
    runs("010019010901"); // the bootloader, version 1.25
    EXPECT_EQ(write({noPageAnswer}), Result<PageWriter::End>(PageWriter::End::Written));
    EXPECT_EQ(sent, (std::vector<int>{30, 30, 1, 0})) << "the version is there already: a forced update to the same";
    sent.clear();
    EXPECT_EQ(write({pageIsIn, pageIsIn, noPageAnswer}), Result<PageWriter::End>(PageWriter::End::Written));
    EXPECT_EQ(sent, (std::vector<int>{30, 1, 0}));
}

TEST(Dmc60cEntry, AUnitThatWaitedInItsBootloaderByItselfIsNotResetWhenItsAnswerIsLost)
{
    mb::test::SimulatedSession bench("sim:can", "dmc60c:9,session=0x1234,state=bootloader");
    ASSERT_EQ(bench.scan().size(), 4U);
    int entries = 0;
    int resets = 0;
    const Subscription watching = bench.link->traffic().add([&](const Traffic &traffic) {
        const std::string frame = toText(*traffic.can);
        entries += frame.starts_with("0206FC09#3412F0") ? 1 : 0;
        resets += frame.starts_with("0206FC09#3412F1") ? 1 : 0;
        if (entries > 0)
            bench.simulator("dmc60c:9")->setPowered(false);
    });
    Device &device = *bench.device(9);
    const auto image = FirmwareImage::fromIntelHex(mb::test::smallApplication(0x0119).text());
    NoProgress progress;
    const auto report = mb::test::run(bench.clock, device.family().update(device, *image, {}, progress), 10min);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->outcome, UpdateOutcome::Failed);
    EXPECT_GT(entries, 0);
    EXPECT_EQ(resets, 0) << "it has no application that could be given back";
}

} // namespace
} // namespace mb::dmc60c
