// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/jsonlines.h"
#include "model/family.h"
#include "model/registry.h"
#include "model/unit.h"
#include "service/figuretext.h"
#include "service/goldenband.h"
#include "service/recipematter.h"
#include "service/reciperead.h"
#include "service/selftest.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <utility>

namespace mb::service {
namespace {

const QByteArray whole = R"({
  "recipe": 1,
  "name": "drive-base rev C",
  "family": "dmc60c",
  "firmware": {"file": "dmc60c-1.25.hex"},
  "parameters": {"file": "base_c.json", "store": true},
  "number": {"first": 10},
  "test": {
    "loop": "velocity", "from": 0, "to": 4000, "time": 0.8, "repeat": 1, "slot": 0,
    "limits": {"travel": 40000, "speed": 9000, "current": 20, "duty": 0.6},
    "accept": {
      "settle": 0.6,
      "sse": 0.02,
      "friction": [0.1, 0.4],
      "encoder": true
    }
  }
})";

Result<Recipe> parse(const QByteArray &text)
{
    return parseRecipe(text, families());
}

std::string mistakeIn(QByteArray text, const char *what, const char *with)
{
    text.replace(what, with);
    const auto parsed = parse(text);
    EXPECT_FALSE(parsed) << with;
    return parsed ? std::string() : parsed.error().text();
}

TEST(FigureText, HasThreeDigitsAndNoNoiseOfBinaryFractions)
{
    EXPECT_EQ(textOf(figureNumber("friction", 0.34618)), "0.346");
    EXPECT_EQ(textOf(figureNumber("friction", 0.0001)), "0.0001");
    EXPECT_EQ(textOf(figureNumber("sse", -0.0009163)), "-0.0916 %");
    EXPECT_EQ(textOf(figureNumber("peak_current", 46.12)), "46.1 A");
    EXPECT_EQ(textOf(figureNumber("gain", 4310.4)), "4310");
    for (int i = 1; i < 1000; ++i)
        EXPECT_LE(textOf(figureNumber("friction", i / 1e6)).size(), std::string("0.000999").size()) << i;
}

TEST(Recipes, SayWhatIsDoneToEveryUnit)
{
    const auto recipe = parse(whole);
    ASSERT_TRUE(recipe) << recipe.error().text();
    EXPECT_EQ(recipe->name, "drive-base rev C");
    EXPECT_EQ(recipe->family->key, "dmc60c");
    EXPECT_EQ(recipe->firmware->file, "dmc60c-1.25.hex");
    EXPECT_TRUE(recipe->parameters->store);
    EXPECT_EQ(recipe->number->first, 10);
    const SelfTest &test = *recipe->test;
    EXPECT_EQ(test.loop, Mode::Velocity);
    EXPECT_EQ(test.to, 4000.0);
    EXPECT_EQ(test.limits.duty, 0.6);
    ASSERT_EQ(test.accept.size(), 4U);
    EXPECT_EQ(test.accept[0].key, "encoder");
    EXPECT_EQ(test.accept[1].low, 0.1);
    EXPECT_EQ(test.accept[3].low, -0.02); // the size of an error counts
}

TEST(Recipes, AreWrittenAsTheyWereRead)
{
    const auto recipe = parse(whole);
    ASSERT_TRUE(recipe);
    const auto again = parse(toText(*recipe));
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(toText(*again), toText(*recipe));
    EXPECT_EQ(again->test->accept.size(), 4U);
}

TEST(Recipes, AreOthersOnceTheyOrAFileThatTheyNameHaveChanged)
{
    const QTemporaryDir folder;
    const auto write = [&folder](const char *name, const QByteArray &text) {
        QFile file(folder.filePath(QString::fromLatin1(name)));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    };
    const auto hash = [&folder] {
        const auto matter = loadRecipe(folder.filePath(QStringLiteral("r.json")).toStdString(), families());
        EXPECT_TRUE(matter) << (matter ? "" : matter.error().text());
        return matter ? matter->hash : std::string();
    };
    write("r.json", R"({"recipe":1,"name":"r","family":"dmc60c","parameters":{"file":"p.json"}})");
    const QByteArray settings = R"({"family":"dmc60c","parameters":{"slot1.d":{"raw":77}}})";
    write("p.json", settings);
    const std::string before = hash();
    EXPECT_EQ(hash(), before);
    write("p.json", QByteArray(settings).replace("77", "78"));
    EXPECT_NE(hash(), before);
    write("p.json", settings);
    EXPECT_EQ(hash(), before);
    write(
        "r.json", R"({"recipe":1,"name":"r","family":"dmc60c","number":{"first":10},"parameters":{"file":"p.json"}})");
    EXPECT_NE(hash(), before) << "what it says itself counts as well";
}

