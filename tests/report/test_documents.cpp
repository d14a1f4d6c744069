// SPDX-License-Identifier: GPL-3.0-or-later
// Whole documents, compared line by line with those in tests/report/documents. MOTORBENCH_WRITE_DOCUMENTS=1 writes them anew.
#include "report/htmltext.h"
#include "support/sourcetree.h"
#include "wholereport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>

namespace mb::documents {
namespace {

std::string readFile(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void expectAsStored(const QString &text, const std::string &name)
{
    const std::string path = inSourceTree("tests/report/documents/" + name);
    const std::string now = text.toStdString();
    if (std::getenv("MOTORBENCH_WRITE_DOCUMENTS") != nullptr) {
        ASSERT_TRUE(std::ofstream(path, std::ios::binary) << now) << path;
        return;
    }
    const std::string stored = readFile(path);
    const auto [at, other] = std::mismatch(now.begin(), now.end(), stored.begin(), stored.end());
    if (at == now.end() && other == stored.end())
        return;
    const auto line = 1 + std::count(now.begin(), at, '\n');
    const auto place = static_cast<std::size_t>(at - now.begin());
    const std::size_t from = place < 80 ? 0 : place - 80;
    ADD_FAILURE() << path << ':' << line << "\n  stored: " << stored.substr(from, 200)
                  << "\n  now:    " << now.substr(from, 200);
}

/// Documents tell times of the place where they are made.
struct Documents : ::testing::Test {
    void SetUp() override
    {
        ::setenv("TZ", "UTC", 1);
        ::tzset();
    }
};

TEST_F(Documents, AReportIsLineByLineAsStored)
{
    expectAsStored(htmlOf(wholeReport()), "report.html");
}

TEST_F(Documents, AServiceCardIsLineByLineAsStored)
{
    expectAsStored(cardHtmlOf(wholeReport()), "card.html");
}

TEST_F(Documents, LabelsAreLineByLineAsStored)
{
    Report report = wholeReport();
    report.units.push_back(report.units.front());
    report.units.back().simulated = false;
    report.units.back().visits.resize(2);
    expectAsStored(labelHtmlOf(report), "labels.html");
}

TEST_F(Documents, AHistoryHasItsNewestSixtyTrials)
{
    Report report = wholeReport();
    std::vector<KeptTrial> &history = report.units.front().history;
    history.assign(60, stepTrial());
    history.front().number = 4711;
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral("4711*")));
    EXPECT_FALSE(htmlOf(report).contains(QStringLiteral("The newest")));
    history.push_back(stepTrial());
    EXPECT_FALSE(htmlOf(report).contains(QStringLiteral("4711*")));
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral("The newest 60 of 61 trials.")));
}

TEST_F(Documents, AUnitHasATableOfParametersFromTheFirstThatIsKnown)
{
    Report report = wholeReport();
    report.units = {report.units[1]};
    std::vector<ParameterStore::Entry> &entries = report.units.front().parameters;
    entries.resize(report.units.front().family->parameters.size());
    EXPECT_FALSE(htmlOf(report).contains(QStringLiteral("<h2>Parameters</h2>")));
    entries[1] = {1, ParameterState::Stored};
    EXPECT_TRUE(htmlOf(report).contains(QStringLiteral("<h2>Parameters</h2>")));
}

TEST(Figures, VeryLargeAndVerySmallOnesHaveAPowerOfTen)
{
    EXPECT_EQ(figure(0.00002, 3).toStdString(), "2e−05");
    EXPECT_EQ(figure(-3.25e12, 3).toStdString(), "−3.25e+12");
    EXPECT_EQ(figure(0.0001, 2).toStdString(), "0.00010");
}

} // namespace
} // namespace mb::documents
