// SPDX-License-Identifier: GPL-3.0-or-later
// Drives in somebody else's traffic. Identifiers and codes are written out.
#include "families/abstractdc/recognition.h"

#include <gtest/gtest.h>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

class Bus {
public:
    /// Who answered with it: "+3 F", "+3" without proof, "" for nobody.
    std::string pass(const std::string &text, Duration after = 1ms)
    {
        m_time += after;
        CanFrame frame = canFrameFromText(text).value();
        frame.time = m_time;
        m_last = m_recognition.take(frame);
        if (!m_last)
            return {};
        return '+' + std::to_string(m_last->address) + (m_last->dialect.empty() ? "" : ' ' + m_last->dialect);
    }
    std::string exchange(const std::string &question, const std::string &answer)
    {
        EXPECT_EQ(pass(question), "");
        return pass(answer);
    }
    [[nodiscard]] const Identity &last() const { return *m_last; }

private:
    Recognition m_recognition;
    Instant m_time{};
    std::optional<Identity> m_last;
};

// Hexadecimal: 384 is 900, 320 is 800.

TEST(AbstractDcRecognition, TellsEveryDialectByAQuestionAndTheIdentifierOfItsAnswer)
{
    EXPECT_EQ(Bus().exchange("387#03", "603#00020000"), "+3 F") << "temperature on 1539";
    EXPECT_EQ(Bus().exchange("387#00", "483#C8000000"), "+3 F") << "position on 1155";
    EXPECT_EQ(Bus().exchange("387#04", "680#64000000"), "+3 F") << "voltage on 1664, without its offset";
    EXPECT_EQ(Bus().exchange("388#00", "450#C8000000"), "+4 L") << "position on 1104";
    EXPECT_EQ(Bus().exchange("388#02", "4B4#00020000"), "+4 L") << "current on 1204";
    EXPECT_EQ(Bus().exchange("389#04", "485#C8000000"), "+5 D") << "position on 1157, by the document's code";
    EXPECT_EQ(Bus().exchange("389#03", "505#00020000"), "+5 D") << "current on 1285, by the document's code";
    EXPECT_EQ(Bus().exchange("322#00", "44E#00000000"), "+2 LL") << "asked on 802, answered on 1102";
    EXPECT_EQ(Bus().exchange("384#00", "480#00000000"), "+0 F") << "900 is offset 0, too";
    EXPECT_EQ(Bus().exchange("3E7#00", "4E3#00000000"), "+99 F") << "999 is the last offset";
    EXPECT_EQ(Bus().exchange("320#00", "44C#00000000"), "+0 LL") << "800 is the first of the oldest";
}

TEST(AbstractDcRecognition, KnowsTheOffsetOnlyWhereSeveralDialectsAnswerAlike)
{
    Bus bus;
    EXPECT_EQ(bus.exchange("387#01", "403#F4010000"), "+3") << "speed on 1027 is F or D";
    EXPECT_NE(bus.last().detail.english().find("does not tell which codes"), std::string::npos);
    EXPECT_EQ(bus.exchange("387#03", "603#00020000"), "+3 F");
    EXPECT_EQ(bus.exchange("387#01", "403#F4010000"), "+3 F") << "what was proven stays";
}

TEST(AbstractDcRecognition, TakesNothingForADriveThatWasNotAsked)
{
    EXPECT_EQ(Bus().pass("483#C8000000"), "") << "an answer without a question";
    EXPECT_EQ(Bus().exchange("387#00", "484#C8000000"), "") << "another's answer";
    EXPECT_EQ(Bus().exchange("387#00", "483#C80000"), "") << "too short";
    EXPECT_EQ(Bus().exchange("387#0000", "483#C8000000"), "") << "no question";
    EXPECT_EQ(Bus().exchange("387#09", "483#C8000000"), "") << "no dialect has this code";
    EXPECT_EQ(Bus().exchange("00000387#00", "483#C8000000"), "") << "29 bits";
    Bus bus;
    bus.pass("387#00");
    EXPECT_EQ(bus.pass("483#C8000000", 1100ms), "") << "too late";
    EXPECT_EQ(bus.exchange("387#00", "483#C8000000"), "+3 F");
}

TEST(AbstractDcRecognition, DoesNotGuessWhoAnsweredEverybody)
{
    Bus bus;
    EXPECT_EQ(bus.exchange("384#01", "403#F4010000"), "") << "1027 is F or D with 3, or L with 27";
    EXPECT_EQ(bus.pass("3EC#F4010000"), "+4 L") << "1004 is nobody else";
    EXPECT_EQ(bus.exchange("388#00", "450#C8000000"), "") << "1104 is L with 4, or the speed of 80 asked for before";
    EXPECT_EQ(bus.pass("388#00", 2s), "");
    EXPECT_EQ(bus.pass("450#C8000000"), "+4 L");
}

/// A scan and the poller ask the same; a recording of the simulated bench took the second answer for drive 80.
TEST(AbstractDcRecognition, KnowsTheSecondOfTwoAnswersToTheSameQuestion)
{
    Bus bus;
    bus.pass("384#01");
    bus.pass("388#00");
    bus.pass("388#00");
    EXPECT_EQ(bus.pass("450#00000000"), "");
    EXPECT_EQ(bus.pass("450#00000000"), "");
}

TEST(AbstractDcRecognition, SaysWhenDrivesOfTwoDialectsShareAnOffset)
{
    Bus bus;
    EXPECT_EQ(bus.exchange("388#00", "450#C8000000"), "+4 L");
    EXPECT_EQ(bus.last().state, DeviceState::Online);
    EXPECT_EQ(bus.exchange("388#00", "484#C8000000"), "+4 L");
    EXPECT_EQ(bus.last().state, DeviceState::Duplicate);
}

} // namespace
} // namespace mb::abstractdc