TEST(Recipes, NeedNothingButNameAndFamily)
{
    EXPECT_TRUE(parse(R"({"recipe":1,"name":"look","family":"quadquad2drv"})"));
}

TEST(Recipes, EveryMistakeHasItsLine)
{
    EXPECT_EQ(mistakeIn(whole, "\"first\": 10", "\"frist\": 10"), "line 7: unknown key 'frist'; known are first");
    EXPECT_EQ(mistakeIn(whole, "\"duty\": 0.6", "\"duty\": 1.6"),
        "line 10: 'duty' must be above 0 and at most 1; where it is left out the unit's own limit serves");
    EXPECT_EQ(mistakeIn(whole, "rev C", "rev\\u001b[2J"),
        "line 3: a name has no line break, tabulator or other control character");
    EXPECT_EQ(mistakeIn(whole, "\"duty\": 0.6", "\"duty\": 0"),
        "line 10: 'duty' must be above 0 and at most 1; where it is left out the unit's own limit serves");
    EXPECT_EQ(mistakeIn(whole, "\"travel\": 40000", "\"travel\": 0.0"),
        "line 10: 'travel' must be above 0 and at most 1000000000000; where it is left out the unit's own limit "
        "serves");
    EXPECT_EQ(
        mistakeIn(whole, "\"to\": 4000", "\"to\": 0"), "line 9: there is no way from 0 to itself; give another target");
    EXPECT_EQ(mistakeIn(whole, "\"settle\"", "\"setle\"").substr(0, 28), "line 12: unknown key 'setle'");
    EXPECT_EQ(mistakeIn(whole, "[0.1, 0.4]", "[0.4, 0.1]"),
        "line 14: the limit of 'friction' must be the greatest value, 0 or more, or [least, greatest]");
    EXPECT_EQ(mistakeIn(whole, "\"settle\": 0.6", "\"settle\": -1"),
        "line 12: the limit of 'settle' must be the greatest value, 0 or more, or [least, greatest]");
    EXPECT_EQ(mistakeIn(whole, "\"to\": 4000", "\"to\": 9001"),
        "line 9: speed 9001 is outside the envelope, which ends at 9000; take a smaller step or widen it");
    EXPECT_EQ(mistakeIn(whole, "\"velocity\", \"from\": 0, \"to\": 4000", "\"duty\", \"from\": 0, \"to\": 2"),
        "line 9: duty 2 is outside the envelope, which ends at 0.6; take a smaller step or widen it");
    EXPECT_EQ(
        mistakeIn(whole, "\"encoder\": true", "\"encoder\": 4096"), "line 15: 'encoder' is true: it counts both ways");
    EXPECT_EQ(mistakeIn(whole, "\"dmc60c\"", "\"dmc60\"").substr(0, 31), "line 4: unknown family 'dmc60';");
    EXPECT_EQ(mistakeIn(whole, "\"first\": 10", "\"first\": 64"), "line 7: first: legal is 1 … 63");
    EXPECT_EQ(mistakeIn(whole, "\"first\": 10", "\"first\": \"10\""), "line 7: 'first' must be a number");
    EXPECT_EQ(mistakeIn(whole, "\"velocity\"", "\"torque\"").substr(0, 28), "line 9: unknown loop 'torque");
    EXPECT_EQ(mistakeIn(whole, "\"number\"", "\"name\"").substr(0, 41), "line 7: the key 'name' is there twice");
    EXPECT_EQ(
        mistakeIn(whole, "\"recipe\": 1,", "\"recipe\": 2,").substr(0, 38), "line 2: this is no recipe of version 1");
    EXPECT_EQ(mistakeIn(whole, "\"store\": true", "\"store\": 1"), "line 6: 'store' must be true or false");
    EXPECT_EQ(mistakeIn(whole, "{\"first\": 10},", "{\"first\": 10}").substr(0, 7), "line 8:");
    EXPECT_EQ(mistakeIn("[1]", "1", "2").substr(0, 7), "line 1:");
}

TEST(Recipes, ATargetThatNoUnitOfTheFamilyCanHaveIsAMistake)
{
    const auto mistake = [](const char *family, const char *test) {
        const QByteArray text
            = QByteArray("{\"recipe\":1,\"name\":\"n\",\"family\":\"") + family + "\",\n\"test\":{" + test + "}}";
        const auto parsed = parse(text);
        return parsed ? std::string() : parsed.error().text();
    };
    EXPECT_EQ(
        mistake("dmc60c", "\"loop\":\"velocity\",\n\"to\":1e12").substr(0, 34), "line 3: velocity 1000000000000 is ");
    EXPECT_EQ(mistake("dmc60c", "\"loop\":\"current\",\n\"to\":1e9").substr(0, 26), "line 3: current 1000000000");
    EXPECT_EQ(mistake("dmc60c", "\"loop\":\"current\",\"to\":5,\n\"from\":-101").substr(0, 20), "line 3: current -101");
    EXPECT_EQ(mistake("dmc60c", "\"loop\":\"position\",\n\"to\":1e7").substr(0, 25), "line 3: position 10000000");
    EXPECT_EQ(mistake("abstractdc", "\"loop\":\"velocity\",\n\"to\":1e11").substr(0, 16), "line 3: velocity");
    EXPECT_EQ(mistake("quadquad2drv", "\"loop\":\"velocity\",\n\"to\":100001").substr(0, 16), "line 3: velocity");
    EXPECT_EQ(mistake("dmc60c", "\"loop\":\"velocity\",\"to\":80000"), "");
    EXPECT_EQ(mistake("dmc60c", "\"loop\":\"current\",\"to\":100"), "");
    EXPECT_EQ(mistake("abstractdc", "\"loop\":\"position\",\"to\":2000000"), "");
    EXPECT_EQ(mistake("quadquad2drv", "\"loop\":\"velocity\",\"to\":100000,\"axis\":4"), "");
    EXPECT_EQ(mistake("supermodified", "\"loop\":\"position\",\"to\":2000"), "");
}

TEST(Recipes, TheLineOfAMistakeIsFoundAgain)
{
    const Message mistake = say("unknown key '%1'", "nmae");
    EXPECT_EQ(lineOf(atLine(7, mistake)), 7);
    EXPECT_EQ(lineOf(say("%1: %2", "rev-c.json", atLine(7, mistake))), 7);
    EXPECT_EQ(lineOf(say("%1: %2", "bench", say("%1: %2", "rev-c.json", atLine(12, mistake)))), 12);
    EXPECT_EQ(lineOf(mistake), std::nullopt);
    EXPECT_EQ(lineOf(say("%1: %2", "line 7", mistake)), std::nullopt); // words that only look like it
    EXPECT_EQ(lineOf(Message()), std::nullopt);
}

TEST(Recipes, KnowWhatAFamilyCannotDo)
{
    const char *const via = R"({"recipe":1,"name":"n","family":"supermodified","firmware":{"file":"a.hex"}})";
    const auto needs = parse(via);
    ASSERT_FALSE(needs);
    EXPECT_NE(needs.error().remedy.english().find("avrdude:"), std::string::npos) << needs.error().text();
    const auto no = parse(R"({"recipe":1,"name":"n","family":"supermodified",
"test":{"loop":"position","to":100,
"accept":{"friction":0.5}}})");
    ASSERT_FALSE(no);
    EXPECT_EQ(no.error().detail.english().substr(0, 7), "line 3:");
    const auto keeps = parse(R"({"recipe":1,"name":"n","family":"quadquad2drv",
"parameters":{"file":"a.json","store":true}})");
    ASSERT_FALSE(keeps);
    EXPECT_EQ(keeps.error().text(),
        "line 2: quadquad2drv keeps no setting without power; leave 'store' out: its settings are lost with its "
        "power");
}

TEST(Recipes, WhatMustBeSwitchedOffBeforeItMayBeDrivenIsNotTestedInOneGo)
{
    const QTemporaryDir folder;
    const auto load = [&folder](const char *averaging, const char *test) {
        for (const auto &[name, text] :
            {std::pair(QStringLiteral("p.json"),
                 QByteArray(R"({"family":"abstractdc","parameters":{"current.averaging":{"raw":)") + averaging + "}}}"),
                std::pair(QStringLiteral("r.json"),
                    QByteArray(R"({"recipe":1,"name":"r","family":"abstractdc","parameters":{"file":"p.json"})") + test
                        + "}")}) {
            QFile file(folder.filePath(name));
            EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        }
        return loadRecipe(folder.filePath(QStringLiteral("r.json")).toStdString(), families());
    };
    const char *const test = R"(,"test":{"loop":"velocity","to":2000,"time":0.5})";
    EXPECT_TRUE(load("300", ""));
    const auto most = load("500", test);
    EXPECT_TRUE(most) << most.error().text();
    const auto refused = load("300", test);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_NE(refused.error().text().find("current.averaging"), std::string::npos) << refused.error().text();
}

Visit passedWith(const std::string &unit, double settle)
{
    Visit visit;
    visit.unit = unit;
    visit.outcome = Outcome::Passed;
    visit.test = {{"settle", settle, std::nullopt, 1.0}};
    return visit;
}

TEST(GoldenBand, BeginsAtEightUnitsAndOnlyWarns)
{
    std::vector<Visit> passed;
    for (int i = 0; i < 7; ++i)
        passed.push_back(passedWith("u" + std::to_string(i), 0.40 + 0.01 * i));
    EXPECT_FALSE(bandOf(passed, "settle"));
    passed.push_back(passedWith("u0", 0.40)); // the same unit again
    EXPECT_FALSE(bandOf(passed, "settle"));
    passed.push_back(passedWith("u7", 0.47));
    const auto band = bandOf(passed, "settle");
    ASSERT_TRUE(band);
    EXPECT_NEAR(band->median, 0.435, 1e-9);
    EXPECT_NEAR(band->deviation, 0.02, 1e-9);
    std::vector<TestValue> values{{"settle", 0.50, std::nullopt, 1.0}};
    EXPECT_EQ(markUnusual(values, passed), "settle 500 ms is unusual: 8 units have 375 ms to 495 ms");
    EXPECT_TRUE(values[0].passed);
    EXPECT_TRUE(values[0].unusual);
    values[0].value = 0.49;
    EXPECT_EQ(markUnusual(values, passed), "");
    values[0].value = 0.37;
    EXPECT_NE(markUnusual(values, passed), "");
    EXPECT_TRUE(values[0].unusual) << "too good, too";
    values[0].value.reset();
    EXPECT_EQ(markUnusual(values, passed), "");
}

TEST(GoldenBand, BeginsAtEightUnitsOfOnePlaceToo)
{
    Identity identity;
    identity.family = "abstractdc";
    const std::string place = unitKeyOf(identity, *LinkAddress::parse("socketcan:can0"));
    std::vector<Visit> passed;
    for (int i = 0; i < 8; ++i) {
        passed.push_back(passedWith(place, 0.40 + 0.01 * i));
        passed.back().id = "visit " + std::to_string(i);
    }
    EXPECT_TRUE(bandOf(passed, "settle"));
}

TEST(GoldenBand, IsOfValuesOfUnitsThatPassed)
{
    std::vector<Visit> visits;
    for (int i = 0; i < 8; ++i)
        visits.push_back(passedWith("u" + std::to_string(i), 0.40 + 0.01 * i));
    EXPECT_FALSE(bandOf(visits, "sse")) << "another key";
    visits[3].outcome = Outcome::Failed;
    EXPECT_FALSE(bandOf(visits, "settle"));
    visits.push_back(passedWith("u8", 0.43));
    EXPECT_TRUE(bandOf(visits, "settle"));
    visits[4].test[0].value.reset();
    EXPECT_FALSE(bandOf(visits, "settle"));
    visits.push_back(passedWith("u9", 0.44));
    visits.push_back(passedWith("u10", 0.50));
    const auto odd = bandOf(visits, "settle");
    ASSERT_TRUE(odd);
    EXPECT_EQ(odd->units, 9);
    EXPECT_DOUBLE_EQ(odd->median, 0.44);
}

TEST(SelfTests, AValueOnALimitIsWithinIt)
{
    const Acceptance band{"friction", 0.1, 0.4};
    for (const double within : {0.1, 0.25, 0.4})
        EXPECT_TRUE(judged(band, within).passed) << within;
    for (const double outside : {0.0999, 0.4001})
        EXPECT_FALSE(judged(band, outside).passed) << outside;
    EXPECT_FALSE(judged(band, std::nullopt).passed) << "what was not measured";
    EXPECT_TRUE(judged({"settle", std::nullopt, 0.6}, -5.0).passed);
    EXPECT_TRUE(judged({"encoder", std::nullopt, 1.0}, 1.0).passed);
    EXPECT_FALSE(judged({"encoder", std::nullopt, 1.0}, 0.0).passed);
}

} // namespace
} // namespace mb::service
